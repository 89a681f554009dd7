using System;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace Palpate.Unity.Tests
{
    /// <summary>What a user puts on the stage.</summary>
    internal static class Play
    {
        internal const float Stiffness = 500;
        private static readonly TimeSpan Longest = TimeSpan.FromSeconds(30);

        /// <summary>Stepped by the frames, with springs a fifth of a unit long.</summary>
        internal static PalpateScene Scene(Handedness handedness = Handedness.FlipX, bool servo = false)
        {
            var made = new GameObject { name = "scene" };
            made.SetActive(false);
            var scene = made.AddComponent<PalpateScene>();
            scene.cutoff = 0.2f;
            scene.stiffness = Stiffness;
            scene.law = Law.Springs;
            scene.handedness = handedness;
            scene.servo = servo;
            made.SetActive(true);
            return scene;
        }

        /// <summary>An octahedron, one unit from corner to corner.</summary>
        internal static T Body<T>(PalpateScene scene, Vector3 position) where T : HapticBody, new() =>
            Body<T>(scene, position, Vector3.one);

        internal static T Body<T>(PalpateScene scene, Vector3 position, Vector3 scale) where T : HapticBody, new()
        {
            GameObject made = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            made.name = typeof(T).Name;
            made.transform.SetParent(scene.transform, false);
            made.transform.localPosition = position;
            made.transform.localScale = scale;
            return made.AddComponent<T>();
        }

        internal static void Frames(int count)
        {
            for (int i = 0; i < count; ++i)
            {
                Stage.Frame();
            }
        }

        internal static void FramesUntil(Func<bool> happened)
        {
            DateTime end = DateTime.UtcNow + Longest;
            while (!happened())
            {
                Assert.IsTrue(DateTime.UtcNow < end, "it does not happen");
                Thread.Sleep(1);
                Stage.Frame();
            }
        }
    }
}
