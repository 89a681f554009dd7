// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>How a model is made from what comes.</summary>
    public sealed unsafe class ModelOptions
    {
        internal Raw.plp_model_options Struct;

        public ModelOptions()
        {
            fixed (Raw.plp_model_options* options = &Struct)
            {
                Raw.plp_model_options_init(options, (UIntPtr)sizeof(Raw.plp_model_options));
            }
        }

        /// <summary>Metres; 0 welds exactly equal positions only.</summary>
        public double WeldTolerance
        {
            get => Struct.weld_tolerance;
            set => Struct.weld_tolerance = value;
        }

        /// <summary>Both sides of every triangle are touched, also of a closed surface's inside.</summary>
        public bool DoubleSided
        {
            get => HasFlag(Raw.PLP_MODEL_DOUBLE_SIDED);
            set => SetFlag(Raw.PLP_MODEL_DOUBLE_SIDED, value);
        }

        /// <summary>Trust the winding as it comes: turn nothing.</summary>
        public bool KeepWinding
        {
            get => HasFlag(Raw.PLP_MODEL_KEEP_WINDING);
            set => SetFlag(Raw.PLP_MODEL_KEEP_WINDING, value);
        }

        /// <summary>Index of the glTF scene; -1 for the file's default one.</summary>
        public int GltfScene
        {
            get => Struct.gltf_scene;
            set => Struct.gltf_scene = value;
        }

        /// <summary>0 for 100,000,000.</summary>
        public ulong MaxTriangles
        {
            get => Struct.max_triangles;
            set => Struct.max_triangles = value;
        }

        /// <summary>All positions are multiplied by it before anything else.</summary>
        public double Scale
        {
            get => Struct.scale;
            set => Struct.scale = value;
        }

        private bool HasFlag(int flag) => (Struct.flags & (uint)flag) != 0;

        private void SetFlag(int flag, bool on) =>
            Struct.flags = on ? Struct.flags | (uint)flag : Struct.flags & ~(uint)flag;
    }

    /// <summary>A triangle model: immutable, and shared between scenes and threads. Scenes keep what they use.</summary>
    public sealed unsafe class Model : IDisposable
    {
        private readonly ModelHandle handle;

        internal Model(IntPtr value)
        {
            handle = new ModelHandle(value);
        }

        /// <summary>Loads a .gltf or .glb file, the whole scene baked into one model. External buffers come only from
        /// the file's own folder or below.</summary>
        public static Model Load(string path, ModelOptions options = null)
        {
            Raw.plp_model_options how = (options ?? new ModelOptions()).Struct;
            IntPtr value;
            fixed (byte* name = Utf8.Bytes(path ?? throw new ArgumentNullException(nameof(path)), nameof(path)))
            {
                PalpateException.Check(Raw.plp_model_load_file(name, &how, &value));
            }
            return new Model(value);
        }

        /// <summary>From the bytes of a .gltf or .glb file.</summary>
        /// <param name="folder">Where external buffers are; null if there are none.</param>
        public static Model FromBytes(ReadOnlySpan<byte> data, string folder = null, ModelOptions options = null)
        {
            Raw.plp_model_options how = (options ?? new ModelOptions()).Struct;
            IntPtr value;
            fixed (byte* bytes = &MemoryMarshal.GetReference(data))
            fixed (byte* name = Utf8.Bytes(folder, nameof(folder)))
            {
                PalpateException.Check(
                    Raw.plp_model_load_memory(bytes, (UIntPtr)(uint)data.Length, name, &how, &value));
            }
            return new Model(value);
        }

        /// <summary>From triangles: three numbers a vertex, three indices a triangle, counter-clockwise seen from
        /// outside; without indices every three vertices are a triangle. They are copied.</summary>
        /// <param name="space">Of the positions; null for Palpate's own. A mirrored one turns the winding.</param>
        public static Model FromTriangles(ReadOnlySpan<float> positions, ReadOnlySpan<int> indices = default,
                                          Space? space = null, ModelOptions options = null)
        {
            fixed (float* vertices = &MemoryMarshal.GetReference(positions))
            {
                return Create(vertices, Raw.PLP_TYPE_FLOAT32, positions.Length, indices, space, options);
            }
        }

        /// <summary>The same from double precision.</summary>
        public static Model FromTriangles(ReadOnlySpan<double> positions, ReadOnlySpan<int> indices = default,
                                          Space? space = null, ModelOptions options = null)
        {
            fixed (double* vertices = &MemoryMarshal.GetReference(positions))
            {
                return Create(vertices, Raw.PLP_TYPE_FLOAT64, positions.Length, indices, space, options);
            }
        }

        /// <summary>From the caller's own buffers, of any stride and type: Raw.plp_triangles says how.</summary>
        public static Model FromTriangles(ref Raw.plp_triangles triangles, ModelOptions options = null)
        {
            Raw.plp_model_options how = (options ?? new ModelOptions()).Struct;
            IntPtr value;
            fixed (Raw.plp_triangles* what = &triangles)
            {
                PalpateException.Check(Raw.plp_model_create_from_triangles(what, &how, &value));
            }
            return new Model(value);
        }

        /// <summary>For functions of Raw that have no other form here; throws if the model is disposed.</summary>
        public IntPtr Handle => handle.Value;

        public ModelInfo Info => new ModelInfo(GetInfo());

        /// <summary>Tells models apart: the same geometry gives the same, whatever it came from.</summary>
        public ulong Hash
        {
            get
            {
                ulong hash;
                PalpateException.Check(Raw.plp_model_get_hash(handle.Value, &hash));
                GC.KeepAlive(this);
                return hash;
            }
        }

        /// <summary>One sentence about each thing that was repaired, kept or skipped.</summary>
        public string[] Notes()
        {
            var notes = new string[GetInfo().note_count];
            for (int i = 0; i < notes.Length; ++i)
            {
                notes[i] = Utf8.Text(Raw.plp_model_note(handle.Value, (uint)i));
            }
            GC.KeepAlive(this);
            return notes;
        }

        /// <summary>A copy of the welded vertices as they are searched: x, y and z of each in metres.</summary>
        public double[] Vertices()
        {
            UIntPtr count;
            PalpateException.Check(Raw.plp_model_get_vertices(handle.Value, null, UIntPtr.Zero, &count));
            var positions = new double[3 * (long)count];
            fixed (double* numbers = positions)
            {
                PalpateException.Check(Raw.plp_model_get_vertices(handle.Value, numbers, count, &count));
            }
            GC.KeepAlive(this);
            return positions;
        }

        /// <summary>A copy of the triangles as they are searched, after repair and in no stated order: three indices
        /// into Vertices() each, counter-clockwise seen from outside.</summary>
        public uint[] Triangles()
        {
            UIntPtr count;
            PalpateException.Check(Raw.plp_model_get_triangles(handle.Value, null, null, UIntPtr.Zero, &count));
            var corners = new uint[3 * (long)count];
            fixed (uint* numbers = corners)
            {
                PalpateException.Check(Raw.plp_model_get_triangles(handle.Value, numbers, null, count, &count));
            }
            GC.KeepAlive(this);
            return corners;
        }

        /// <summary>Builds the hierarchy now rather than when something first comes near.</summary>
        public void Prepare()
        {
            PalpateException.Check(Raw.plp_model_prepare(handle.Value));
            GC.KeepAlive(this);
        }

        public void Dispose() => handle.Dispose();

        internal static IntPtr ValueOf(Model model, string name) =>
            (model ?? throw new ArgumentNullException(name)).handle.Value;

        private static Model Create(void* positions, int type, int numbers, ReadOnlySpan<int> indices, Space? space,
                                    ModelOptions options)
        {
            RequireThrees(numbers, nameof(positions));
            RequireThrees(indices.Length, nameof(indices));
            Raw.plp_triangles triangles;
            Raw.plp_triangles_init(&triangles, (UIntPtr)sizeof(Raw.plp_triangles));
            triangles.positions = positions;
            triangles.position_type = type;
            triangles.vertex_count = (UIntPtr)(uint)(numbers / 3);
            if (space.HasValue)
            {
                Space given = space.Value;
                triangles.space = *(Raw.plp_space*)&given;
            }
            // A negative index becomes one that is out of range.
            fixed (int* corners = &MemoryMarshal.GetReference(indices))
            {
                triangles.indices = corners;
                triangles.triangle_count = (UIntPtr)(uint)(indices.Length / 3);
                return FromTriangles(ref triangles, options);
            }
        }

        private static void RequireThrees(int numbers, string name)
        {
            if (numbers % 3 != 0)
            {
                throw new ArgumentException($"are {numbers} numbers, which is no multiple of three", name);
            }
        }

        private Raw.plp_model_info GetInfo()
        {
            Raw.plp_model_info info;
            Raw.plp_model_info_init(&info, (UIntPtr)sizeof(Raw.plp_model_info));
            PalpateException.Check(Raw.plp_model_get_info(handle.Value, &info));
            GC.KeepAlive(this);
            return info;
        }
    }
}
