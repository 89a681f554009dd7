using System;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Palpate.Unity.Tests
{
    [TestFixture]
    public class EditorTest
    {
        private static readonly Assembly Package = Assembly.Load("Palpate.Haptics.Editor");

        [Test]
        public void TheInspectorPlotsTheForce()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene();
            Play.Body<HapticBody>(scene, Vector3.zero);
            Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            UnityEditor.Editor inspector = InspectorOf(scene);
            Play.Frames(2);
            EditorGUILayout.Labels.Clear();
            inspector.OnInspectorGUI();
            Assert.IsTrue(EditorGUILayout.Labels.Contains("Contacts: 1"), string.Join("; ", EditorGUILayout.Labels));
            Assert.IsTrue(EditorGUILayout.Labels.Exists(label => label.StartsWith("Force 50.000 N")));
            Assert.IsTrue(inspector.RequiresConstantRepaint());
            Gizmos.Drawn = 0;
            Play.Frames(1);
            Assert.AreEqual(3, Gizmos.Drawn);
            Stage.End();
            EditorGUILayout.Labels.Clear();
            inspector.OnInspectorGUI();
            Assert.AreEqual(0, EditorGUILayout.Labels.Count, "nothing is felt outside of play");
        }

        [Test]
        public void ThePlotHasTheNewestAtTheRight()
        {
            object plot = Activator.CreateInstance(Package.GetType("Palpate.Unity.Editor.ForcePlot", true),
                BindingFlags.Instance | BindingFlags.NonPublic, null, new object[] { 4 }, null);
            foreach (float value in new[] { 9f, 1f, 2f, 3f, 4f })
            {
                Call(plot, "Add", value);
            }
            Call(plot, "Draw", new Rect { x = 10, y = 20, width = 300, height = 40 }, Color.red);
            Assert.AreEqual("10 110 210 310", string.Join(" ", Handles.Line.Select(point => point.x.ToString())));
            Assert.AreEqual("50 40 30 20", string.Join(" ", Handles.Line.Select(point => point.y.ToString())));
        }

        [Test]
        public void TheDeviceIsArmedByAButton()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene();
            Play.Body<HapticTool>(scene, Vector3.zero);
            HapticDevice device = new GameObject().AddComponent<HapticDevice>();
            UnityEditor.Editor inspector = InspectorOf(device);
            GUILayout.Press = true;
            inspector.OnInspectorGUI();
            GUILayout.Press = false;
            Play.Frames(2);
            inspector.OnInspectorGUI();
            Assert.AreEqual(Safety.Ramping, device.State.Safety);
            Assert.IsTrue(EditorGUILayout.Labels.Last().Contains("Ramping"), EditorGUILayout.Labels.Last());
            GUILayout.Press = true;
            inspector.OnInspectorGUI();
            GUILayout.Press = false;
            Play.Frames(1);
            Assert.AreEqual(Safety.Disarmed, device.State.Safety);
            Stage.End();
        }

        [Test]
        public void ReloadingCodeEndsNativeThreads()
        {
            RuntimeHelpers.RunClassConstructor(Package.GetType("Palpate.Unity.Editor.ReloadGuard", true).TypeHandle);
            int threads = Threads.Count();
            foreach (Action end in new Action[] { AssemblyReloadEvents.Reload, EditorApplication.Quit })
            {
                Stage.Begin(typeof(PalpateScene).Assembly);
                PalpateScene scene = Play.Scene(servo: true);
                Assert.AreEqual(threads + 2, Threads.Settled(threads + 2));
                end();
                Assert.AreEqual(threads, Threads.Settled(threads));
                Assert.IsTrue(!scene.Servo.Running);
                Stage.End();
            }
        }

        private static UnityEditor.Editor InspectorOf(UnityEngine.Object target)
        {
            Type type = Package.GetTypes().Single(
                found => found.GetCustomAttribute<CustomEditorAttribute>()?.Inspected == target.GetType());
            var inspector = (UnityEditor.Editor)Activator.CreateInstance(type, true);
            inspector.target = target;
            return inspector;
        }

        private static void Call(object target, string method, params object[] arguments) => target.GetType()
            .GetMethod(method, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(target, arguments);
    }
}
