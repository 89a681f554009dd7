// SPDX-License-Identifier: MIT
// Made from palpate.h by bindings/gen/generate.py; do not edit.
using System;
using System.Runtime.InteropServices;
using System.Security;

namespace Palpate
{
    /// <summary>palpate.h as it is: its constants, structs and functions under their own names, handles as IntPtr.
    /// Nothing is checked here.</summary>
    [SuppressUnmanagedCodeSecurity]
    public static unsafe class Raw
    {
        /// <summary>Found by the loader as libpalpate.so.</summary>
        public const string Library = "palpate";

        public const int PLP_VERSION_MAJOR = 0;
        public const int PLP_VERSION_MINOR = 1;
        public const int PLP_VERSION_PATCH = 0;

        public const int PLP_OK = 0;
        public const int PLP_ERROR_INVALID_ARGUMENT = -1;
        public const int PLP_ERROR_INVALID_HANDLE = -2;
        public const int PLP_ERROR_OUT_OF_MEMORY = -3;
        public const int PLP_ERROR_FILE_NOT_FOUND = -4;
        public const int PLP_ERROR_FILE_READ = -5;
        public const int PLP_ERROR_BAD_FORMAT = -6;
        public const int PLP_ERROR_UNSUPPORTED = -7;
        public const int PLP_ERROR_NO_TRIANGLES = -8;
        public const int PLP_ERROR_NON_FINITE = -9;
        public const int PLP_ERROR_LIMIT = -10;
        public const int PLP_ERROR_UNSAFE_PATH = -11;
        public const int PLP_ERROR_WRONG_STATE = -12;
        public const int PLP_ERROR_DEVICE = -13;
        public const int PLP_ERROR_FILE_WRITE = -14;
        public const int PLP_ERROR_INTERNAL = -100;

        public const int PLP_LOG_ERROR = 0;
        public const int PLP_LOG_WARNING = 1;
        public const int PLP_LOG_INFO = 2;
        public const int PLP_LOG_DEBUG = 3;

        public const int PLP_MODEL_DOUBLE_SIDED = 1;
        public const int PLP_MODEL_KEEP_WINDING = 2;

        public const int PLP_TYPE_NONE = 0;
        public const int PLP_TYPE_FLOAT32 = 1;
        public const int PLP_TYPE_FLOAT64 = 2;
        public const int PLP_TYPE_UINT8 = 3;
        public const int PLP_TYPE_UINT16 = 4;
        public const int PLP_TYPE_UINT32 = 5;

        public const int PLP_ORIENTATION_OPEN = 0;
        public const int PLP_ORIENTATION_OUTWARD = 1;
        public const int PLP_ORIENTATION_INWARD = 2;
        public const int PLP_ORIENTATION_MIXED = 3;

        public const int PLP_FEATURE_FACE = 0;
        public const int PLP_FEATURE_EDGE = 1;
        public const int PLP_FEATURE_VERTEX = 2;

        public const int PLP_STATUS_BY_DESCENT = 1;
        public const int PLP_STATUS_CUT = 2;
        public const int PLP_STATUS_WAITING = 4;
        public const int PLP_STATUS_WALL = 8;

        public const int PLP_LAW_SPRINGS = 0;
        public const int PLP_LAW_SMOOTH = 1;

        public const int PLP_MODE_GLOBAL = 0;
        public const int PLP_MODE_DESCENT = 1;
        public const int PLP_MODE_CERTIFIED = 2;

        public const int PLP_BODY_STATIC = 0;
        public const int PLP_BODY_MOVING = 1;
        public const int PLP_BODY_TOOL = 2;

        public const int PLP_CONDITION_READY = 0;
        public const int PLP_CONDITION_NEEDS_CALIBRATION = 1;
        public const int PLP_CONDITION_WARM_MOTORS = 2;
        public const int PLP_CONDITION_EXCEEDED_FORCE = 3;
        public const int PLP_CONDITION_EXCEEDED_VELOCITY = 4;
        public const int PLP_CONDITION_LOST = 5;
        public const int PLP_CONDITION_FAILED = 6;
        public const int PLP_CONDITION_NO_LIBRARY = 7;
        public const int PLP_CONDITION_WRONG_LIBRARY = 8;
        public const int PLP_CONDITION_CANNOT_OPEN = 9;
        public const int PLP_CONDITION_WITHHELD = 10;

        public const int PLP_SAFETY_DISARMED = 0;
        public const int PLP_SAFETY_RAMPING = 1;
        public const int PLP_SAFETY_ARMED = 2;
        public const int PLP_SAFETY_FAULT = 3;

        public const int PLP_LIMITER_LONG_TICK = 0;
        public const int PLP_LIMITER_NON_FINITE_WRENCH = 1;
        public const int PLP_LIMITER_NON_FINITE_POSE = 2;
        public const int PLP_LIMITER_POSE_JUMP = 3;
        public const int PLP_LIMITER_STALE_SERVO = 4;
        public const int PLP_LIMITER_STALE_POSE = 5;
        public const int PLP_LIMITER_FORCE_CLAMP = 6;
        public const int PLP_LIMITER_TORQUE_CLAMP = 7;
        public const int PLP_LIMITER_FORCE_SLEW = 8;
        public const int PLP_LIMITER_TORQUE_SLEW = 9;
        public const int PLP_LIMITER_RAMP = 10;
        public const int PLP_LIMITER_DEVICE = 11;

        public const int PLP_GRIP_RELEASED = 0;
        public const int PLP_GRIP_LIGHT = 1;
        public const int PLP_GRIP_FIRM = 2;
        public const int PLP_GRIP_OWN = 3;

        public const int PLP_HAND_HOLD = 0;
        public const int PLP_HAND_TAP = 1;
        public const int PLP_HAND_PRESS = 2;
        public const int PLP_HAND_SLIDE = 3;
        public const int PLP_HAND_WEDGE = 4;
        public const int PLP_HAND_CIRCLE = 5;

        public const int PLP_DEVICE_KEEP_TOOL_POSE = 1;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        public delegate void plp_log_callback(int level, byte* message, void* user);

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_pose
        {
            public fixed double position[3];
            public fixed double orientation[4];
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_wrench
        {
            public fixed double force[3];
            public fixed double torque[3];
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_space
        {
            public fixed int axes[3];
            public int reserved;
            public double metres_per_unit;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_model_options
        {
            public uint struct_size;
            public uint flags;
            public double weld_tolerance;
            public int gltf_scene;
            public uint reserved;
            public ulong max_triangles;
            public double scale;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_triangles
        {
            public uint struct_size;
            public uint reserved;
            public void* positions;
            public UIntPtr position_stride;
            public UIntPtr vertex_count;
            public void* indices;
            public UIntPtr index_stride;
            public UIntPtr triangle_count;
            public int position_type;
            public int index_type;
            public plp_space space;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_surface_counts
        {
            public ulong triangles;
            public ulong vertices;
            public ulong edges;
            public ulong boundary_edges;
            public ulong nonmanifold_edges;
            public ulong inconsistent_edges;
            public ulong components;
            public int orientation;
            public int watertight;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_model_info
        {
            public uint struct_size;
            public uint note_count;
            public plp_surface_counts source;
            public plp_surface_counts searched;
            public ulong stored_vertices;
            public ulong degenerate_triangles;
            public ulong duplicate_triangles;
            public ulong split_triangles;
            public ulong reversed_triangles;
            public ulong flipped_components;
            public ulong double_sided_triangles;
            public fixed double bounds_min[3];
            public fixed double bounds_max[3];
            public double diagonal;
            public ulong mesh_bytes;
            public ulong tree_bytes;
            public ulong tree_nodes;
            public double load_us;
            public double tree_us;
            public ulong read_bytes;
            public ulong decoded_bytes;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_lmd
        {
            public fixed double point_a[3];
            public fixed double point_b[3];
            public fixed double normal[3];
            public double distance;
            public double weight;
            public fixed double force[3];
            public ulong body_a;
            public ulong body_b;
            public uint set;
            public byte feature_a;
            public byte feature_b;
            public byte corner_a;
            public byte corner_b;
            public uint triangle_a;
            public uint triangle_b;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_overlap
        {
            public ulong body_a;
            public ulong body_b;
            public uint triangle_a;
            public uint triangle_b;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_work
        {
            public ulong bodies;
            public ulong body_pairs;
            public ulong node_pairs;
            public ulong triangle_pairs;
            public ulong descents;
            public ulong descent_steps;
            public ulong front_entries;
            public ulong front_expired;
            public ulong age;
            public double global_us;
            public ulong rebuilds;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_contacts
        {
            public uint struct_size;
            public int overlap;
            public plp_lmd* lmds;
            public UIntPtr lmd_count;
            public UIntPtr lmd_stride;
            public UIntPtr set_count;
            public plp_overlap* overlaps;
            public UIntPtr overlap_count;
            public UIntPtr overlap_stride;
            public int overlaps_cut;
            public uint reserved;
            public double min_distance;
            public plp_wrench wrench;
            public double search_us;
            public plp_work work;
            public plp_lmd* springs;
            public UIntPtr spring_count;
            public uint status;
            public uint reserved2;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_query_options
        {
            public uint struct_size;
            public uint max_overlaps;
            public double cutoff;
            public double stiffness;
            public fixed double reference_point[3];
            public int law;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_scene_options
        {
            public uint struct_size;
            public uint max_overlaps;
            public plp_space space;
            public double cutoff;
            public double stiffness;
            public int mode;
            public uint global_every;
            public int law;
            public uint threads;
            public double damping;
            public double stiffness_cap;
            public double friction;
            public double fade_time;
            public double time_step;
            public uint tick_budget;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_body_options
        {
            public uint struct_size;
            public int kind;
            public IntPtr model;
            public plp_pose pose;
            public double stiffness;
            public fixed double reference_point[3];
            public double damping;
            public double friction;
            public int intangible;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_body_info
        {
            public uint struct_size;
            public int kind;
            public fixed byte name[256];
            public int node;
            public int intangible;
            public ulong above;
            public ulong triangles;
            public double stiffness;
            public double damping;
            public double friction;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_gltf_scene_options
        {
            public uint struct_size;
            public uint flags;
            public plp_model_options* model;
            public byte* tool;
            public plp_pose pose;
            public double cutoff;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_servo_options
        {
            public uint struct_size;
            public uint flags;
            public double rate;
            public int priority;
            public int cpu;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_servo_state
        {
            public uint struct_size;
            public int running;
            public int priority;
            public int cpu;
            public double wanted_rate;
            public double rate;
            public ulong ticks;
            public ulong missed;
            public ulong skipped;
            public fixed double work_us[4];
            public fixed double lateness_us[4];
            public ulong waiting_ticks;
            public ulong cut_ticks;
            public ulong preparations;
            public ulong searches;
            public ulong result_age;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_device_info
        {
            public uint struct_size;
            public uint buttons;
            public uint sensed;
            public uint actuated;
            public fixed byte uri[256];
            public fixed byte name[256];
            public fixed byte serial[64];
            public double max_force;
            public double continuous_force;
            public double max_torque;
            public double continuous_torque;
            public double max_stiffness;
            public double max_damping;
            public double position_resolution;
            public double angle_resolution;
            public double update_rate;
            public fixed double workspace_min[3];
            public fixed double workspace_max[3];
            public int condition;
            public uint reserved;
            public fixed byte status[512];
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_device_state
        {
            public uint struct_size;
            public uint buttons;
            public plp_pose pose;
            public fixed double linear_velocity[3];
            public fixed double angular_velocity[3];
            public double time;
            public ulong sequence;
            public int calibrated;
            public int safety;
            public plp_wrench commanded;
            public plp_wrench applied;
            public double gain;
            public uint limiters;
            public int unactuated;
            public ulong ticks;
            public fixed ulong limiter_ticks[16];
            public int condition;
            public uint reserved;
            public double temperature;
            public ulong lost;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_safety_limits
        {
            public uint struct_size;
            public uint dead_man;
            public double max_force;
            public double max_torque;
            public double force_slew;
            public double torque_slew;
            public double max_speed;
            public double max_turn_rate;
            public double watchdog;
            public double ramp_time;
            public double fault_hold;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_hand_options
        {
            public uint struct_size;
            public int grip;
            public int script;
            public uint buttons;
            public double mass;
            public double damping;
            public double stiffness;
            public double inertia;
            public double angular_damping;
            public double angular_stiffness;
            public plp_pose origin;
            public fixed double into[3];
            public fixed double along[3];
            public double depth;
            public double travel;
            public double twist;
            public double period;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_device_mapping
        {
            public uint struct_size;
            public uint flags;
            public plp_pose scene_from_base;
            public plp_pose handle_from_tool;
            public double motion_scale;
            public double force_scale;
            public uint clutch_buttons;
            public uint reserved;
            public fixed double torque_lever[3];
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_recording
        {
            public uint struct_size;
            public int running;
            public ulong ticks;
            public ulong lost;
            public ulong bytes;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_trace_info
        {
            public uint struct_size;
            public int complete;
            public ulong ticks;
            public ulong lost;
            public ulong bodies;
            public ulong bytes;
            public double duration;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_trace_body
        {
            public uint struct_size;
            public int kind;
            public ulong body;
            public byte* model_name;
            public ulong model_triangles;
            public ulong model_hash;
            public double stiffness;
            public double damping;
            public double friction;
            public fixed double reference_point[3];
            public ulong first_tick;
            public ulong end_tick;
            public int intangible;
            public uint reserved;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_trace_move
        {
            public ulong body;
            public plp_pose pose;
        }

        [StructLayout(LayoutKind.Sequential)]
        public struct plp_trace_tick
        {
            public uint struct_size;
            public uint status;
            public ulong step;
            public ulong lost;
            public double time;
            public double clock;
            public double time_step;
            public double cutoff;
            public double stiffness;
            public double damping;
            public double stiffness_cap;
            public double friction;
            public int mode;
            public int law;
            public ulong tool;
            public plp_pose tool_pose;
            public plp_wrench wrench;
            public double min_distance;
            public ulong set_count;
            public ulong lmd_count;
            public ulong overlap_count;
            public int overlap;
            public uint reserved;
            public double step_us;
            public plp_trace_move* moves;
            public UIntPtr move_count;
            public UIntPtr move_stride;
            public ulong* removed;
            public UIntPtr removed_count;
        }

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint plp_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* plp_version_string();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* plp_result_string(int result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* plp_last_error();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_set_log_callback(IntPtr callback, void* user);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_model_options_init(plp_model_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_load_file(byte* path, plp_model_options* options, IntPtr* model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_load_memory(void* data, UIntPtr size, byte* folder,
                                                       plp_model_options* options, IntPtr* model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_triangles_init(plp_triangles* triangles, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_create_from_triangles(plp_triangles* triangles, plp_model_options* options,
                                                                 IntPtr* model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_retain(IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_release(IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_model_info_init(plp_model_info* info, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_get_info(IntPtr model, plp_model_info* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* plp_model_note(IntPtr model, uint index);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_prepare(IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_get_hash(IntPtr model, ulong* hash);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_get_vertices(IntPtr model, double* positions, UIntPtr capacity,
                                                        UIntPtr* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_model_get_triangles(IntPtr model, uint* corners, uint* sources, UIntPtr capacity,
                                                         UIntPtr* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_contacts_init(plp_contacts* contacts, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_query_result_create(IntPtr* result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_query_result_release(IntPtr result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_query_options_init(plp_query_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_query(IntPtr a, IntPtr b, plp_pose* a_from_b, plp_query_options* options,
                                           IntPtr result);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_query_result_get(IntPtr result, plp_contacts* contacts);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_scene_options_init(plp_scene_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_create(plp_scene_options* options, IntPtr* scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_release(IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_body_options_init(plp_body_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_add_body(IntPtr scene, plp_body_options* options, ulong* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_remove_body(IntPtr scene, ulong body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_pose(IntPtr scene, ulong body, plp_pose* pose);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_pose(IntPtr scene, ulong body, plp_pose* pose);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_cutoff(IntPtr scene, double cutoff);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_mode(IntPtr scene, int mode);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_law(IntPtr scene, int law);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_stiffness(IntPtr scene, double stiffness);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_damping(IntPtr scene, double damping);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_stiffness_cap(IntPtr scene, double stiffness_cap);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_friction(IntPtr scene, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_step(IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_contacts(IntPtr scene, plp_contacts* contacts);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_body_info_init(plp_body_info* info, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_body_info(IntPtr scene, ulong body, plp_body_info* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_list_bodies(IntPtr scene, ulong* bodies, UIntPtr capacity, UIntPtr* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_find_body(IntPtr scene, byte* name, ulong* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_body_model(IntPtr scene, ulong body, IntPtr* model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_gltf_scene_options_init(plp_gltf_scene_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_load_gltf(IntPtr scene, byte* path, plp_gltf_scene_options* options,
                                                     ulong* bodies, UIntPtr capacity, UIntPtr* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_node_matrix(IntPtr scene, ulong body, double* matrix);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_servo_options_init(plp_servo_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_start(IntPtr scene, plp_servo_options* options);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_stop(IntPtr scene);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_servo_state_init(plp_servo_state* state, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_servo(IntPtr scene, plp_servo_state* state);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_shutdown_all();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_device_info_init(plp_device_info* info, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_list(plp_device_info* infos, UIntPtr capacity, UIntPtr* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_open(byte* uri, IntPtr* device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_retain(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_release(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_get_info(IntPtr device, plp_device_info* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_device_state_init(plp_device_state* state, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_get_state(IntPtr device, plp_device_state* state);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_arm(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_calibrate(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_disarm(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_safety_limits_init(plp_safety_limits* limits, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_set_limits(IntPtr device, plp_safety_limits* limits);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_hand_options_init(plp_hand_options* options, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_set_hand(IntPtr device, plp_hand_options* options);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_set_hand_poses(IntPtr device, double* times, plp_pose* poses,
                                                           UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_device_place_in_hand(IntPtr device);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_device_mapping_init(plp_device_mapping* mapping, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_set_device(IntPtr scene, IntPtr device, plp_device_mapping* mapping);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_recording_init(plp_recording* recording, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_record(IntPtr scene, byte* path);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_stop_recording(IntPtr scene, plp_recording* recording);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_scene_get_recording(IntPtr scene, plp_recording* recording);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_open(byte* path, IntPtr* trace);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_release(IntPtr trace);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_trace_info_init(plp_trace_info* info, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_get_info(IntPtr trace, plp_trace_info* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_get_options(IntPtr trace, plp_scene_options* options);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_trace_body_init(plp_trace_body* body, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_get_body(IntPtr trace, ulong index, plp_trace_body* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void plp_trace_tick_init(plp_trace_tick* tick, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_read(IntPtr trace, ulong index, plp_trace_tick* tick);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_get_contacts(IntPtr trace, plp_contacts* contacts);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int plp_trace_place(IntPtr trace, ulong tick, ulong recorded, IntPtr scene, ulong body);
    }
}
