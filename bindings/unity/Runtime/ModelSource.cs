// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>The models of a scene: bodies with one mesh at one scale, or with one file, share one, and so its search
    /// tree.</summary>
    internal sealed class ModelSource : IDisposable
    {
        private readonly Dictionary<MeshKey, Model> meshes = new Dictionary<MeshKey, Model>();
        private readonly Dictionary<string, Model> files = new Dictionary<string, Model>();
        private readonly Space space;

        internal ModelSource(Space space)
        {
            this.space = space;
        }

        internal Model Of(Mesh mesh, Vector3 scale)
        {
            var key = new MeshKey(mesh.GetInstanceID(), scale);
            Model model;
            if (!meshes.TryGetValue(key, out model))
            {
                model = Model.FromTriangles(Coordinates(mesh, scale), mesh.triangles, space);
                meshes.Add(key, model);
            }
            return model;
        }

        /// <summary>A file has metres and its own axes, which the scene's space brings into Unity's.</summary>
        internal Model Of(string path)
        {
            Model model;
            if (!files.TryGetValue(path, out model))
            {
                model = Model.Load(path);
                files.Add(path, model);
            }
            return model;
        }

        public void Dispose()
        {
            foreach (Model model in meshes.Values)
            {
                model.Dispose();
            }
            foreach (Model model in files.Values)
            {
                model.Dispose();
            }
            meshes.Clear();
            files.Clear();
        }

        private static float[] Coordinates(Mesh mesh, Vector3 scale)
        {
            Vector3[] vertices = mesh.vertices;
            var coordinates = new float[3 * vertices.Length];
            for (int i = 0; i < vertices.Length; ++i)
            {
                coordinates[3 * i] = vertices[i].x * scale.x;
                coordinates[3 * i + 1] = vertices[i].y * scale.y;
                coordinates[3 * i + 2] = vertices[i].z * scale.z;
            }
            return coordinates;
        }

        private readonly struct MeshKey : IEquatable<MeshKey>
        {
            private readonly int mesh;
            private readonly Vector3 scale;

            internal MeshKey(int mesh, Vector3 scale)
            {
                this.mesh = mesh;
                this.scale = scale;
            }

            public bool Equals(MeshKey other) => mesh == other.mesh && scale.Equals(other.scale);

            public override bool Equals(object other) => other is MeshKey && Equals((MeshKey)other);

            public override int GetHashCode() => mesh * 397 ^ scale.GetHashCode();
        }
    }
}
