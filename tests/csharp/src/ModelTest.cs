using System;
using System.IO;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public unsafe class ModelTest
    {
        [Test]
        public void LoadsAFile()
        {
            using (Model model = Model.Load(Samples.ModelPath("box.glb")))
            {
                ModelInfo info = model.Info;
                Assert.AreEqual(12UL, info.Source.Triangles);
                Assert.AreEqual(8UL, info.Searched.Vertices);
                Assert.AreEqual(18UL, info.Searched.Edges);
                Assert.IsTrue(info.Searched.Watertight);
                Assert.AreEqual(Orientation.Outward, info.Searched.Orientation);
                Assert.IsTrue(info.Diagonal > 0 && info.BoundsMin.X < info.BoundsMax.X);
                Assert.AreEqual((ulong)new FileInfo(Samples.ModelPath("box.glb")).Length, info.ReadBytes);
                Assert.IsTrue(info.DecodedBytes > 0 && info.DecodedBytes < info.ReadBytes);
                using (Model twice = Model.Load(Samples.ModelPath("box.glb"), new ModelOptions { Scale = 2 }))
                {
                    Assert.AreEqual(2 * info.Diagonal, twice.Info.Diagonal, 1e-12);
                }
            }
        }

        [Test]
        public void LoadsAFileWithAUnicodeName()
        {
            string path = Samples.TemporaryPath("дом ☃.gltf");
            File.WriteAllBytes(path, Samples.Gltf());
            try
            {
                using (Model model = Model.Load(path))
                {
                    Assert.AreEqual(1UL, model.Info.Source.Triangles);
                }
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void LoadsBytes()
        {
            using (Model model = Model.FromBytes(File.ReadAllBytes(Samples.ModelPath("box.glb"))))
            {
                Assert.AreEqual(12UL, model.Info.Source.Triangles);
            }
        }

        [Test]
        public void TakesArraysOfSeveralTypes()
        {
            var doubles = new double[Samples.BoxPositions.Length];
            Array.Copy(Samples.BoxPositions, doubles, doubles.Length);
            using (Model single = Samples.Box())
            using (Model twice = Model.FromTriangles(doubles, Samples.BoxIndices))
            using (Model soup = Model.FromTriangles(Soup()))
            {
                foreach (Model model in new[] { single, twice, soup })
                {
                    Assert.AreEqual(12UL, model.Info.Searched.Triangles);
                    Assert.AreEqual(8UL, model.Info.Searched.Vertices);
                    Assert.AreEqual(Math.Sqrt(3), model.Info.Diagonal, 1e-15);
                }
            }
        }

        [Test]
        public void TakesTheCallersOwnBuffers()
        {
            var indices = new ushort[Samples.BoxIndices.Length];
            for (int i = 0; i < indices.Length; ++i)
            {
                indices[i] = (ushort)Samples.BoxIndices[i];
            }
            fixed (float* positions = Samples.BoxPositions)
            fixed (ushort* corners = indices)
            {
                Raw.plp_triangles triangles;
                Raw.plp_triangles_init(&triangles, (UIntPtr)sizeof(Raw.plp_triangles));
                triangles.positions = positions;
                triangles.vertex_count = (UIntPtr)8;
                triangles.indices = corners;
                triangles.index_type = Raw.PLP_TYPE_UINT16;
                triangles.triangle_count = (UIntPtr)12;
                using (Model model = Model.FromTriangles(ref triangles))
                {
                    Assert.IsTrue(model.Info.Searched.Watertight);
                }
            }
        }

        [Test]
        public void SpaceConverts()
        {
            using (Model model = Model.FromTriangles(Samples.BoxPositions, Samples.BoxIndices, new Space(-1, 2, 3, 0.01)))
            {
                Assert.AreEqual(0.01 * Math.Sqrt(3), model.Info.Diagonal, 1e-8);
                // Its winding was turned with the mirror, so that there was nothing to repair.
                Assert.AreEqual(0UL, model.Info.ReversedTriangles);
            }
        }

        [Test]
        public void OptionsAreObeyed()
        {
            var options = new ModelOptions { DoubleSided = true, KeepWinding = true, WeldTolerance = 0.001 };
            Assert.IsTrue(options.DoubleSided && options.KeepWinding);
            Assert.AreEqual(-1, options.GltfScene);
            using (Model model = Model.FromTriangles(Samples.BoxPositions, Samples.BoxIndices, null, options))
            {
                Assert.AreEqual(12UL, model.Info.DoubleSidedTriangles);
            }
            options.DoubleSided = false;
            Assert.IsTrue(!options.DoubleSided && options.KeepWinding);
        }

        [Test]
        public void NotesTellWhatWasDone()
        {
            int[] inward = (int[])Samples.BoxIndices.Clone();
            Array.Reverse(inward);
            using (Model model = Model.FromTriangles(Samples.BoxPositions, inward))
            {
                Assert.AreEqual(1UL, model.Info.FlippedComponents);
                Assert.IsTrue(model.Notes().Length > 0 && model.Notes()[0].Length > 10);
            }
        }

        [Test]
        public void PreparesTheTree()
        {
            using (Model model = Samples.Box())
            {
                Assert.AreEqual(0UL, model.Info.TreeNodes);
                model.Prepare();
                Assert.IsTrue(model.Info.TreeNodes > 0);
            }
        }

        private static float[] Soup()
        {
            var positions = new float[3 * Samples.BoxIndices.Length];
            for (int i = 0; i < positions.Length; ++i)
            {
                positions[i] = Samples.BoxPositions[3 * Samples.BoxIndices[i / 3] + i % 3];
            }
            return positions;
        }
    }
}
