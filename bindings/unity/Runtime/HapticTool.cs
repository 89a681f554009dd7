// SPDX-License-Identifier: MIT
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>The body that the hand moves; a scene has at most one. In a device's hand its transform follows the device;
    /// otherwise the tool follows its transform.</summary>
    [AddComponentMenu("Palpate/Haptic Tool")]
    public sealed class HapticTool : HapticBody
    {
        [Tooltip("In the tool's own frame, units of the scene: torques are about it")]
        public Vector3 referencePoint;

        private bool inHand;

        protected override BodyKind Kind => BodyKind.Tool;

        internal override BodyOptions Options()
        {
            BodyOptions options = base.Options();
            options.ReferencePoint = Conversion.ToPalpate(referencePoint);
            return options;
        }

        internal void PutInHand(bool held) => inHand = held;

        internal override void Forget()
        {
            base.Forget();
            inHand = false;
        }

        internal override void Follow()
        {
            if (!inHand)
            {
                base.Follow();
                return;
            }
            Pose pose = NativePose;
            transform.SetPositionAndRotation(Conversion.ToUnity(pose.Position), Conversion.ToUnity(pose.Orientation));
            transform.hasChanged = false;
        }
    }
}
