using System;
using NUnit.Framework;
using Palpate.Tests;
using UnityEngine;

namespace Palpate.Unity.Tests
{
    /// <summary>A mesh as Unity has it is pushed the way that Unity shows, whichever axis was turned on import.</summary>
    [TestFixture]
    public class ConversionTest
    {
        [Test]
        public void NumbersKeepTheirPlaces()
        {
            Assert.AreEqual(new Vector3d(1, 2, 3), Conversion.ToPalpate(new Vector3(1, 2, 3)));
            Assert.AreEqual(new Vector3(1, 2, 3), Conversion.ToUnity(new Vector3d(1, 2, 3)));
            Assert.AreEqual(new Quaterniond(1, 2, 3, 4), Conversion.ToPalpate(new Quaternion(1, 2, 3, 4)));
            Assert.AreEqual(new Quaternion(1, 2, 3, 4), Conversion.ToUnity(new Quaterniond(1, 2, 3, 4)));
        }

        [Test]
        public void TheSpaceIsUnitys()
        {
            Space space = Conversion.SpaceOf(Handedness.FlipX, 0.5);
            Assert.AreEqual("-1 2 3 0.5", $"{space.AxisX} {space.AxisY} {space.AxisZ} {space.MetresPerUnit}");
            space = Conversion.SpaceOf(Handedness.FlipZ, 1);
            Assert.AreEqual("1 2 -3 1", $"{space.AxisX} {space.AxisY} {space.AxisZ} {space.MetresPerUnit}");
        }

        [Test]
        public void ForcesPointFromTheBodyToTheTool()
        {
            foreach (Handedness handedness in new[] { Handedness.FlipX, Handedness.FlipZ })
            {
                foreach (Vector3 towards in new[] { new Vector3(1, 0, 0), new Vector3(0, -1, 0), new Vector3(0, 0, 1) })
                {
                    Stage.Begin(typeof(PalpateScene).Assembly);
                    PalpateScene scene = Play.Scene(handedness);
                    Play.Body<HapticBody>(scene, Vector3.zero);
                    Play.Body<HapticTool>(scene, 1.1f * towards);
                    Play.Frames(3);
                    Assert.AreEqual(1, scene.ContactCount, handedness.ToString());
                    Assert.AreEqual(50, scene.Force.x * towards.x + scene.Force.y * towards.y + scene.Force.z * towards.z, 1e-3);
                    Assert.AreEqual(50, scene.Force.magnitude, 1e-3);
                    Contact contact = scene.GetContact(0);
                    Assert.AreEqual(0.1, contact.Distance, 1e-6);
                    Vector3 onBody = Conversion.ToUnity(contact.PointA);
                    Assert.AreEqual(0.5, onBody.magnitude, 1e-6);
                    Stage.End();
                }
            }
        }

        /// <summary>A scene of the golden vectors, as the meshes and transforms that Unity would have of it.</summary>
        [Test]
        public void TheGoldenVectorsAreFelt()
        {
            int checkedSpaces = 0;
            foreach (SpaceVectors told in SpaceVectors.Read())
            {
                if (!told.Name.StartsWith("Unity", StringComparison.Ordinal))
                {
                    continue;
                }
                Stage.Begin(typeof(PalpateScene).Assembly);
                Handedness handedness = told.Space.AxisX < 0 ? Handedness.FlipX : Handedness.FlipZ;
                Assert.AreEqual(told.Space, Conversion.SpaceOf(handedness, 1), told.Name);
                PalpateScene scene = Play.Scene(handedness);
                scene.cutoff = (float)told.Number("cutoff");
                scene.stiffness = (float)told.Number("stiffness");
                Stage.Validate(scene);
                Told<HapticBody>(scene, told, "body");
                Told<HapticTool>(scene, told, "tool");
                Play.Frames(3);
                Assert.AreEqual(1, scene.ContactCount, told.Name);
                Assert.AreEqual(told.Number("distance"), scene.MinDistance, 1e-5, told.Name);
                // A transform has single precision.
                RequireNear(told.Vector("force"), scene.Force, 1e-3, told.Name);
                RequireNear(told.Vector("torque"), scene.Torque, 2e-3, told.Name);
                foreach (Body body in scene.Native.Bodies())
                {
                    using (Model model = body.Model)
                    {
                        Assert.AreEqual(0UL, model.Info.FlippedComponents, "a winding that had to be repaired");
                    }
                }
                ++checkedSpaces;
                Stage.End();
            }
            Assert.AreEqual(2, checkedSpaces);
        }

        private static void Told<T>(PalpateScene scene, SpaceVectors told, string part) where T : HapticBody, new()
        {
            double[] numbers = told.Vertices(part);
            var mesh = new Mesh { vertices = new Vector3[numbers.Length / 3], triangles = told.Triangles(part) };
            for (int i = 0; i < mesh.vertices.Length; ++i)
            {
                mesh.vertices[i] = Conversion.ToUnity(new Vector3d(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
            }
            var made = new GameObject { name = part };
            made.SetActive(false);
            made.transform.SetParent(scene.transform, false);
            made.transform.localPosition = Conversion.ToUnity(told.Pose(part).Position);
            made.transform.rotation = Conversion.ToUnity(told.Pose(part).Orientation);
            made.AddComponent<T>().mesh = mesh;
            made.SetActive(true);
        }

        private static void RequireNear(Vector3d expected, Vector3 actual, double tolerance, string message)
        {
            Assert.AreEqual(expected.X, actual.x, tolerance, message);
            Assert.AreEqual(expected.Y, actual.y, tolerance, message);
            Assert.AreEqual(expected.Z, actual.z, tolerance, message);
        }

        [Test]
        public void ScalesAndTurnsAreTaken()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene(Handedness.FlipX);
            HapticBody wide = Play.Body<HapticBody>(scene, Vector3.zero, new Vector3(1, 1, 3));
            // A quarter turn about y brings what was wide along z to x.
            wide.transform.rotation = new Quaternion(0, 0.70710678f, 0, 0.70710678f);
            Play.Body<HapticTool>(scene, new Vector3(2.1f, 0, 0));
            Play.Frames(3);
            Assert.AreEqual(0.1, scene.MinDistance, 1e-6);
            Assert.AreEqual(50, scene.Force.x, 1e-3);
            Stage.End();
        }

        /// <summary>In Unity, whose axes are left-handed, a force up at x turns about z as the left hand shows.</summary>
        [Test]
        public void TorquesArePseudoVectors()
        {
            Stage.Begin(typeof(PalpateScene).Assembly);
            PalpateScene scene = Play.Scene(Handedness.FlipX);
            Play.Body<HapticBody>(scene, new Vector3(0, -1.1f, 0));
            HapticTool tool = Play.Body<HapticTool>(scene, Vector3.zero);
            tool.enabled = false;
            tool.referencePoint = new Vector3(-0.2f, 0, 0);
            tool.enabled = true;
            Play.Frames(3);
            Assert.AreEqual(50, scene.Force.y, 1e-3);
            // r = (0.2, -0.5, 0), F = (0, 50, 0): r × F = (0, 0, 10), the same product in either handedness.
            Assert.AreEqual(10, scene.Torque.z, 1e-3);
            Stage.End();
        }
    }
}
