// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>What a body is in its scene.</summary>
    public enum BodyKind
    {
        Static = Raw.PLP_BODY_STATIC,
        Moving = Raw.PLP_BODY_MOVING,

        /// <summary>At most one in a scene.</summary>
        Tool = Raw.PLP_BODY_TOOL
    }

    /// <summary>How a body is added.</summary>
    public sealed unsafe class BodyOptions
    {
        internal Raw.plp_body_options Struct;

        public BodyOptions()
        {
            fixed (Raw.plp_body_options* options = &Struct)
            {
                Raw.plp_body_options_init(options, (UIntPtr)sizeof(Raw.plp_body_options));
            }
        }

        public BodyKind Kind
        {
            get => (BodyKind)Struct.kind;
            set => Struct.kind = (int)value;
        }

        /// <summary>Of the model's frame in the scene's space.</summary>
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

        /// <summary>N/m against the tool; 0: the scene's.</summary>
        public double Stiffness
        {
            get => Struct.stiffness;
            set => Struct.stiffness = value;
        }

        /// <summary>N·s/m of a closing spring; 0: the scene's.</summary>
        public double Damping
        {
            get => Struct.damping;
            set => Struct.damping = value;
        }

        /// <summary>Coulomb's coefficient; 0: the scene's; negative: none.</summary>
        public double Friction
        {
            get => Struct.friction;
            set => Struct.friction = value;
        }

        /// <summary>The tool passes through it.</summary>
        public bool Intangible
        {
            get => Struct.intangible != 0;
            set => Struct.intangible = value ? 1 : 0;
        }

        /// <summary>Of the tool, its own frame, scene units: torques are about it.</summary>
        public Vector3d ReferencePoint
        {
            get
            {
                fixed (double* point = Struct.reference_point)
                {
                    return *(Vector3d*)point;
                }
            }
            set
            {
                fixed (double* point = Struct.reference_point)
                {
                    *(Vector3d*)point = value;
                }
            }
        }
    }

    /// <summary>A body of one scene, made by Scene.Add or Scene.LoadGltf.</summary>
    public readonly unsafe struct Body
    {
        private readonly Scene scene;

        internal Body(Scene scene, ulong id)
        {
            this.scene = scene;
            Id = id;
        }

        /// <summary>What BodyA and BodyB of contacts name.</summary>
        public ulong Id { get; }

        /// <summary>In the scene's space. A static body may be moved, too.</summary>
        public Pose Pose
        {
            get
            {
                Pose pose;
                Scene.Check(Raw.plp_scene_get_pose(Scene.Handle, Id, (Raw.plp_pose*)&pose));
                return pose;
            }
            set => Scene.Check(Raw.plp_scene_set_pose(Scene.Handle, Id, (Raw.plp_pose*)&value));
        }

        public BodyInfo Info
        {
            get
            {
                Raw.plp_body_info info;
                Raw.plp_body_info_init(&info, (UIntPtr)sizeof(Raw.plp_body_info));
                Scene.Check(Raw.plp_scene_get_body_info(Scene.Handle, Id, &info));
                return new BodyInfo(info);
            }
        }

        /// <summary>Its model, which bodies may share, in a wrapper of its own: dispose it.</summary>
        public Model Model
        {
            get
            {
                IntPtr model;
                Scene.Check(Raw.plp_scene_get_body_model(Scene.Handle, Id, &model));
                return new Model(model);
            }
        }

        /// <summary>What `matrix` its node has in its glTF file if that is to show it where it is now: 16 numbers, column
        /// by column, in metres and the file's axes whatever the space of the scene.</summary>
        public double[] NodeMatrix()
        {
            var matrix = new double[16];
            fixed (double* numbers = matrix)
            {
                Scene.Check(Raw.plp_scene_get_node_matrix(Scene.Handle, Id, numbers));
            }
            return matrix;
        }

        public void Remove() => Scene.Check(Raw.plp_scene_remove_body(Scene.Handle, Id));

        internal Scene Scene => scene ?? throw new InvalidOperationException("This body belongs to no scene.");
    }
}
