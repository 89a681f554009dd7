// SPDX-License-Identifier: MIT
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>What a surface feels like. Zero is what the scene says.</summary>
    [CreateAssetMenu(menuName = "Palpate/Haptic Material")]
    public sealed class HapticMaterial : ScriptableObject
    {
        [Tooltip("N/m against the tool")]
        [Min(0)]
        public float stiffness;

        [Tooltip("N·s/m of a closing spring")]
        [Min(0)]
        public float damping;

        [Tooltip("Coulomb's coefficient; negative: none")]
        public float friction;
    }
}
