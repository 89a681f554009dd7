using System;
using System.IO;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace Palpate.Unity.Tests
{
    /// <summary>Where a play session reloads the domain, the old one must unload although a servo runs.</summary>
    [TestFixture]
    public class ReloadTest
    {
        public sealed class Session : MarshalByRefObject
        {
            public float Play()
            {
                Stage.Begin(typeof(PalpateScene).Assembly);
                PalpateScene scene = Tests.Play.Scene(servo: true);
                Tests.Play.Body<HapticBody>(scene, Vector3.zero);
                Tests.Play.Body<HapticTool>(scene, new Vector3(1.1f, 0, 0));
                Tests.Play.FramesUntil(() => scene.Force.x > 1);
                return scene.Force.x;
            }
        }

        [Test]
        public void DomainsUnloadInTheMiddleOfASession()
        {
            for (int i = 0; i < 3; ++i)
            {
                AppDomain domain = AppDomain.CreateDomain("session", null, new AppDomainSetup
                {
                    ApplicationBase = Path.GetDirectoryName(typeof(Session).Assembly.Location)
                });
                var session = (Session)domain.CreateInstanceFromAndUnwrap(
                    typeof(Session).Assembly.Location, typeof(Session).FullName);
                Assert.AreEqual(50, session.Play(), 1e-3);
                // One that cannot be unloaded hangs for ever.
                var thread = new Thread(() => AppDomain.Unload(domain)) { IsBackground = true };
                thread.Start();
                Assert.IsTrue(thread.Join(TimeSpan.FromSeconds(60)), "the domain does not unload");
            }
        }
    }
}
