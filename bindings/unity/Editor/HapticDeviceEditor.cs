// SPDX-License-Identifier: MIT
using UnityEditor;
using UnityEngine;

namespace Palpate.Unity.Editor
{
    /// <summary>Arms and disarms, and tells what holds the force back.</summary>
    [CustomEditor(typeof(HapticDevice))]
    internal sealed class HapticDeviceEditor : UnityEditor.Editor
    {
        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var device = (HapticDevice)target;
            if (!Application.isPlaying || !device.IsOpen)
            {
                return;
            }
            DeviceState state = device.State;
            EditorGUILayout.LabelField(device.Info.Name, $"{state.Safety}, gain {state.Gain:F2}, limiters: {state.Limiters}");
            if (GUILayout.Button(state.Safety == Safety.Disarmed ? "Arm: hand on the handle, face away" : "Disarm"))
            {
                if (state.Safety == Safety.Disarmed)
                {
                    device.Arm();
                }
                else
                {
                    device.Disarm();
                }
            }
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying;
    }
}
