using System.Collections.Generic;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>One scene in the spaces of several engines, against the numbers that the C interface is held to.</summary>
    [TestFixture]
    public class SpaceTest
    {
        [Test]
        public void EveryEngineFeelsTheSame()
        {
            List<SpaceVectors> spaces = SpaceVectors.Read();
            Assert.IsTrue(spaces.Count >= 5);
            foreach (SpaceVectors told in spaces)
            {
                double cutoff = told.Number("cutoff");
                using (Model still = ModelOf(told, "body"))
                using (Model moved = ModelOf(told, "tool"))
                using (var scene = new Scene(new SceneOptions
                {
                    Cutoff = cutoff, Stiffness = told.Number("stiffness"), Law = Law.Springs, Space = told.Space
                }))
                {
                    scene.Add(still, new BodyOptions { Pose = told.Pose("body") });
                    Body tool = scene.Add(moved, new BodyOptions { Kind = BodyKind.Tool, Pose = told.Pose("tool") });
                    Contacts contacts = scene.Step();
                    Assert.AreEqual(1, contacts.SetCount, told.Name);
                    Assert.AreEqual(told.Number("distance"), contacts.MinDistance, 1e-5 * cutoff, told.Name);
                    RequireNear(told.Vector("force"), contacts.Wrench.Force, 1e-3, told.Name);
                    RequireNear(told.Vector("torque"), contacts.Wrench.Torque, 1e-3, told.Name);
                    RequireNear(told.Vector("tool.position"), tool.Pose.Position, 1e-9, told.Name);
                }
            }
        }

        [Test]
        public void TheNamedSpacesAreThoseOfTheirEngines()
        {
            var named = new Dictionary<string, Space>
            {
                { "Palpate", Space.Native }, { "UnityGLTF", Space.UnityGltf }, { "Unity as OpenXR", Space.UnityOpenXR },
                { "Panda3D", Space.ZUp }, { "Unreal", Space.Unreal }
            };
            foreach (KeyValuePair<string, Space> pair in named)
            {
                SpaceVectors told = SpaceVectors.Read().Find(space => space.Name.Contains(pair.Key));
                Assert.AreEqual(told.Space, pair.Value, pair.Key);
            }
        }

        /// <summary>The winding is trusted, so that a wrong one is not repaired.</summary>
        private static Model ModelOf(SpaceVectors told, string part)
        {
            Model model = Model.FromTriangles(
                told.Vertices(part), told.Triangles(part), told.Space, new ModelOptions { KeepWinding = true });
            Assert.AreEqual(Orientation.Outward, model.Info.Searched.Orientation, told.Name);
            return model;
        }

        private static void RequireNear(Vector3d expected, Vector3d actual, double tolerance, string message)
        {
            Assert.AreEqual(expected.X, actual.X, tolerance, message);
            Assert.AreEqual(expected.Y, actual.Y, tolerance, message);
            Assert.AreEqual(expected.Z, actual.Z, tolerance, message);
        }
    }
}
