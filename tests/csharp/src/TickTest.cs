using System;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>Many ticks: their results, what they allocate, and what a call costs.</summary>
    [TestFixture]
    public unsafe class TickTest
    {
        private readonly struct Tick
        {
            internal readonly Pose Pose;
            internal readonly int SetCount;
            internal readonly double MinDistance;
            internal readonly Wrench Wrench;

            internal Tick(Reference reference)
            {
                Pose = reference.Pose();
                SetCount = reference.Count();
                MinDistance = reference.Double();
                Wrench = reference.Wrench();
            }
        }

        [Test]
        public void WrenchesEqualThoseOfCBitForBitAndNothingIsAllocated()
        {
            using (var reference = new Reference())
            using (Model body = Model.Load(Samples.ModelPath("torus.glb")))
            using (Model tool = Model.Load(Samples.ModelPath("organic_2200.glb")))
            {
                reference.SkipQueries();
                int most = 0;
                foreach (Mode mode in new[] { Mode.Global, Mode.Descent, Mode.Certified })
                {
                    var ticks = new Tick[reference.Count()];
                    for (int i = 0; i < ticks.Length; ++i)
                    {
                        ticks[i] = new Tick(reference);
                    }
                    most = Math.Max(most, ticks.Length);
                    using (var scene = new Scene(new SceneOptions { Cutoff = reference.Cutoff, Mode = mode }))
                    {
                        scene.Add(body);
                        RequireSame(scene, scene.Add(tool, new BodyOptions { Kind = BodyKind.Tool }), ticks, mode);
                    }
                }
                Assert.IsTrue(reference.AtEnd);
                Assert.IsTrue(most >= 10000);
            }
        }

        [Test]
        public void QueriesAllocateNothing()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            {
                var options = new QueryOptions { Cutoff = 0.2 };
                double force = 0;
                long before = 0;
                for (int i = 0; i <= 1000; ++i)
                {
                    force += result.Search(box, box, new Pose(1.1, 0, 0), options).Wrench.Force.X;
                    // What runs for the first time is compiled.
                    before = i == 0 ? GC.GetAllocatedBytesForCurrentThread() : before;
                }
                long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.AreEqual(0L, allocated);
                Assert.AreEqual(100100, force, 1e-6);
            }
        }

        [Test]
        public void AnAllocationWouldBeSeen()
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            object small = new object();
            Assert.IsTrue(GC.GetAllocatedBytesForCurrentThread() > before);
            GC.KeepAlive(small);
        }

        [Test]
        public void CallsAreTimed()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Cutoff = 0.2 }))
            {
                Body tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool });
                double force = 0;
                double call = Nanoseconds(() => Raw.plp_version());
                double raw = Nanoseconds(() => Raw.plp_scene_step(scene.Handle));
                double step = Nanoseconds(() => force += scene.Step().Wrench.Force.X);
                double tick = Nanoseconds(() =>
                {
                    tool.Pose = Pose.Identity;
                    force += scene.Step().Wrench.Force.X;
                });
                Assert.AreEqual(0.0, force);
                Console.WriteLine("ns: a call {0:F0}; alone in a scene, the step of C {1:F0}, Step and Wrench {2:F0}, " +
                                  "Pose, Step and Wrench {3:F0}; of its own {4:F0} a step", call, raw, step, tick, step - raw);
            }
        }

        private static void RequireSame(Scene scene, Body tool, Tick[] ticks, Mode mode)
        {
            int different = 0, touching = 0;
            // What runs for the first time is compiled.
            different += Run(scene, tool, ref ticks[0]) ? 0 : 1;
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 1; i < ticks.Length; ++i)
            {
                different += Run(scene, tool, ref ticks[i]) ? 0 : 1;
                touching += ticks[i].SetCount > 0 ? 1 : 0;
            }
            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.AreEqual(0, different, mode.ToString());
            Assert.AreEqual(0L, allocated, mode.ToString());
            Assert.IsTrue(touching > 100, touching + " ticks with contacts");
        }

        private static bool Run(Scene scene, Body tool, ref Tick tick)
        {
            tool.Pose = tick.Pose;
            Contacts contacts = scene.Step();
            double nearest = double.PositiveInfinity;
            foreach (Contact contact in contacts.Lmds)
            {
                nearest = Math.Min(nearest, contact.Distance);
            }
            return Reference.Same(tick.Wrench, contacts.Wrench) && Reference.Same(tick.MinDistance, contacts.MinDistance) &&
                   tick.SetCount == contacts.SetCount && Reference.Same(nearest, tick.MinDistance);
        }

        /// <summary>Of the quickest batch, which other work of the machine disturbed least.</summary>
        private static double Nanoseconds(Action action)
        {
            const int Batches = 100;
            const int Calls = 1000;
            double least = double.PositiveInfinity;
            for (int batch = 0; batch < Batches; ++batch)
            {
                long start = DateTime.UtcNow.Ticks;
                for (int i = 0; i < Calls; ++i)
                {
                    action();
                }
                least = Math.Min(least, (DateTime.UtcNow.Ticks - start) * 100.0 / Calls);
            }
            return least;
        }
    }
}
