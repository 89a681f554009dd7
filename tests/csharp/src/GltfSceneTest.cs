using System;
using System.IO;
using NUnit.Framework;

namespace Palpate.Tests
{
    [TestFixture]
    public class GltfSceneTest
    {
        private const string OneNode = @"""nodes"": [{""mesh"": 0}]";

        // A triangle above another: the second mirrors nothing, is a child of the first, and has a material.
        private const string TwoNodes = @"""nodes"": [{""mesh"": 0, ""name"": ""floor"", ""children"": [1]},
            {""mesh"": 0, ""name"": ""probe ☃"", ""translation"": [0, 0, 0.1], ""extras"": {""stiffness"": 20, ""friction"": 0}}]";

        private static void WithFile(Action<string> use)
        {
            string path = Samples.TemporaryPath(".gltf");
            File.WriteAllBytes(path, Samples.Gltf(OneNode, TwoNodes));
            try
            {
                use(path);
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void NodesBecomeBodies() => WithFile(path =>
        {
            using (var scene = new Scene(new SceneOptions { Law = Law.Springs, Cutoff = 0.01 }))
            {
                Body[] bodies = scene.LoadGltf(path, new GltfSceneOptions { Tool = "probe ☃", Cutoff = 0.2 });
                Assert.AreEqual(2, bodies.Length);
                Assert.AreEqual("floor", bodies[0].Info.Name);
                Assert.AreEqual("probe ☃", bodies[1].Info.Name);
                Assert.AreEqual(BodyKind.Static, bodies[0].Info.Kind);
                Assert.AreEqual(BodyKind.Tool, bodies[1].Info.Kind);
                Assert.AreEqual(bodies[0].Id, bodies[1].Info.Above);
                Assert.AreEqual(20.0, bodies[1].Info.Stiffness);
                Assert.AreEqual(-1.0, bodies[1].Info.Friction);
                Assert.AreEqual(1L, bodies[1].Info.Triangles);
                Assert.AreEqual(bodies[1].Id, scene.Find("probe ☃").Id);
                Assert.AreEqual(bodies[1].Id, scene.Bodies()[1].Id);
                Assert.AreEqual(1000 * 0.1, scene.Step().Wrench.Force.Z, 1e-4);
                using (Model model = bodies[0].Model)
                {
                    Assert.AreEqual(Math.Sqrt(2), model.Info.Diagonal, 1e-6);
                }
                bodies[1].Pose = new Pose(0, 0, 0.3);
                Assert.AreEqual(0.3, bodies[1].NodeMatrix()[14], 1e-12);
            }
        });

        [Test]
        public void AnErrorAddsNothing() => WithFile(path =>
        {
            using (var scene = new Scene(new SceneOptions { Cutoff = 0.01 }))
            {
                Assert.Throws<PalpateInvalidArgumentException>(
                    () => scene.LoadGltf(path, new GltfSceneOptions { Tool = "nobody" }));
                Assert.Throws<PalpateInvalidArgumentException>(() => scene.LoadGltf(path, new GltfSceneOptions { Cutoff = -1 }));
                Assert.Throws<PalpateLimitException>(() => scene.LoadGltf(
                    path, new GltfSceneOptions { Model = new ModelOptions { MaxTriangles = 1 } }));
                Assert.Throws<ArgumentNullException>(() => scene.LoadGltf(null));
                Assert.Throws<PalpateInvalidArgumentException>(() => scene.Find("floor"));
                Assert.AreEqual(0, scene.Bodies().Length);
            }
        });

        [Test]
        public void WhatIsIntangibleIsNotTouched()
        {
            using (Model box = Samples.Box())
            using (var scene = new Scene(new SceneOptions { Cutoff = 0.2 }))
            {
                Body wall = scene.Add(box, new BodyOptions { Intangible = true });
                scene.Add(box, new BodyOptions { Kind = BodyKind.Tool, Pose = new Pose(1.1, 0, 0) });
                Assert.AreEqual(0, scene.Step().SetCount);
                Assert.IsTrue(wall.Info.Intangible);
                Assert.AreEqual(-1, wall.Info.Node);
            }
        }
    }
}
