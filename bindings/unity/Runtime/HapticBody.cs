// SPDX-License-Identifier: MIT
using System.IO;
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>A mesh or a glTF file that the tool can touch. It belongs to the PalpateScene above it, or to the one that
    /// was enabled last, and may be moved at any time. Its scale is taken when it is enabled.</summary>
    [AddComponentMenu("Palpate/Haptic Body")]
    [DisallowMultipleComponent]
    public class HapticBody : MonoBehaviour
    {
        [Tooltip("Empty: the mesh of the MeshFilter beside it")]
        public Mesh mesh;

        [Tooltip("A .gltf or .glb file instead of a mesh; relative to StreamingAssets")]
        public string gltfFile = "";

        [Tooltip("Empty: as the scene says")]
        public HapticMaterial material;

        private PalpateScene owner;
        private Body body;

        /// <summary>Whether a scene has it.</summary>
        public bool IsAdded => owner != null;

        /// <summary>What BodyA and BodyB of contacts name; 0 while no scene has it.</summary>
        public ulong Id => IsAdded ? body.Id : 0;

        protected virtual BodyKind Kind => BodyKind.Moving;

        protected virtual void OnEnable() => PalpateScene.Register(this);

        protected virtual void OnDisable() => PalpateScene.Unregister(this);

        internal PalpateScene Wanted => GetComponentInParent<PalpateScene>();

        internal PalpateScene Owner => owner;

        /// <summary>False, with the reason in the console, if it cannot be touched.</summary>
        internal bool AddTo(PalpateScene scene, Scene native, ModelSource models)
        {
            try
            {
                Model model = ModelFrom(models);
                if (model == null)
                {
                    Debug.LogError($"{name}: there is neither a readable mesh nor a glTF file to touch", this);
                    return false;
                }
                body = native.Add(model, Options());
            }
            catch (PalpateException error)
            {
                Debug.LogError($"{name}: {error.Message}", this);
                return false;
            }
            owner = scene;
            transform.hasChanged = false;
            return true;
        }

        internal void Remove()
        {
            body.Remove();
            Forget();
        }

        internal virtual void Forget()
        {
            owner = null;
            body = default(Body);
        }

        /// <summary>Moves the body where its transform has gone.</summary>
        internal virtual void Follow()
        {
            if (transform.hasChanged)
            {
                body.Pose = Conversion.PoseOf(transform);
                transform.hasChanged = false;
            }
        }

        internal Pose NativePose => body.Pose;

        internal virtual BodyOptions Options()
        {
            var options = new BodyOptions { Kind = Kind, Pose = Conversion.PoseOf(transform) };
            if (material != null)
            {
                options.Stiffness = material.stiffness;
                options.Damping = material.damping;
                options.Friction = material.friction;
            }
            return options;
        }

        /// <summary>Null if there is none. A mesh is readable if its import settings say so.</summary>
        private Model ModelFrom(ModelSource models)
        {
            if (!string.IsNullOrEmpty(gltfFile))
            {
                return models.Of(Path.Combine(Application.streamingAssetsPath, gltfFile));
            }
            Mesh touched = mesh;
            if (touched == null)
            {
                MeshFilter filter = GetComponent<MeshFilter>();
                touched = filter == null ? null : filter.sharedMesh;
            }
            return touched == null || !touched.isReadable ? null : models.Of(touched, transform.lossyScale);
        }
    }
}
