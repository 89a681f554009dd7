// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How Scene.LoadGltf takes a file into a scene.</summary>
    public sealed unsafe class GltfSceneOptions
    {
        internal Raw.plp_gltf_scene_options Struct;

        public GltfSceneOptions()
        {
            fixed (Raw.plp_gltf_scene_options* options = &Struct)
            {
                Raw.plp_gltf_scene_options_init(options, (UIntPtr)sizeof(Raw.plp_gltf_scene_options));
            }
        }

        /// <summary>Name of the node that is the tool, with all that is below it; or its index, such as "/nodes/5"; null: no
        /// tool.</summary>
        public string Tool { get; set; }

        /// <summary>How meshes become models, and which of the file's scenes; null for the defaults.</summary>
        public ModelOptions Model { get; set; }

        /// <summary>Of the file's scene in the scene's space.</summary>
        public Pose Pose
        {
            get
            {
                fixed (Raw.plp_pose* pose = &Struct.pose)
                {
                    return *(Pose*)pose;
                }
            }
            set => Struct.pose = *(Raw.plp_pose*)&value;
        }

        /// <summary>The scene's from now on, units of its space, positive; 0: as it is.</summary>
        public double Cutoff
        {
            get => Struct.cutoff;
            set => Struct.cutoff = value;
        }
    }

    /// <summary>What a body is, as it was added.</summary>
    public sealed unsafe class BodyInfo
    {
        internal BodyInfo(Raw.plp_body_info info)
        {
            Name = Utf8.Text(info.name);
            Kind = (BodyKind)info.kind;
            Node = info.node;
            Intangible = info.intangible != 0;
            Above = info.above;
            Triangles = (long)info.triangles;
            Stiffness = info.stiffness;
            Damping = info.damping;
            Friction = info.friction;
        }

        /// <summary>Of its node, cut after 255 bytes; empty if it has none.</summary>
        public string Name { get; }

        public BodyKind Kind { get; }

        /// <summary>Index in the glTF file that it comes from; -1: from none.</summary>
        public int Node { get; }

        /// <summary>The tool passes through it.</summary>
        public bool Intangible { get; }

        /// <summary>Id of the nearest body above it in the file's hierarchy; 0: none.</summary>
        public ulong Above { get; }

        /// <summary>Of its model, as it is searched.</summary>
        public long Triangles { get; }

        /// <summary>N/m against the tool; 0: the scene's.</summary>
        public double Stiffness { get; }

        /// <summary>N·s/m against the tool; 0: the scene's.</summary>
        public double Damping { get; }

        /// <summary>Against the tool; 0: the scene's; negative: none.</summary>
        public double Friction { get; }
    }
}
