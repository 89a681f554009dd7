using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>Recorded, read, replayed.</summary>
    [TestFixture]
    public class TraceTest
    {
        private const int Steps = 60;
        private static readonly Space Centimetres = new Space(1, -3, 2, 0.01);

        /// <summary>What the scene told while it was recorded.</summary>
        private sealed class Told
        {
            internal readonly List<Wrench> Wrenches = new List<Wrench>();
            internal readonly List<double> Distances = new List<double>();
            internal readonly List<Vector3d> Points = new List<Vector3d>();
            internal ulong Wall;
            internal ulong Tool;

            internal void Add(Contacts contacts)
            {
                Wrenches.Add(contacts.Wrench);
                Distances.Add(contacts.MinDistance);
                foreach (Contact contact in contacts.Lmds)
                {
                    Points.Add(contact.PointA);
                }
            }
        }

        private static SceneOptions Options(Mode mode) => new SceneOptions
        {
            Cutoff = 20, Stiffness = 500, Damping = 2, Friction = 0.1, Mode = mode, Space = Centimetres
        };

        private static Pose PoseAt(int step) =>
            new Pose(new Vector3d(125 - 0.2 * step, 1, 0.1 * step), new Quaterniond(0.002 * step, 0.2, 0, 1));

        /// <summary>A tool that comes near a wall, which is moved and made softer meanwhile.</summary>
        private static Told Record(string path, Model box, Mode mode)
        {
            var told = new Told();
            using (var scene = new Scene(Options(mode)))
            {
                Body wall = scene.Add(box, new BodyOptions { Stiffness = 600 });
                Body tool = scene.Add(
                    box, new BodyOptions { Kind = BodyKind.Tool, ReferencePoint = new Vector3d(30, 10, 70) });
                Body lamp = scene.Add(box, new BodyOptions { Intangible = true, Pose = new Pose(900, 0, 0) });
                told.Wall = wall.Id;
                told.Tool = tool.Id;
                scene.Record(path);
                Assert.IsTrue(scene.Recording.Running);
                for (int i = 0; i < Steps; ++i)
                {
                    tool.Pose = PoseAt(i);
                    if (i == 30)
                    {
                        wall.Pose = new Pose(0.5, 0, 0);
                        scene.SetDamping(3);
                        lamp.Remove();
                    }
                    told.Add(scene.Step());
                }
                Recording recording = scene.StopRecording();
                Assert.AreEqual($"False {Steps} 0", $"{recording.Running} {recording.Ticks} {recording.Lost}");
                Assert.AreEqual(new FileInfo(path).Length, recording.Bytes);
                Assert.IsTrue(!scene.Recording.Running);
            }
            Assert.IsTrue(told.Points.Count > Steps / 2, told.Points.Count + " contacts");
            return told;
        }

        private static void WithTrace(Mode mode, Action<string, Model, Told> use)
        {
            string path = Samples.TemporaryPath(".trace");
            try
            {
                using (Model box = Model.FromTriangles(Samples.BoxPositions, Samples.BoxIndices))
                {
                    use(path, box, Record(path, box, mode));
                }
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void StepsAreReadAsTheyWere() => WithTrace(Mode.Certified, (path, box, told) =>
        {
            using (Trace trace = Trace.Open(path))
            {
                Assert.AreEqual($"{Steps} 0 True", $"{trace.Count} {trace.Lost} {trace.Complete}");
                Assert.AreEqual(0.001 * (Steps - 1), trace.Duration, 1e-12);
                Assert.AreEqual(-3, trace.Space.AxisY);
                Assert.AreEqual(0.01, trace.Space.MetresPerUnit, 0);
                TraceBody[] bodies = trace.Bodies();
                Assert.AreEqual(3, bodies.Length);
                Assert.AreEqual($"{told.Wall} Static", $"{bodies[0].Id} {bodies[0].Kind}");
                Assert.AreEqual($"{told.Tool} Tool", $"{bodies[1].Id} {bodies[1].Kind}");
                Assert.AreEqual("triangles 12 0 60", $"{bodies[0].ModelName} {bodies[0].ModelTriangles} " +
                                                     $"{bodies[0].FirstTick} {bodies[0].EndTick}");
                Assert.AreEqual("True 30", $"{bodies[2].Intangible} {bodies[2].EndTick}");
                Assert.AreEqual(box.Hash, bodies[0].ModelHash);
                Assert.AreEqual(600.0, bodies[0].Stiffness);
                Assert.AreEqual(70, bodies[1].ReferencePoint.Z, 1e-12);
                int points = 0;
                for (int i = 0; i < Steps; ++i)
                {
                    TraceTick tick = trace[i];
                    Assert.IsTrue(Reference.Same(told.Wrenches[i], tick.Wrench) &&
                                  Reference.Same(told.Wrenches[i], tick.Contacts.Wrench) &&
                                  Reference.Same(told.Distances[i], tick.MinDistance), "step " + i);
                    foreach (Contact contact in tick.Contacts.Lmds)
                    {
                        Assert.IsTrue(Reference.Same(told.Points[points++], contact.PointA), "step " + i);
                    }
                    Assert.AreEqual((long)i + 1, tick.Step);
                    Assert.AreEqual(i < 30 ? 2.0 : 3.0, tick.Damping);
                    Assert.AreEqual(told.Tool, tick.Tool);
                    Assert.AreEqual(PoseAt(i).Position.X, tick.ToolPose.Position.X, 1e-9);
                    Assert.AreEqual(i == 0 ? 2 : i == 30 ? 1 : 0, tick.Moves.Count, "moves of step " + i);
                    Assert.AreEqual(i == 30 ? 1 : 0, tick.Removed.Count, "removals of step " + i);
                }
                Assert.AreEqual(told.Points.Count, points);
                TraceTick changed = trace[30];
                Assert.AreEqual(told.Wall, changed.Moves[0].Body);
                Assert.AreEqual(0.5, changed.Moves[0].Pose.Position.X, 1e-12);
                Assert.AreEqual(bodies[2].Id, changed.Removed[0]);
                Assert.AreEqual($"{Mode.Certified} {Law.Smooth} 20", $"{changed.Mode} {changed.Law} {changed.Cutoff}");
            }
        });

        [Test]
        public void AReplayGivesTheSameBits()
        {
            foreach (Mode mode in new[] { Mode.Global, Mode.Descent, Mode.Certified })
            {
                WithTrace(mode, (path, box, told) =>
                {
                    using (Trace trace = Trace.Open(path))
                    using (var scene = new Scene(trace.Options()))
                    {
                        TraceBody[] recorded = trace.Bodies();
                        var bodies = new Body[recorded.Length];
                        for (int b = 0; b < bodies.Length; ++b)
                        {
                            Assert.AreEqual(box.Hash, recorded[b].ModelHash);
                            bodies[b] = scene.Add(box, recorded[b].Options());
                        }
                        for (long i = 0; i < trace.Count; ++i)
                        {
                            scene.SetDamping(trace[i].Damping);
                            for (int b = 0; b < bodies.Length; ++b)
                            {
                                if (i == recorded[b].EndTick)
                                {
                                    bodies[b].Remove();
                                }
                                if (i < recorded[b].EndTick)
                                {
                                    trace.Place(i, recorded[b], bodies[b]);
                                }
                            }
                            Contacts contacts = scene.Step();
                            Assert.IsTrue(Reference.Same(told.Wrenches[(int)i], contacts.Wrench), mode + ", step " + i);
                            Assert.IsTrue(Reference.Same(told.Distances[(int)i], contacts.MinDistance), mode + ", step " + i);
                        }
                    }
                });
            }
        }

        [Test]
        public void ReadingAllocatesNothing() => WithTrace(Mode.Certified, (path, box, told) =>
        {
            using (Trace trace = Trace.Open(path))
            {
                double force = 0;
                long before = 0;
                for (int i = 0; i < 4 * Steps; ++i)
                {
                    TraceTick tick = trace[i % Steps];
                    force += tick.Wrench.Force.X + tick.Moves.Count + tick.Contacts.Lmds.Count;
                    // What runs for the first time is compiled, and finds its room.
                    before = i < Steps ? GC.GetAllocatedBytesForCurrentThread() : before;
                }
                long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.AreEqual(0L, allocated);
                Assert.IsTrue(force != 0);
            }
        });

        [Test]
        public void ATraceThatWasCutOffIsReadAsFarAsItGoes() => WithTrace(Mode.Global, (path, box, told) =>
        {
            byte[] whole = File.ReadAllBytes(path);
            Array.Resize(ref whole, whole.Length - 3000);
            File.WriteAllBytes(path, whole);
            using (Trace trace = Trace.Open(path))
            {
                Assert.IsTrue(!trace.Complete && trace.Count > 0 && trace.Count < Steps, trace.Count + " steps");
                Assert.IsTrue(Reference.Same(told.Wrenches[(int)trace.Count - 1], trace[trace.Count - 1].Wrench));
            }
        });

        [Test]
        public void MistakesAreExceptions() => WithTrace(Mode.Global, (path, box, told) =>
        {
            Assert.Throws<ArgumentNullException>(() => Trace.Open(null));
            Assert.Throws<PalpateFileNotFoundException>(() => Trace.Open("/nowhere/at/all"));
            Assert.Throws<PalpateBadFormatException>(() => Trace.Open(Samples.ModelPath("torus.glb")));
            using (var scene = new Scene(Options(Mode.Global)))
            {
                Assert.Throws<ArgumentNullException>(() => scene.Record(null));
                Assert.Throws<PalpateFileNotFoundException>(() => scene.Record("/nowhere/at/all"));
                Assert.Throws<PalpateFileWriteException>(() => scene.Record("/dev/full"));
                Assert.Throws<PalpateWrongStateException>(() => scene.StopRecording());
                Trace trace = Trace.Open(path);
                TraceBody wall = trace.Bodies()[0];
                Body body = scene.Add(box);
                Assert.Throws<ArgumentOutOfRangeException>(() => trace[-1].ToString());
                Assert.Throws<ArgumentOutOfRangeException>(() => trace[Steps].ToString());
                Assert.Throws<ArgumentOutOfRangeException>(() => trace.Place(Steps, wall, body));
                Assert.Throws<ArgumentNullException>(() => trace.Place(0, null, body));
                Assert.Throws<InvalidOperationException>(() => trace.Place(0, wall, default(Body)));
                Assert.Throws<InvalidOperationException>(() => default(TraceTick).Moves.Count.ToString());
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_scene_step(trace.Handle));
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_trace_release(scene.Handle));
                TraceTick first = trace[0];
                TraceTick second = trace[1];
                Assert.Throws<InvalidOperationException>(() => first.Moves.Count.ToString());
                Assert.Throws<InvalidOperationException>(() => first.Contacts.SetCount.ToString());
                Assert.IsTrue(Reference.Same(told.Wrenches[0], first.Wrench), "what was copied stays");
                trace.Dispose();
                trace.Dispose();
                Assert.Throws<InvalidOperationException>(() => second.Removed.Count.ToString());
                Assert.Throws<ObjectDisposedException>(() => trace[0].ToString());
                Assert.Throws<ObjectDisposedException>(() => trace.Bodies());
                Assert.Throws<ObjectDisposedException>(() => trace.Options());
                Assert.Throws<ObjectDisposedException>(() => trace.Place(0, wall, body));
            }
        });

        [Test]
        public void TracesThatNobodyHoldsAreClosed() => WithTrace(Mode.Global, (path, box, told) =>
        {
            const int Opened = 200;
            int before = OpenFiles();
            OpenAndForget(path, Opened);
            Assert.IsTrue(OpenFiles() > before, "a trace keeps its file open");
            DateTime end = DateTime.UtcNow + TimeSpan.FromSeconds(20);
            // A collector that looks at the stack conservatively may keep a few.
            while (OpenFiles() > before + Opened / 10)
            {
                Assert.IsTrue(DateTime.UtcNow < end, OpenFiles() - before + " of them are open");
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
        });

        private static int OpenFiles() => Directory.GetFiles("/proc/self/fd").Length;

        private static void OpenAndForget(string path, int count)
        {
            for (int i = 0; i < count; ++i)
            {
                GC.KeepAlive(Trace.Open(path));
            }
        }
    }
}
