// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Threading;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>Hosts such as Unity load and unload the domain of a user's code while the process, and with it the native
    /// library, goes on. Only Mono has domains.</summary>
    [TestFixture]
    public class DomainTest
    {
        /// <summary>What a user's code does, and leaves behind.</summary>
        public sealed class Session : MarshalByRefObject
        {
            private static int messages;
            private Scene scene;

            public double Play()
            {
                Log.SetReceiver((level, message) => ++messages);
                int[] inward = (int[])Samples.BoxIndices.Clone();
                Array.Reverse(inward);
                Model box = Model.FromTriangles(Samples.BoxPositions, inward);
                scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.2 });
                scene.Add(box);
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                return scene.Step().Wrench.Force.X;
            }

            /// <summary>Leaves a servo running that holds a device.</summary>
            public bool Run()
            {
                scene.SetDevice(Device.Open());
                scene.Start();
                return scene.Servo.Running;
            }

            public int Messages() => messages;
        }

        [Test]
        public void DomainsUnloadWhileTheirScenesLive()
        {
            for (int i = 0; i < 3; ++i)
            {
                AppDomain domain = NewDomain();
                var session = (Session)domain.CreateInstanceFromAndUnwrap(
                    typeof(Session).Assembly.Location, typeof(Session).FullName);
                Assert.AreEqual(100, session.Play(), 1e-9);
                Assert.IsTrue(session.Messages() > 0);
                Assert.IsTrue(session.Run());
                Unload(domain);
                // There is something to say about it, and nobody left to hear it.
                LoadBadly();
            }
        }

        private static AppDomain NewDomain() => AppDomain.CreateDomain(
            "session", null, new AppDomainSetup { ApplicationBase = Path.GetDirectoryName(typeof(Session).Assembly.Location) });

        /// <summary>A domain that cannot be unloaded hangs for ever.</summary>
        private static void Unload(AppDomain domain)
        {
            var thread = new Thread(() => AppDomain.Unload(domain)) { IsBackground = true };
            thread.Start();
            Assert.IsTrue(thread.Join(TimeSpan.FromSeconds(60)), "the domain does not unload");
        }

        private static void LoadBadly()
        {
            int[] inward = (int[])Samples.BoxIndices.Clone();
            Array.Reverse(inward);
            using (Model.FromTriangles(Samples.BoxPositions, inward))
            {
            }
        }
    }
}
