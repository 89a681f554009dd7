using System;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>A cube in a simulated hand above a cube.</summary>
    [TestFixture]
    public class DeviceTest
    {
        private const double Gap = 0.005;

        [Test]
        public void DevicesAreListed()
        {
            DeviceInfo[] devices = Device.List();
            Assert.IsTrue(devices.Length >= 2);
            Assert.IsTrue(Array.Exists(devices, info => info.Uri == "sim:premium6dof"));
            using (Device touch = Device.Open("sim:touch"))
            {
                Assert.AreEqual("sim:touch", touch.Info.Uri);
                Assert.AreEqual(7U, touch.Info.Actuated, "a Touch has no torque");
                Assert.AreEqual(0.0, touch.Info.MaxTorque);
                Assert.AreEqual(Condition.Ready, touch.Info.Condition);
                Assert.AreEqual("ready", touch.Info.Status);
                Assert.AreEqual(Condition.Ready, touch.State.Condition);
                Assert.Throws<PalpateUnsupportedException>(() => touch.Calibrate());
                Assert.IsTrue(touch.Info.MaxForce > 1 && touch.Info.Name.Length > 0);
                Assert.IsTrue(touch.Info.WorkspaceMin.X < touch.Info.WorkspaceMax.X);
            }
            Assert.Throws<PalpateDeviceException>(() => Device.Open("sim:nothing"));
        }

        [Test]
        public void TheHandIsLifted()
        {
            using (Device device = Device.Open())
            using (Scene scene = Floor(out Body tool))
            {
                scene.SetDevice(device);
                device.Arm();
                Step(scene, 1500);
                DeviceState state = device.State;
                Assert.AreEqual(Safety.Armed, state.Safety);
                Assert.AreEqual(1.0, state.Gain);
                Assert.AreEqual(1500UL, state.Ticks);
                Assert.IsTrue(state.Calibrated);
                Assert.AreEqual(Limiters.None, state.Limiters);
                Assert.IsTrue(state.TicksOf(Limiters.Ramp) > 500);
                Assert.IsTrue(state.Applied.Force.Y > 0.1, state.Applied.ToString());
                Assert.AreEqual(state.Commanded.Force.Y, state.Applied.Force.Y);
                Assert.AreEqual(tool.Pose.Position.Y, state.Pose.Position.Y);
                Assert.Throws<ArgumentException>(() => state.TicksOf(Limiters.Ramp | Limiters.PoseJump));
                device.Disarm();
                Step(scene, 1);
                Assert.AreEqual(0.0, device.State.Applied.Force.Y);
                double height = tool.Pose.Position.Y;
                scene.SetDevice(null);
                Step(scene, 10);
                Assert.AreEqual(height, tool.Pose.Position.Y);
                Assert.AreEqual(1501UL, device.State.Ticks);
            }
        }

        [Test]
        public void TheHandDoesWhatItIsTold()
        {
            using (Device device = Device.Open())
            using (Scene scene = Floor(out Body tool))
            {
                scene.SetDevice(device, new DeviceMapping { MotionScale = 2, SceneFromBase = new Pose(0, 0.5, 0) });
                device.SetHand(new Hand
                {
                    Grip = Grip.Firm, Script = HandScript.Circle, Travel = 0.02, Period = 0.5,
                    Into = new Vector3d(0, 0, -1), Along = new Vector3d(1, 0, 0)
                });
                Step(scene, 400);
                Assert.IsTrue(Math.Abs(device.State.LinearVelocity.X) + Math.Abs(device.State.LinearVelocity.Y) > 0.05);
                Assert.AreEqual(0.5 + 2 * device.State.Pose.Position.Y, tool.Pose.Position.Y, 1e-12);
                device.SetHandPoses(new double[] { 0, 1 }, new[] { new Pose(0, 0.01, 0), new Pose(0, 0.01, 0) });
                Step(scene, 1000);
                Assert.AreEqual(0.01, device.State.Pose.Position.Y, 1e-3);
                Assert.Throws<ArgumentException>(() => device.SetHandPoses(new double[2], new Pose[1]));
                Assert.Throws<PalpateInvalidArgumentException>(() => device.SetHand(new Hand { Period = double.NaN }));
            }
        }

        [Test]
        public void LimitsAreTightened()
        {
            using (Device device = Device.Open())
            using (Scene scene = Floor(out Body tool))
            {
                scene.SetStiffness(800);
                scene.SetDevice(device);
                device.SetLimits(new SafetyLimits { MaxForce = 0.25 });
                device.Arm();
                Step(scene, 1500);
                Assert.AreEqual(0.25, Length(device.State.Applied.Force), 1e-9);
                Assert.IsTrue(device.State.Limiters.HasFlag(Limiters.ForceClamp));
                Assert.Throws<PalpateInvalidArgumentException>(() => device.SetLimits(new SafetyLimits { MaxForce = 1e3 }));
                Assert.Throws<ArgumentNullException>(() => device.SetLimits(null));
                Assert.Throws<ArgumentNullException>(() => device.SetHand(null));
            }
        }

        [Test]
        public void WhatIsDisposedIsRefused()
        {
            Device device = Device.Open();
            using (Scene scene = Floor(out Body tool))
            {
                scene.SetDevice(device);
                device.Dispose();
                device.Dispose();
                Assert.Throws<ObjectDisposedException>(() => device.Arm());
                Assert.Throws<ObjectDisposedException>(() => scene.SetDevice(device));
                Step(scene, 1);
            }
        }

        [Test]
        public void StatesAllocateNothing()
        {
            using (Device device = Device.Open())
            using (Scene scene = Floor(out Body tool))
            {
                scene.SetDevice(device);
                device.Arm();
                double sum = 0;
                long before = 0;
                for (int i = 0; i <= 1000; ++i)
                {
                    scene.Step();
                    sum += device.State.Applied.Force.Y + scene.Servo.Rate;
                    before = i == 0 ? GC.GetAllocatedBytesForCurrentThread() : before;
                }
                long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.AreEqual(0L, allocated);
                Assert.IsTrue(sum > 0);
            }
        }

        private static Scene Floor(out Body tool)
        {
            var scene = new Scene(new SceneOptions { Cutoff = 2 * Gap, Stiffness = 200 });
            using (Model box = Samples.Box())
            {
                scene.Add(box, new BodyOptions { Pose = new Pose(0, -1 - Gap, 0) });
                tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool });
            }
            return scene;
        }

        private static void Step(Scene scene, int count)
        {
            for (int i = 0; i < count; ++i)
            {
                scene.Step();
            }
        }

        private static double Length(Vector3d v) => Math.Sqrt(v.X * v.X + v.Y * v.Y + v.Z * v.Z);
    }
}
