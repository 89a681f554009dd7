using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Text;
using System.Threading;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public unsafe class MisuseTest
    {
        [Test]
        public void EveryErrorCodeHasItsException()
        {
            int count = 0;
            foreach (FieldInfo field in typeof(Raw).GetFields())
            {
                if (field.Name.StartsWith("PLP_ERROR_", StringComparison.Ordinal))
                {
                    RequireException((int)field.GetRawConstantValue(), field.Name);
                    ++count;
                }
            }
            Assert.IsTrue(count > 10);
            Assert.AreEqual(-9999, Assert.Throws<PalpateException>(() => PalpateException.Check(-9999)).Code);
            PalpateException.Check(Raw.PLP_OK);
            PalpateException.Check(1);
        }

        [Test]
        public void WhatCannotBeLoadedSaysWhy()
        {
            Assert.Throws<PalpateFileNotFoundException>(() => Model.Load("/nowhere/at all.glb"));
            Assert.Throws<PalpateFileReadException>(() => Model.Load(Path.GetTempPath()));
            Assert.Throws<PalpateBadFormatException>(() => Model.FromBytes(new byte[] { 1, 2, 3 }));
            Assert.Throws<PalpateUnsupportedException>(() => Model.FromBytes(Samples.Gltf(
                "\"scene\": 0", "\"extensionsRequired\": [\"EXT_unheard_of\"], \"extensionsUsed\": [\"EXT_unheard_of\"], \"scene\": 0")));
            Assert.Throws<PalpateUnsafePathException>(() => Model.FromBytes(Samples.Gltf(
                "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA", "../outside.bin"),
                Path.GetTempPath()));
            Assert.Throws<PalpateNoTrianglesException>(() => Model.FromTriangles(new float[9]));
            Assert.Throws<PalpateNonFiniteException>(() => Model.FromTriangles(new[] { 0, 0, 0, 1, 0, 0, 0, float.NaN, 0 }));
            Assert.Throws<PalpateLimitException>(() => Model.FromTriangles(
                Samples.BoxPositions, Samples.BoxIndices, null, new ModelOptions { MaxTriangles = 11 }));
            PalpateException error = Assert.Throws<PalpateFileNotFoundException>(() => Model.Load("/nowhere/at all.glb"));
            Assert.IsTrue(error.Message.Contains("/nowhere/at all.glb"), error.Message);
        }

        [Test]
        public void WrongArraysAreRefused()
        {
            Assert.Throws<PalpateNoTrianglesException>(() => Model.FromTriangles(new float[0]));
            Assert.Throws<PalpateInvalidArgumentException>(() => Model.FromTriangles(Samples.BoxPositions, new[] { 0, 1, 8 }));
            Assert.Throws<PalpateInvalidArgumentException>(() => Model.FromTriangles(Samples.BoxPositions, new[] { 0, 1, -1 }));
            Assert.Throws<ArgumentException>(() => Model.FromTriangles(new float[10]));
            Assert.Throws<ArgumentException>(() => Model.FromTriangles(Samples.BoxPositions, new int[4]));
            Assert.Throws<PalpateBadFormatException>(() => Model.FromBytes(default(ReadOnlySpan<byte>).ToArray()));
        }

        [Test]
        public void NullsAreRefused()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            using (var scene = new Scene(new SceneOptions { Cutoff = 1 }))
            {
                var options = new QueryOptions { Cutoff = 1 };
                Assert.Throws<ArgumentNullException>(() => Model.Load(null));
                Assert.Throws<ArgumentException>(() => Model.Load("a\0b"));
                Assert.Throws<ArgumentNullException>(() => new Scene(null));
                Assert.Throws<ArgumentNullException>(() => scene.Add(null));
                Assert.Throws<ArgumentNullException>(() => result.Search(null, box, Pose.Identity, options));
                Assert.Throws<ArgumentNullException>(() => result.Search(box, null, Pose.Identity, options));
                Assert.Throws<ArgumentNullException>(() => result.Search(box, box, Pose.Identity, null));
                Assert.Throws<InvalidOperationException>(() => default(Body).Remove());
                Assert.Throws<InvalidOperationException>(() => default(Contacts).SetCount.ToString());
            }
            Assert.AreEqual(Raw.PLP_ERROR_INVALID_ARGUMENT, Raw.plp_scene_create(null, null));
            Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_scene_step(IntPtr.Zero));
        }

        [Test]
        public void NumbersOutOfRangeAreRefused()
        {
            using (Model box = Samples.Box())
            using (var result = new QueryResult())
            using (var scene = new Scene(new SceneOptions { Cutoff = 1 }))
            {
                foreach (double bad in new[] { double.NaN, double.PositiveInfinity, -1, 0 })
                {
                    Assert.Throws<PalpateInvalidArgumentException>(() => new Scene(new SceneOptions { Cutoff = bad }));
                    Assert.Throws<PalpateInvalidArgumentException>(() => scene.SetCutoff(bad));
                    Assert.Throws<PalpateInvalidArgumentException>(
                        () => result.Search(box, box, Pose.Identity, new QueryOptions { Cutoff = bad }));
                }
                Body tool = scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1, 2, 3) });
                Assert.Throws<PalpateInvalidArgumentException>(() => Move(tool, new Pose(double.NaN, 0, 0)));
                Assert.Throws<PalpateInvalidArgumentException>(() => Move(tool, default(Pose)));
                Assert.AreEqual(new Vector3d(1, 2, 3), tool.Pose.Position);
                Assert.Throws<PalpateInvalidArgumentException>(() => scene.SetMode((Mode)17));
                Assert.Throws<PalpateInvalidArgumentException>(() => scene.SetStiffness(double.NaN));
                Assert.Throws<PalpateInvalidArgumentException>(() => scene.Add(box, new BodyOptions { Kind = BodyKind.Tool }));
            }
        }

        [Test]
        public void WhatIsDisposedThrows()
        {
            Model box = Samples.Box();
            var result = new QueryResult();
            var scene = new Scene(new SceneOptions { Cutoff = 1 });
            Body body = scene.Add(box);
            box.Dispose();
            Assert.Throws<ObjectDisposedException>(() => box.Prepare());
            Assert.Throws<ObjectDisposedException>(() => box.Info.ToString());
            Assert.Throws<ObjectDisposedException>(() => box.Notes());
            Assert.Throws<ObjectDisposedException>(() => scene.Add(box));
            Assert.Throws<ObjectDisposedException>(() => result.Search(box, box, Pose.Identity, new QueryOptions { Cutoff = 1 }));
            result.Dispose();
            using (Model other = Samples.Box())
            {
                Assert.Throws<ObjectDisposedException>(
                    () => result.Search(other, other, Pose.Identity, new QueryOptions { Cutoff = 1 }));
            }
            scene.Dispose();
            Assert.Throws<ObjectDisposedException>(() => scene.Step());
            Assert.Throws<ObjectDisposedException>(() => scene.Read());
            Assert.Throws<ObjectDisposedException>(() => scene.SetCutoff(1));
            Assert.Throws<ObjectDisposedException>(() => body.Remove());
            Assert.Throws<ObjectDisposedException>(() => Move(body, Pose.Identity));
            box.Dispose();
            result.Dispose();
            scene.Dispose();
        }

        [Test]
        public void ContactsEndWithTheNextSearch()
        {
            using (Model box = Samples.Box())
            {
                var scene = new Scene(new SceneOptions { Cutoff = 0.2 });
                scene.Add(box);
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                Contacts first = scene.Step();
                Contacts second = scene.Step();
                Assert.Throws<InvalidOperationException>(() => first.SetCount.ToString());
                Assert.Throws<InvalidOperationException>(() => first.Lmds.Count.ToString());
                Assert.AreEqual(4, second.Lmds.Count);
                RequireStale(scene, second.Lmds);
                scene.Dispose();
                Assert.Throws<InvalidOperationException>(() => second.Wrench.ToString());
            }
        }

        [Test]
        public void ARemovedBodyIsRefused()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Cutoff = 1 }))
            {
                Body body = scene.Add(box);
                body.Remove();
                Assert.Throws<PalpateInvalidHandleException>(() => body.Remove());
                Assert.Throws<PalpateInvalidHandleException>(() => Move(body, Pose.Identity));
            }
        }

        [Test]
        public void AHandleOfAnotherKindIsRefused()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Cutoff = 1 }))
            {
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_scene_step(box.Handle));
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_model_prepare(scene.Handle));
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_model_release(scene.Handle));
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_scene_release((IntPtr)0x1234));
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_HANDLE, Raw.plp_query_result_release(scene.Handle));
            }
        }

        [Test]
        public void OtherThreadsGetExceptions()
        {
            using (Model box = Samples.Box())
            {
                var scene = new Scene(new SceneOptions { Cutoff = 0.2 });
                scene.Add(box);
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                var outcomes = new List<string>();
                ThreadStart step = () =>
                {
                    try
                    {
                        outcomes.Add(scene.Step().SetCount.ToString());
                    }
                    catch (Exception error)
                    {
                        outcomes.Add(error.GetType().Name);
                    }
                };
                RunElsewhere(step);
                scene.Start();
                RunElsewhere(step);
                scene.Dispose();
                RunElsewhere(step);
                Assert.AreEqual("1 PalpateWrongStateException ObjectDisposedException", string.Join(" ", outcomes));
            }
        }

        [Test]
        public void ASceneMayBeDisposedWhileAnotherThreadStepsIt()
        {
            using (Model box = Samples.Box())
            {
                for (int round = 0; round < 20; ++round)
                {
                    var scene = new Scene(new SceneOptions { Cutoff = 0.2 });
                    scene.Add(box);
                    scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                    Exception thrown = null;
                    var began = new ManualResetEvent(false);
                    var thread = new Thread(() =>
                    {
                        try
                        {
                            while (true)
                            {
                                scene.Step();
                                began.Set();
                            }
                        }
                        catch (Exception error)
                        {
                            thrown = error;
                        }
                    });
                    thread.Start();
                    Assert.IsTrue(began.WaitOne(TimeSpan.FromSeconds(30)));
                    scene.Dispose();
                    thread.Join();
                    Assert.IsTrue(thrown is ObjectDisposedException || thrown is PalpateInvalidHandleException,
                                  thrown.ToString());
                }
            }
        }

        private static void RunElsewhere(ThreadStart work)
        {
            var thread = new Thread(work);
            thread.Start();
            thread.Join();
        }

        [Test]
        public void StructsOfOtherVersionsAreReadAsFarAsTheyAreUnderstood()
        {
            // A longer struct of a later version, with nothing and then with something in its tail.
            byte* memory = stackalloc byte[sizeof(Raw.plp_scene_options) + 8];
            var options = (Raw.plp_scene_options*)memory;
            Raw.plp_scene_options_init(options, (UIntPtr)sizeof(Raw.plp_scene_options));
            options->cutoff = 1;
            options->struct_size = (uint)sizeof(Raw.plp_scene_options) + 8;
            *(ulong*)(memory + sizeof(Raw.plp_scene_options)) = 0;
            IntPtr scene;
            Assert.AreEqual(Raw.PLP_OK, Raw.plp_scene_create(options, &scene));
            Assert.AreEqual(Raw.PLP_OK, Raw.plp_scene_release(scene));
            *(ulong*)(memory + sizeof(Raw.plp_scene_options)) = 1;
            Assert.AreEqual(Raw.PLP_ERROR_INVALID_ARGUMENT, Raw.plp_scene_create(options, &scene));
            foreach (uint size in new uint[] { 0, 4, 55, 5000, uint.MaxValue })
            {
                options->struct_size = size;
                Assert.AreEqual(Raw.PLP_ERROR_INVALID_ARGUMENT, Raw.plp_scene_create(options, &scene), size.ToString());
            }
        }

        [Test]
        public void TheLibraryHasTheVersionOfTheBinding()
        {
            Assert.AreEqual($"{Raw.PLP_VERSION_MAJOR}.{Raw.PLP_VERSION_MINOR}.{Raw.PLP_VERSION_PATCH}", Library.Version);
            Assert.AreEqual(1000000U * Raw.PLP_VERSION_MAJOR + 1000 * Raw.PLP_VERSION_MINOR + Raw.PLP_VERSION_PATCH,
                            Library.VersionNumber);
        }

        private static void Move(Body body, Pose pose) => body.Pose = pose;

        /// <summary>A list may not be in a lambda.</summary>
        private static void RequireStale(Scene scene, NativeList<Contact> list)
        {
            scene.Step();
            bool thrown = false;
            try
            {
                list[0].ToString();
            }
            catch (InvalidOperationException)
            {
                thrown = true;
            }
            Assert.IsTrue(thrown);
        }

        /// <summary>PLP_ERROR_BAD_FORMAT gives PalpateBadFormatException.</summary>
        private static void RequireException(int code, string name)
        {
            var expected = new StringBuilder("Palpate");
            foreach (string word in name.Substring("PLP_ERROR_".Length).Split('_'))
            {
                expected.Append(word[0]).Append(word.Substring(1).ToLowerInvariant());
            }
            expected.Append("Exception");
            PalpateException thrown = null;
            try
            {
                PalpateException.Check(code);
            }
            catch (PalpateException error)
            {
                thrown = error;
            }
            Assert.AreEqual(expected.ToString(), thrown.GetType().Name);
            Assert.AreEqual(code, thrown.Code, name);
        }
    }
}
