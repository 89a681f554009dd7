using System;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public class SceneTest
    {
        [Test]
        public void AToolIsPushed()
        {
            foreach (Mode mode in new[] { Mode.Global, Mode.Descent, Mode.Certified })
            {
                using (Model box = Samples.Box())
                using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2, Mode = mode }))
                {
                    Body wall = scene.Add(box);
                    Body tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.15, 0, 0) });
                    Assert.AreEqual(50, scene.Step().Wrench.Force.X, 1e-9, mode.ToString());
                    tool.Pose = new Pose(1.1, 0, 0);
                    Assert.AreEqual(1.1, tool.Pose.Position.X);
                    Contacts contacts = scene.Step();
                    Assert.AreEqual(100, contacts.Wrench.Force.X, 1e-9, mode.ToString());
                    Assert.AreEqual(wall.Id, contacts.Lmds[0].BodyA);
                    Assert.AreEqual(tool.Id, contacts.Lmds[0].BodyB);
                    Assert.AreEqual(100, scene.Read().Wrench.Force.X, 1e-9);
                    wall.Remove();
                    Assert.AreEqual(0, scene.Step().Lmds.Count);
                }
            }
        }

        [Test]
        public void SettingsTakeEffect()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.05, Stiffness = 1 }))
            {
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                scene.Add(box);
                Assert.AreEqual(0, scene.Step().SetCount);
                scene.SetCutoff(0.2);
                scene.SetStiffness(500);
                scene.SetMode(Mode.Global);
                Assert.AreEqual(50, scene.Step().Wrench.Force.X, 1e-9);
            }
        }

        [Test]
        public void OptionsKeepWhatTheyAreGiven()
        {
            var options = new SceneOptions
            {
                Cutoff = 0.1, Stiffness = 7, Mode = Mode.Descent, GlobalEvery = 3, MaxOverlaps = 5, Space = new Space(1, -3, 2, 0.01)
            };
            Assert.AreEqual(7.0, options.Stiffness);
            Assert.AreEqual(Mode.Descent, options.Mode);
            Assert.AreEqual(3U, options.GlobalEvery);
            Assert.AreEqual(5U, options.MaxOverlaps);
            Assert.AreEqual(2, options.Space.AxisZ);
            Assert.AreEqual(0.01, options.Space.MetresPerUnit);
            var body = new BodyOptions { Stiffness = 4, ReferencePoint = new Vector3d(1, 2, 3), Pose = new Pose(4, 5, 6) };
            Assert.AreEqual(4.0, body.Stiffness);
            Assert.AreEqual(new Vector3d(1, 2, 3), body.ReferencePoint);
            Assert.AreEqual(new Vector3d(4, 5, 6), body.Pose.Position);
            Assert.AreEqual(BodyKind.Static, body.Kind);
        }

        [Test]
        public void ASceneMayHaveAnotherSpace()
        {
            // Z up and centimetres: what lies above is along the third axis.
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 20, Space = new Space(1, -3, 2, 0.01) }))
            {
                scene.Add(box);
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(0, 0, 110) });
                Contacts contacts = scene.Step();
                Assert.AreEqual(100, contacts.Wrench.Force.Z, 1e-6);
                Assert.AreEqual(10, contacts.MinDistance, 1e-9);
            }
        }

        [Test]
        public void AScenesOwnTorquePoint()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2 }))
            {
                scene.Add(box, new BodyOptions { Stiffness = 10 });
                scene.Add(box, new BodyOptions
                {
                    Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0), ReferencePoint = new Vector3d(0, 1, 0)
                });
                Assert.AreEqual(1, scene.Step().Wrench.Torque.Z, 1e-9);
            }
        }

        [Test]
        public void ASceneKeepsItsModels()
        {
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2 }))
            {
                using (Model box = Samples.Box())
                {
                    scene.Add(box);
                    scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                }
                Assert.AreEqual(1, scene.Step().SetCount);
            }
        }

        [Test]
        public void WhatNobodyDisposesIsCollected()
        {
            for (int i = 0; i < 200; ++i)
            {
                var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2 });
                scene.Add(Samples.Box());
                scene.Step();
            }
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
    }
}
