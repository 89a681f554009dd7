using System;
using System.IO;
using System.Linq;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace Palpate.Unity.Tests
{
    [TestFixture]
    public class SessionTest
    {
        [Test]
        public void ThreePlaySessionsLeaveNothingBehind()
        {
            int threads = Threads.Count();
            for (int session = 0; session < 3; ++session)
            {
                Stage.Begin(typeof(PalpateScene).Assembly);
                PalpateScene scene = Play.Scene(servo: true);
                HapticBody body = Play.Body<HapticBody>(scene, Vector3.zero);
                HapticTool tool = Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
                Play.FramesUntil(() => Math.Abs(scene.Force.x - 50) < 1e-3);
                Assert.IsTrue(scene.Servo.Running);
                Assert.AreEqual(body.Id, scene.GetContact(0).BodyA);
                Assert.AreEqual(tool.Id, scene.GetContact(0).BodyB);
                tool.transform.position = new Vector3(3, 0, 0);
                Play.FramesUntil(() => scene.ContactCount == 0);
                Stage.End();
                Assert.IsTrue(!body.IsAdded && !tool.IsAdded && scene.Native == null);
                Assert.AreEqual(threads, Threads.Settled(threads), "of session " + session);
            }
            Assert.AreEqual("", string.Join("; ", Debug.Errors));
        }

        [Test]
        public void ASessionThatWasCutOffIsForgotten()
        {
            int threads = Threads.Count();
            Stage.Begin(typeof(PalpateScene).Assembly);
            Play.Scene(servo: true);
            // Nobody disables anything; the next session begins all the same.
            Stage.Objects.Clear();
            Stage.Begin(typeof(PalpateScene).Assembly);
            Assert.AreEqual(threads, Threads.Settled(threads));
            PalpateScene scene = Play.Scene();
            Play.Body<HapticBody>(scene, Vector3.zero);
            Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            Play.Frames(2);
            Assert.AreEqual(50, scene.Force.x, 1e-3);
            Stage.End();
        }

        [Test]
        public void BodiesMayComeBeforeTheirSceneAndChangeIt()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene();
            scene.gameObject.SetActive(false);
            HapticBody loose = new GameObject().AddComponent<HapticBody>();
            Assert.IsTrue(!loose.IsAdded);
            loose.gameObject.SetActive(false);
            loose.mesh = Stage.Octahedron;
            loose.gameObject.SetActive(true);
            HapticTool tool = Play.Body<HapticTool>(scene, new Vector3(0, 1.1f, 0));
            scene.gameObject.SetActive(true);
            Play.Frames(2);
            Assert.IsTrue(loose.IsAdded && tool.IsAdded && ReferenceEquals(scene.Tool, tool));
            Assert.AreEqual(50, scene.Force.y, 1e-3);
            loose.gameObject.SetActive(false);
            Play.Frames(1);
            Assert.AreEqual(0, scene.ContactCount);
            loose.gameObject.SetActive(true);
            scene.stiffness = 1000;
            Stage.Validate(scene);
            Play.Frames(1);
            Assert.AreEqual(100, scene.Force.y, 1e-3);
            scene.gameObject.SetActive(false);
            Assert.AreEqual(0, scene.ContactCount);
            Assert.AreEqual(0, scene.Force.magnitude, 0);
            Stage.End();
        }

        [Test]
        public void MaterialsAreFelt()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene();
            HapticBody body = Play.Body<HapticBody>(scene, Vector3.zero);
            body.gameObject.SetActive(false);
            body.material = new HapticMaterial { stiffness = 250 };
            body.gameObject.SetActive(true);
            Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            Play.Frames(2);
            Assert.AreEqual(25, scene.Force.x, 1e-3);
            Stage.End();
        }

        [Test]
        public void AFileIsTouchedAsItsImportedMeshWouldBe()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            Application.streamingAssetsPath = Environment.GetEnvironmentVariable("PALPATE_TEST_MODELS");
            PalpateScene scene = Play.Scene();
            HapticBody file = new GameObject().AddComponent<HapticBody>();
            file.gameObject.SetActive(false);
            file.gltfFile = "torus.glb";
            file.gameObject.SetActive(true);
            Play.Body<HapticTool>(scene, Vector3.zero, 0.01f * Vector3.one);
            Play.Frames(2);
            Assert.IsTrue(file.IsAdded && scene.ContactCount > 0);
            Stage.End();
        }

        [Test]
        public void WhatIsWrongIsToldAndTheRestGoesOn()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            Debug.Errors.Clear();
            PalpateScene scene = Play.Scene();
            new GameObject { name = "empty" }.AddComponent<HapticBody>();
            Play.Body<HapticBody>(scene, Vector3.zero);
            Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            Play.Body<HapticTool>(scene, new Vector3(-1.1f, 0, 0));
            var device = new GameObject { name = "nothing" };
            device.SetActive(false);
            device.AddComponent<HapticDevice>().uri = "sim:nothing";
            device.SetActive(true);
            Play.Frames(2);
            Assert.AreEqual(50, scene.Force.x, 1e-3);
            Assert.AreEqual("empty HapticTool nothing", string.Join(" ", Debug.Errors.Select(text => text.Split(':')[0])));
            Assert.IsTrue(!device.GetComponent<HapticDevice>().IsOpen);
            Debug.Errors.Clear();
            Stage.End();
        }

        [Test]
        public void ADeviceMovesTheTool()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene(servo: true);
            HapticTool tool = Play.Body<HapticTool>(scene, new Vector3(0, 0.25f, 0));
            var held = new GameObject { name = "device" };
            held.SetActive(false);
            HapticDevice device = held.AddComponent<HapticDevice>();
            device.keepToolPose = false;
            device.hand = HandScript.Circle;
            device.period = 0.2f;
            held.transform.position = new Vector3(5, 0, 0);
            held.SetActive(true);
            device.Arm();
            Play.FramesUntil(() => tool.transform.position.x > 4);
            float left = float.MaxValue;
            float right = float.MinValue;
            Play.FramesUntil(() =>
            {
                left = Math.Min(left, tool.transform.position.x);
                right = Math.Max(right, tool.transform.position.x);
                return right - left > 0.02f && device.State.Safety == Safety.Armed;
            });
            held.SetActive(false);
            Assert.IsTrue(!device.IsOpen);
            tool.transform.position = new Vector3(1, 2, 3);
            Play.Frames(2);
            Assert.AreEqual(1.0f, tool.transform.position.x, "it follows its transform again");
            Stage.End();
        }

        [Test]
        public void ASessionIsRecorded()
        {
            string path = Path.Combine(Path.GetTempPath(), "palpate_" + Guid.NewGuid() + ".trace");
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene(servo: true);
            Play.Body<HapticBody>(scene, Vector3.zero);
            Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            scene.StartRecording(path);
            Play.FramesUntil(() => Math.Abs(scene.Force.x - 50) < 1e-3);
            Recording recording = scene.StopRecording();
            Assert.Throws<PalpateWrongStateException>(() => scene.StopRecording());
            scene.enabled = false;
            Assert.Throws<InvalidOperationException>(() => scene.StartRecording(path));
            Stage.End();
            using (Trace trace = Trace.Open(path))
            {
                Assert.AreEqual(recording.Ticks, trace.Count);
                Assert.AreEqual(-1, trace.Space.AxisX, "in the space of Unity");
                Assert.AreEqual(50, trace[trace.Count - 1].Wrench.Force.X, 1e-3);
            }
            File.Delete(path);
        }

        [Test]
        public void TheSampleRuns()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            var sample = new GameObject { name = "sample" };
            sample.AddComponent<TouchSample>();
            Debug.Messages.Clear();
            Play.FramesUntil(() => sample.GetComponent<PalpateScene>()?.Force.magnitude > 0.1f);
            Play.FramesUntil(() => Debug.Messages.Count > 1);
            Stage.End();
            Assert.AreEqual("", string.Join("; ", Debug.Errors));
        }

        [Test]
        public void FramesAllocateNothingOfTheirOwn()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene();
            Play.Body<HapticBody>(scene, Vector3.zero);
            HapticTool tool = Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
            var update = (Action)Delegate.CreateDelegate(typeof(Action), scene, typeof(PalpateScene).GetMethod(
                "Update", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic));
            long before = 0;
            for (int i = 0; i <= 1000; ++i)
            {
                tool.transform.position = new Vector3(1.1f + 1e-5f * i, 0, 0);
                update();
                before = i == 0 ? GC.GetAllocatedBytesForCurrentThread() : before;
            }
            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.AreEqual(0L, allocated);
            Stage.End();
        }
    }
}
