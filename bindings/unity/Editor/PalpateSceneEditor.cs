// SPDX-License-Identifier: MIT
using UnityEditor;
using UnityEngine;

namespace Palpate.Unity.Editor
{
    /// <summary>While it plays: what the tool feels, over the last frames, and how the servo runs.</summary>
    [CustomEditor(typeof(PalpateScene))]
    internal sealed class PalpateSceneEditor : UnityEditor.Editor
    {
        private const int Frames = 300;
        private const float PlotHeight = 60;

        private readonly ForcePlot force = new ForcePlot(Frames);
        private readonly ForcePlot torque = new ForcePlot(Frames);

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var scene = (PalpateScene)target;
            if (!Application.isPlaying || scene.Native == null)
            {
                return;
            }
            force.Add(scene.Force.magnitude);
            torque.Add(scene.Torque.magnitude);
            EditorGUILayout.LabelField("Contacts", scene.Overlap ? $"{scene.ContactCount}, overlapping" : $"{scene.ContactCount}");
            Plot(force, Color.cyan, $"Force {scene.Force.magnitude:F3} N, at most {force.Largest:F3} N");
            Plot(torque, Color.yellow, $"Torque {scene.Torque.magnitude:F4} N·m, at most {torque.Largest:F4} N·m");
            ServoState servo = scene.Servo;
            EditorGUILayout.LabelField("Servo", servo.Running
                ? $"{servo.Rate:F0} Hz, p99 {servo.Work.P99:F0} µs, {servo.Missed} of {servo.Ticks} missed" : "rests");
        }

        public override bool RequiresConstantRepaint() => Application.isPlaying;

        private static void Plot(ForcePlot plot, Color colour, string title)
        {
            EditorGUILayout.LabelField(title);
            plot.Draw(GUILayoutUtility.GetRect(0, PlotHeight, GUILayout.ExpandWidth(true)), colour);
        }
    }
}
