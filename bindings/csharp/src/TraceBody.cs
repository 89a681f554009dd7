// SPDX-License-Identifier: MIT

namespace Palpate
{
    /// <summary>A body of a trace, as it was added.</summary>
    public sealed unsafe class TraceBody
    {
        internal TraceBody(Raw.plp_trace_body body)
        {
            Id = body.body;
            Kind = (BodyKind)body.kind;
            ModelName = Utf8.Text(body.model_name);
            ModelTriangles = (long)body.model_triangles;
            ModelHash = body.model_hash;
            Stiffness = body.stiffness;
            Damping = body.damping;
            Friction = body.friction;
            ReferencePoint = *(Vector3d*)body.reference_point;
            FirstTick = (long)body.first_tick;
            EndTick = (long)body.end_tick;
            Intangible = body.intangible != 0;
        }

        /// <summary>As its scene called it.</summary>
        public ulong Id { get; }

        public BodyKind Kind { get; }

        /// <summary>Of its file or, of a body that Scene.LoadGltf made, such as "room.glb#/nodes/5".</summary>
        public string ModelName { get; }

        public long ModelTriangles { get; }

        /// <summary>Model.Hash.</summary>
        public ulong ModelHash { get; }

        /// <summary>N/m against the tool; 0: the scene's.</summary>
        public double Stiffness { get; }

        /// <summary>N·s/m of a closing spring; 0: the scene's.</summary>
        public double Damping { get; }

        /// <summary>Coulomb's coefficient; 0: the scene's; negative: none.</summary>
        public double Friction { get; }

        /// <summary>Its own frame, scene units.</summary>
        public Vector3d ReferencePoint { get; }

        /// <summary>The first step that had it; Trace.Count if none had.</summary>
        public long FirstTick { get; }

        /// <summary>The first step without it; Trace.Count if it stayed.</summary>
        public long EndTick { get; }

        /// <summary>The tool passes through it.</summary>
        public bool Intangible { get; }

        /// <summary>To add it to another scene.</summary>
        public BodyOptions Options() => new BodyOptions
        {
            Kind = Kind, Stiffness = Stiffness, Damping = Damping, Friction = Friction, Intangible = Intangible,
            ReferencePoint = ReferencePoint
        };
    }
}
