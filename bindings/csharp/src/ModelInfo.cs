// SPDX-License-Identifier: MIT
namespace Palpate
{
    /// <summary>How the closed surfaces of a model wind.</summary>
    public enum Orientation
    {
        /// <summary>Not closed, so there is no inside.</summary>
        Open = Raw.PLP_ORIENTATION_OPEN,
        Outward = Raw.PLP_ORIENTATION_OUTWARD,
        Inward = Raw.PLP_ORIENTATION_INWARD,

        /// <summary>Neighbours disagree.</summary>
        Mixed = Raw.PLP_ORIENTATION_MIXED
    }

    /// <summary>Counts of a surface. Vertices are welded; edges are counted over triangles whose three corners differ.
    /// </summary>
    public sealed class SurfaceCounts
    {
        internal SurfaceCounts(Raw.plp_surface_counts counts)
        {
            Triangles = counts.triangles;
            Vertices = counts.vertices;
            Edges = counts.edges;
            BoundaryEdges = counts.boundary_edges;
            NonmanifoldEdges = counts.nonmanifold_edges;
            InconsistentEdges = counts.inconsistent_edges;
            Components = counts.components;
            Orientation = (Orientation)counts.orientation;
            Watertight = counts.watertight != 0;
        }

        public ulong Triangles { get; }
        public ulong Vertices { get; }
        public ulong Edges { get; }
        public ulong BoundaryEdges { get; }
        public ulong NonmanifoldEdges { get; }
        public ulong InconsistentEdges { get; }
        public ulong Components { get; }
        public Orientation Orientation { get; }
        public bool Watertight { get; }
    }

    /// <summary>What a model is and what was done to it: lengths in metres, times in microseconds.</summary>
    public sealed unsafe class ModelInfo
    {
        internal ModelInfo(Raw.plp_model_info info)
        {
            Source = new SurfaceCounts(info.source);
            Searched = new SurfaceCounts(info.searched);
            StoredVertices = info.stored_vertices;
            DegenerateTriangles = info.degenerate_triangles;
            DuplicateTriangles = info.duplicate_triangles;
            SplitTriangles = info.split_triangles;
            ReversedTriangles = info.reversed_triangles;
            FlippedComponents = info.flipped_components;
            DoubleSidedTriangles = info.double_sided_triangles;
            BoundsMin = new Vector3d(info.bounds_min[0], info.bounds_min[1], info.bounds_min[2]);
            BoundsMax = new Vector3d(info.bounds_max[0], info.bounds_max[1], info.bounds_max[2]);
            Diagonal = info.diagonal;
            MeshBytes = info.mesh_bytes;
            TreeBytes = info.tree_bytes;
            TreeNodes = info.tree_nodes;
            LoadUs = info.load_us;
            TreeUs = info.tree_us;
            ReadBytes = info.read_bytes;
            DecodedBytes = info.decoded_bytes;
        }

        /// <summary>As it came, welded only.</summary>
        public SurfaceCounts Source { get; }

        /// <summary>As it is searched, after repair.</summary>
        public SurfaceCounts Searched { get; }

        public ulong StoredVertices { get; }
        public ulong DegenerateTriangles { get; }
        public ulong DuplicateTriangles { get; }
        public ulong SplitTriangles { get; }
        public ulong ReversedTriangles { get; }
        public ulong FlippedComponents { get; }
        public ulong DoubleSidedTriangles { get; }
        public Vector3d BoundsMin { get; }
        public Vector3d BoundsMax { get; }
        public double Diagonal { get; }
        public ulong MeshBytes { get; }

        /// <summary>0 as long as the hierarchy is not built.</summary>
        public ulong TreeBytes { get; }

        public ulong TreeNodes { get; }
        public double LoadUs { get; }
        public double TreeUs { get; }

        /// <summary>Of the glTF and of the external buffers that its triangles need: no others are opened.</summary>
        public ulong ReadBytes { get; }

        /// <summary>Of the accessors and compressed streams that were decoded to triangles.</summary>
        public ulong DecodedBytes { get; }
    }
}
