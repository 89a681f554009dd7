using System;
using System.Threading;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public class ServoTest
    {
        private static readonly TimeSpan Longest = TimeSpan.FromSeconds(30);

        [Test]
        public void AServoStepsBesideTheCaller()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2 }))
            {
                scene.Add(box);
                Body tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(2, 0, 0) });
                Assert.IsTrue(!scene.Servo.Running);
                scene.Start(new ServoOptions { Rate = 500, NotRealTime = true });
                Assert.Throws<PalpateWrongStateException>(() => scene.Step());
                Assert.Throws<PalpateWrongStateException>(() => scene.Start());
                Wait(() => scene.Servo.Ticks > 5);
                Assert.IsTrue(scene.Servo.Running);
                Assert.AreEqual(500.0, scene.Servo.WantedRate);
                Assert.AreEqual(0, scene.Servo.Priority);
                tool.Pose = new Pose(1.1, 0, 0);
                Wait(() => Math.Abs(scene.Read().Wrench.Force.X - 100) < 1e-9);
                Assert.IsTrue(scene.Read().Springs.Count > 0);
                scene.Add(box, new BodyOptions { Pose = new Pose(2.2, 0, 0), Stiffness = 500 });
                Wait(() => Math.Abs(scene.Read().Wrench.Force.X - 50) < 1e-9);
                scene.Stop();
                scene.Stop();
                ulong ticks = scene.Servo.Ticks;
                Assert.IsTrue(!scene.Servo.Running && scene.Servo.Work.Max >= scene.Servo.Work.P50);
                Assert.AreEqual(50, scene.Step().Wrench.Force.X, 1e-9);
                Assert.AreEqual(ticks, scene.Servo.Ticks);
            }
        }

        [Test]
        public void WhatIsDisposedStops()
        {
            using (Model box = Samples.Box())
            {
                for (int i = 0; i < 20; ++i)
                {
                    using (var scene = new Scene(new SceneOptions { Cutoff = 0.2 }))
                    {
                        scene.Add(box, new BodyOptions { Kind = BodyKind.Tool });
                        scene.Start();
                    }
                }
            }
        }

        [Test]
        public void AllStopAtOnce()
        {
            using (var first = new Scene(new SceneOptions { Cutoff = 0.2 }))
            using (var second = new Scene(new SceneOptions { Cutoff = 0.2 }))
            {
                first.Start();
                second.Start();
                Library.ShutDownAll();
                Library.ShutDownAll();
                Assert.IsTrue(!first.Servo.Running && !second.Servo.Running);
                first.Start();
                Assert.IsTrue(first.Servo.Running);
            }
        }

        [Test]
        public void WallsAndSpringsAreTold()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Cutoff = 0.2 }))
            {
                scene.Add(box);
                Body tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0), Damping = 1, Friction = 0.3 });
                Assert.AreEqual(Status.None, scene.Step().Status);
                double sum = 0;
                foreach (Contact spring in scene.Read().Springs)
                {
                    sum += spring.Force.X;
                }
                Assert.AreEqual(scene.Read().Wrench.Force.X, sum, 1e-9);
                for (int i = 1; i <= 30; ++i)
                {
                    tool.Pose = new Pose(1.1 - 0.005 * i, 0, 0);
                    scene.Step();
                }
                Assert.AreEqual(Status.Wall, scene.Read().Status);
                Assert.IsTrue(scene.Read().Overlap && scene.Read().Wrench.Force.X > 0);
            }
        }

        private static void Wait(Func<bool> until)
        {
            DateTime end = DateTime.UtcNow + Longest;
            while (!until())
            {
                Assert.IsTrue(DateTime.UtcNow < end, "it does not happen");
                Thread.Sleep(1);
            }
        }
    }
}
