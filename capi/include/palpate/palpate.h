/* SPDX-License-Identifier: MIT */
/**
 * @file palpate.h
 * @brief Palpate: touch triangle models. The whole C interface; compiles as C99 and as C++17.
 *
 * Units are metres, seconds, newtons and newton-metres; frames are right-handed; quaternions are x y z w. A
 * scene may be told another space (plp_space). Points, forces and poses are double precision. A coordinate,
 * cutoff or stiffness that a caller gives for a pose, query, scene or body is at most 1e15 (metres, N/m);
 * more, infinite and NaN are PLP_ERROR_INVALID_ARGUMENT.
 *
 * **Errors.** Every function that can fail returns a plp_result: 0 is success, positive is success with a
 * remark, negative is an error. plp_last_error() has one sentence for the last error of the calling thread.
 * After an error nothing has changed and outputs are untouched, unless a function says otherwise.
 *
 * **Memory.** A call that is refused memory ends in PLP_ERROR_OUT_OF_MEMORY, and may be made again. While a
 * glTF file is read or a hierarchy is built, this library has a handler of its own for operator new
 * (std::set_new_handler), which gives back a reserve and then asks the program's.
 *
 * **Processes.** The child of a fork() has none of the threads of this library: it may exec or end, and may
 * use what had neither threads nor a device of its own at the fork.
 *
 * **Growing structs.** Structs that may grow start with `struct_size`. Fill one with its `plp_*_init()`,
 * which is told `sizeof` the struct as your program knows it and writes no more than that, and change what
 * you need. A null struct and a size that no version has are left alone. Zero in a field that was appended
 * later means the behaviour from before it existed.
 *
 * **Handles.** A handle is an opaque value, never an address: using one after its release, or one of another
 * kind, is PLP_ERROR_INVALID_HANDLE and never a crash. The null handle is invalid everywhere but in release
 * functions.
 *
 * **Thread safety** is stated for each function as one of: `any` (from any thread at any time), `object` (one
 * thread at a time for each object that is passed), `servo` (as `object`; also allocates, locks, logs and
 * blocks never once the same situation has been met before).
 */
#ifndef PALPATE_PALPATE_H
#define PALPATE_PALPATE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What makes a function leave the shared library, or come from it; nothing with PLP_STATIC. */
#if defined(PLP_STATIC)
#define PLP_API
#elif defined(_WIN32)
#if defined(PLP_BUILD)
#define PLP_API __declspec(dllexport)
#else
#define PLP_API __declspec(dllimport)
#endif
#else
#define PLP_API __attribute__((visibility("default")))
#endif

/* ------------------------------------------------------------------------------------------------ versions,
 * errors */

/** Version of this header. Another one is another interface: see capi/ABI.md. */
#define PLP_VERSION_MAJOR 0
/** Version of this header. Grows with what is added. */
#define PLP_VERSION_MINOR 1
/** Version of this header. Grows with what is mended. */
#define PLP_VERSION_PATCH 0

/** The outcome of a call: see the PLP_OK, PLP_REMARK_* and PLP_ERROR_* values. */
typedef int32_t plp_result;

enum {
  PLP_OK = 0,

  PLP_ERROR_INVALID_ARGUMENT = -1, /**< null, NaN, out of range, a struct_size that no version has */
  PLP_ERROR_INVALID_HANDLE = -2,   /**< null, released, or of another kind */
  PLP_ERROR_OUT_OF_MEMORY = -3,
  PLP_ERROR_FILE_NOT_FOUND = -4,
  PLP_ERROR_FILE_READ = -5,    /**< the file exists but could not be read */
  PLP_ERROR_BAD_FORMAT = -6,   /**< not what it should be, such as glTF or a trace, or breaks its own rules */
  PLP_ERROR_UNSUPPORTED = -7,  /**< glTF that requires an extension this library does not have */
  PLP_ERROR_NO_TRIANGLES = -8, /**< nothing to touch: no triangle of positive area */
  PLP_ERROR_NON_FINITE = -9,   /**< an infinite or NaN coordinate */
  PLP_ERROR_LIMIT = -10,       /**< larger than a limit that the options or this library set */
  PLP_ERROR_UNSAFE_PATH = -11, /**< a glTF names a buffer outside its own folder */
  PLP_ERROR_WRONG_STATE = -12, /**< not while things are as they are: a servo steps the scene, or another
                                  scene has the device */
  PLP_ERROR_DEVICE = -13,      /**< a device that cannot be opened */
  PLP_ERROR_FILE_WRITE = -14,  /**< a file that cannot be made or written */
  PLP_ERROR_INTERNAL = -100    /**< a defect of this library */
};

/** @brief The version of the library that is loaded, as major * 1000000 + minor * 1000 + patch.
 *  @threadsafety any @since 0.1 */
PLP_API uint32_t plp_version(void);

/** @brief The version as text, such as "0.1.0". Static storage.
 *  @threadsafety any @since 0.1 */
PLP_API const char* plp_version_string(void);

/** @brief The name of a result code, such as "PLP_ERROR_BAD_FORMAT"; "unknown result" for a value that is
 * none. Static storage.
 *  @threadsafety any @since 0.1 */
PLP_API const char* plp_result_string(plp_result result);

/** @brief One sentence about the last error on the calling thread; "" if there was none.
 *  Valid until the next call of this library on the same thread.
 *  @threadsafety any @since 0.1 */
PLP_API const char* plp_last_error(void);

/** How weighty a log message is. */
typedef enum plp_log_level {
  PLP_LOG_ERROR = 0,
  PLP_LOG_WARNING = 1,
  PLP_LOG_INFO = 2,
  PLP_LOG_DEBUG = 3
} plp_log_level;

/** @brief Receives one log message. It may be called from any thread that calls this library, never from
 * inside a function of thread safety `servo`. `message` is valid during the call. It must not call this
 * library. */
typedef void (*plp_log_callback)(plp_log_level level, const char* message, void* user);

/** @brief Installs the one receiver of log messages; null removes it.
 *  @param callback the receiver or null. @param user is handed to it.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_set_log_callback(plp_log_callback callback, void* user);

/* ------------------------------------------------------------------------------------------------------------
 * space */

/** A rigid pose: x ↦ rotate(orientation, x) + position. `orientation` is a quaternion x y z w; it is
 * normalised by this library and must be finite and not zero. */
typedef struct plp_pose {
  double position[3];    /**< metres, or units of a space */
  double orientation[4]; /**< quaternion x y z w */
} plp_pose;

/** A force in newtons and a torque in newton-metres about a point that the producing function states. */
typedef struct plp_wrench {
  double force[3];  /**< N */
  double torque[3]; /**< N·m */
} plp_wrench;

/** The space that a scene's poses, points and wrenches are given in. `axes[i]` says along which Palpate axis
 * the i-th axis of that space points: ±1, ±2 or ±3 for ±x, ±y or ±z, each axis once. Palpate's own is {1, 2,
 * 3}, right-handed and, as glTF, with +y up. {-1, 2, 3} is Unity with models as UnityGLTF and glTFast load
 * them; {1, 2, -3} Unity as OpenXR gives poses; {1, -3, 2} has z up (Blender, Panda3D); {3, -1,
 * 2} with 0.01 metres per unit is Unreal. Forces stay in
 * newtons and torques in newton-metres; under a mirror torques turn as the pseudo-vectors they are. */
typedef struct plp_space {
  int32_t axes[3];        /**< ±1, ±2 or ±3, each axis once */
  int32_t reserved;       /**< 0 */
  double metres_per_unit; /**< 1e-9 to 1e9 */
} plp_space;

/* -----------------------------------------------------------------------------------------------------------
 * models */

/** A triangle model: immutable, reference counted, shared between scenes and threads. */
typedef struct plp_model_t* plp_model;

/** How a model is made from what comes. */
typedef struct plp_model_options {
  uint32_t struct_size;  /**< set by plp_model_options_init() */
  uint32_t flags;        /**< PLP_MODEL_*; an unknown one is refused */
  double weld_tolerance; /**< metres; 0 welds exactly equal positions only */
  int32_t gltf_scene;    /**< index of the glTF scene; -1 for the file's default one */
  uint32_t reserved;     /**< 0 */
  uint64_t
      max_triangles; /**< more are PLP_ERROR_LIMIT; 0 for the default of 100,000,000; at most 1,000,000,000 */
  double scale;      /**< all positions are multiplied by it before anything else; 1, or 0 for 1 */
} plp_model_options;

enum {
  PLP_MODEL_DOUBLE_SIDED =
      1, /**< both sides of every triangle are touched, also of a closed surface's inside */
  PLP_MODEL_KEEP_WINDING = 2 /**< trust the winding as it comes: turn nothing */
};

/** @brief Fills `options` with the defaults. @threadsafety any @since 0.1 */
PLP_API void plp_model_options_init(plp_model_options* options, size_t size);

/**
 * @brief Loads the triangles of a .gltf or .glb file: the whole scene baked into one model. Images, textures
 * and animations are not read. External buffers come only from the file's own folder or below.
 * @param path UTF-8. @param options null for the defaults. @param model receives the handle; release it.
 * @return PLP_ERROR_INVALID_ARGUMENT, _FILE_NOT_FOUND, _FILE_READ, _BAD_FORMAT, _UNSUPPORTED, _NO_TRIANGLES,
 * _NON_FINITE, _LIMIT, _UNSAFE_PATH or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_model_load_file(const char* path, const plp_model_options* options, plp_model* model);

/**
 * @brief The same from the bytes of a .gltf or .glb file. The bytes are not kept. Release the model.
 * @param data the bytes, `size` of them. @param folder UTF-8; where external buffers are; null if there are
 * none.
 * @return as plp_model_load_file.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_model_load_memory(const void* data, size_t size, const char* folder,
                                         const plp_model_options* options, plp_model* model);

/** The type of a number in a caller's buffer. */
typedef enum plp_type {
  PLP_TYPE_NONE = 0,
  PLP_TYPE_FLOAT32 = 1,
  PLP_TYPE_FLOAT64 = 2,
  PLP_TYPE_UINT8 = 3,
  PLP_TYPE_UINT16 = 4,
  PLP_TYPE_UINT32 = 5
} plp_type;

/** Triangles in the caller's own buffers; they are copied. */
typedef struct plp_triangles {
  uint32_t struct_size;   /**< set by plp_triangles_init() */
  uint32_t reserved;      /**< 0 */
  const void* positions;  /**< vertex_count × 3 numbers */
  size_t position_stride; /**< bytes from one vertex to the next, any alignment; 0: tightly packed */
  size_t vertex_count;    /**< of `positions` */
  const void*
      indices; /**< triangle_count × 3 numbers, counter-clockwise seen from outside; null: 0, 1, 2, … */
  size_t index_stride;    /**< bytes from one triangle to the next; 0: tightly packed */
  size_t triangle_count;  /**< without indices it may be 0: vertex_count / 3 */
  plp_type position_type; /**< PLP_TYPE_FLOAT32 or PLP_TYPE_FLOAT64 */
  plp_type index_type;    /**< PLP_TYPE_UINT8, UINT16 or UINT32; not read without indices */
  plp_space space;        /**< of the positions; a mirrored space turns the winding */
} plp_triangles;

/** @brief Fills `triangles`: float32 positions, uint32 indices, Palpate's space, no data. @threadsafety any
 * @since 0.1 */
PLP_API void plp_triangles_init(plp_triangles* triangles, size_t size);

/**
 * @brief Makes a model from triangles in the caller's memory, which is not needed any more when this returns.
 * @param options null for the defaults. @param model receives the handle; release it.
 * @return PLP_ERROR_INVALID_ARGUMENT (also for an index out of range), _NON_FINITE, _NO_TRIANGLES, _LIMIT or
 * _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_model_create_from_triangles(const plp_triangles* triangles,
                                                   const plp_model_options* options, plp_model* model);

/** @brief Adds a reference. @return PLP_ERROR_INVALID_HANDLE, or _LIMIT with 65,535 references.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_retain(plp_model model);

/** @brief Gives a reference back; with the last one the handle becomes invalid. Scenes keep the models they
 * use. Null is allowed. @return PLP_ERROR_INVALID_HANDLE. @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_release(plp_model model);

/** How the closed surfaces of a model wind. */
typedef enum plp_orientation {
  PLP_ORIENTATION_OPEN = 0,    /**< not closed, so there is no inside */
  PLP_ORIENTATION_OUTWARD = 1, /**< counter-clockwise seen from outside */
  PLP_ORIENTATION_INWARD = 2,
  PLP_ORIENTATION_MIXED = 3 /**< neighbours disagree */
} plp_orientation;

/** Counts of a surface. Vertices are welded; edges are counted over triangles whose three corners differ. */
typedef struct plp_surface_counts {
  uint64_t triangles;          /**< all, also those without area */
  uint64_t vertices;           /**< welded */
  uint64_t edges;              /**< between two vertices, however many triangles share them */
  uint64_t boundary_edges;     /**< one triangle */
  uint64_t nonmanifold_edges;  /**< more than two triangles */
  uint64_t inconsistent_edges; /**< two triangles that run the same way */
  uint64_t components;         /**< sets of triangles joined through shared vertices */
  int32_t orientation;         /**< plp_orientation */
  int32_t watertight;          /**< 1: no boundary, non-manifold or inconsistent edge */
} plp_surface_counts;

/** What a model is and what was done to it. */
typedef struct plp_model_info {
  uint32_t struct_size;            /**< set by plp_model_info_init() */
  uint32_t note_count;             /**< for plp_model_note */
  plp_surface_counts source;       /**< as it came, welded only */
  plp_surface_counts searched;     /**< as it is searched, after repair */
  uint64_t stored_vertices;        /**< as they came, before equal ones were welded */
  uint64_t degenerate_triangles;   /**< dropped: two equal corners or an area of exactly zero */
  uint64_t duplicate_triangles;    /**< dropped: the three vertices of an earlier one */
  uint64_t split_triangles;        /**< split at the middle vertex of a dropped neighbour without area */
  uint64_t reversed_triangles;     /**< winding turned */
  uint64_t flipped_components;     /**< closed components that faced the wrong way */
  uint64_t double_sided_triangles; /**< that are touched from both sides */
  double bounds_min[3];            /**< metres */
  double bounds_max[3];            /**< metres */
  double diagonal;                 /**< metres */
  uint64_t mesh_bytes;             /**< memory of triangles and connectivity */
  uint64_t tree_bytes;    /**< memory of the hierarchies, one for each plp_law; 0 as long as none is built */
  uint64_t tree_nodes;    /**< of all hierarchies */
  double load_us;         /**< time to read, weld and repair */
  double tree_us;         /**< time to build the hierarchies */
  uint64_t read_bytes;    /**< of the glTF and of the external buffers that its triangles need: no others are
                             opened. 0 for a model from triangles, as the next */
  uint64_t decoded_bytes; /**< of the accessors and compressed streams that were decoded to triangles; images
                             and animations are not */
} plp_model_info;

/** @brief Fills `info` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_model_info_init(plp_model_info* info, size_t size);

/** @brief Tells what a model is. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_get_info(plp_model model, plp_model_info* info);

/** @brief One sentence about something that was repaired, kept or skipped; null if there is no such note.
 *  Valid as long as the model. @threadsafety any @since 0.1 */
PLP_API const char* plp_model_note(plp_model model, uint32_t index);

/** @brief Builds the model's hierarchies now rather than when something first comes near.
 *  @return PLP_ERROR_INVALID_HANDLE or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_prepare(plp_model model);

/** @brief Tells models apart: a number that is the same for models whose triangles as they are searched are
 * the same, whatever they were loaded from. Takes a look at each of them.
 *  @param hash receives it. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety any
 *  @since 0.1 */
PLP_API plp_result plp_model_get_hash(plp_model model, uint64_t* hash);

/**
 * @brief Copies the welded vertices of a model as it is searched, such as to draw it.
 * @param positions receives x, y and z of each in metres, in the model's own frame: `capacity` × 3 numbers,
 * of which no more are written than there are vertices. May be null if `capacity` is 0. @param count receives
 * how many vertices there are, which may be more than `capacity`.
 * @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_model_get_vertices(plp_model model, double* positions, size_t capacity, size_t* count);

/**
 * @brief Copies the triangles of a model as it is searched: after repair, in no stated order.
 * @param corners receives three vertices of each, as numbered by plp_model_get_vertices, counter-clockwise
 * seen from outside: `capacity` × 3 numbers. @param sources receives the number of each in the input, which
 * is what plp_lmd::triangle_a means: `capacity` numbers. Either may be null to leave it out. @param count
 * receives how many triangles there are, which may be more than `capacity`.
 * @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_model_get_triangles(plp_model model, uint32_t* corners, uint32_t* sources,
                                           size_t capacity, size_t* count);

/* --------------------------------------------------------------------------------------------------------
 * contacts */

/** A body of one scene; 0 is none. */
typedef uint64_t plp_body;

/** What kind of place a point is on. */
typedef enum plp_feature { PLP_FEATURE_FACE = 0, PLP_FEATURE_EDGE = 1, PLP_FEATURE_VERTEX = 2 } plp_feature;

/** One local minimum distance (LMD), or one point of a plateau of equal ones. Step from one to the next in an
 * array by plp_contacts::lmd_stride. */
typedef struct plp_lmd {
  double point_a[3]; /**< on the first model, or on the scene */
  double point_b[3]; /**< on the second model, or on the tool */
  double normal[3];  /**< unit vector from point_a to point_b */
  double distance;   /**< along the normal: of a wall negative while the tool is pressed in */
  double weight;     /**< of this point in its set: the weights of one set sum to 1 */
  double force[3];   /**< newtons, on the second model or on the tool, at point_b: stiffness × (cutoff −
                        distance) × weight along the normal; in plp_contacts::springs all that it pushes with */
  plp_body body_a;   /**< 0 from plp_query */
  plp_body body_b;   /**< 0 from plp_query */
  uint32_t set; /**< points of one plateau share it; 0, 1, … in order. UINT32_MAX in plp_contacts::springs: a
                   wall, a spring that fades, or one of PLP_LAW_SMOOTH */
  uint8_t feature_a; /**< plp_feature */
  uint8_t feature_b; /**< plp_feature */
  uint8_t corner_a; /**< of triangle_a as it is searched: which vertex, or which edge (k joins corners k and k
                       + 1); 0 for a face. Turning a triangle's winding exchanges two of its corners. */
  uint8_t corner_b; /**< the same of triangle_b */
  uint32_t triangle_a; /**< a triangle that holds the feature, as numbered in the input */
  uint32_t triangle_b; /**< a triangle that holds the feature of the second model or of the tool */
} plp_lmd;

/** Two triangles that touch or cross. */
typedef struct plp_overlap {
  plp_body body_a;     /**< 0 from plp_query */
  plp_body body_b;     /**< 0 from plp_query; else the tool */
  uint32_t triangle_a; /**< as numbered in the input */
  uint32_t triangle_b; /**< as numbered in the input */
} plp_overlap;

/** Work that a search did. */
typedef struct plp_work {
  uint64_t bodies;         /**< bodies beside the tool, near and far */
  uint64_t body_pairs;     /**< searched */
  uint64_t node_pairs;     /**< pairs of hierarchy nodes visited */
  uint64_t triangle_pairs; /**< pairs of triangles tested */
  uint64_t descents;       /**< PLP_MODE_DESCENT: LMDs followed */
  uint64_t descent_steps;  /**< PLP_MODE_DESCENT: moves to other triangles or features */
  uint64_t front_entries;  /**< PLP_MODE_CERTIFIED: certificates kept */
  uint64_t front_expired;  /**< PLP_MODE_CERTIFIED: of those, renewed in this step */
  uint64_t age;            /**< steps since the search that the LMDs come from */
  double global_us;        /**< time of searches from scratch in this step */
  uint64_t rebuilds;       /**< PLP_MODE_CERTIFIED: of the node pairs, those tested to renew what is kept */
} plp_work;

/** How an outcome is out of the ordinary: bits of plp_contacts::status. */
typedef enum plp_status {
  PLP_STATUS_BY_DESCENT = 1, /**< plp_scene_options::tick_budget ran out: local descent from the last step
                                completed the set, which may lack new LMDs; all that it has are LMDs */
  PLP_STATUS_CUT = 2,        /**< a servo found more than it had room for; it gets more */
  PLP_STATUS_WAITING = 4,    /**< a near body pushes nothing yet: it is being made ready for the servo */
  PLP_STATUS_WALL = 8        /**< surfaces overlap and walls hold the tool */
} plp_status;

/** The outcome of a search. The arrays belong to the result or scene that it was read from. */
typedef struct plp_contacts {
  uint32_t struct_size; /**< set by plp_contacts_init() */
  int32_t overlap;      /**< 1: surfaces touch or cross, where nothing pushes but walls, if the tool came from
                           outside; 0 also if one body is inside another */
  const plp_lmd* lmds;  /**< `lmd_count` of them, sets in order */
  size_t lmd_count;     /**< points: of a plateau several */
  size_t lmd_stride;    /**< bytes from one to the next: may be more than sizeof(plp_lmd) of this header */
  size_t set_count;     /**< LMDs, a plateau counted once */
  const plp_overlap* overlaps; /**< `overlap_count` of them */
  size_t overlap_count;        /**< as listed, see overlaps_cut */
  size_t overlap_stride;       /**< bytes from one to the next */
  int32_t overlaps_cut;        /**< 1: more pairs overlap than are listed */
  uint32_t reserved;           /**< 0 */
  double min_distance;         /**< of the LMDs; infinite if there is none */
  plp_wrench wrench;           /**< N and N·m of all that pushes; about which point the search says */
  double search_us;            /**< time that the search took */
  plp_work work;               /**< what the search did */
  const plp_lmd* springs;      /**< all that pushes, each with its whole force; steps by lmd_stride */
  size_t spring_count;         /**< of `springs` */
  uint32_t status;             /**< PLP_STATUS_* bits; 0: all well */
  uint32_t reserved2;          /**< 0 */
} plp_contacts;

/** @brief Fills `contacts` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_contacts_init(plp_contacts* contacts, size_t size);

/* ------------------------------------------------------------------------------------------------------------
 * query */

/** Room for the outcome of plp_query; reuse one to avoid allocations. */
typedef struct plp_query_result_t* plp_query_result;

/** @brief Makes an empty result. @param result receives the handle; release it. @return
 * PLP_ERROR_INVALID_ARGUMENT, _LIMIT (about a million) or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_query_result_create(plp_query_result* result);

/** @brief Releases a result and its arrays. Null is allowed. @return PLP_ERROR_INVALID_HANDLE.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_query_result_release(plp_query_result result);

/** What pushes of what is found. */
typedef enum plp_law {
  PLP_LAW_SPRINGS = 0, /**< every LMD is a spring [JW04]: it jumps where an LMD comes or goes */
  /** Feature pairs that hold an LMD or almost do share springs: force and torque are continuous in the pose
   * and do not depend on how flat faces and straight edges are cut. An LMD by itself pushes as in the other
   * law; where surfaces lie flush, up to one spring for each corner pushes. */
  PLP_LAW_SMOOTH = 1
} plp_law;

/** How plp_query searches and pushes. */
typedef struct plp_query_options {
  uint32_t struct_size;      /**< set by plp_query_options_init() */
  uint32_t max_overlaps;     /**< list at most so many overlapping pairs */
  double cutoff;             /**< metres, positive: LMDs farther apart are not searched */
  double stiffness;          /**< N/m, not negative: force = stiffness × (cutoff − distance) × weight */
  double reference_point[3]; /**< frame of B: torques are about it */
  int32_t law;               /**< plp_law */
  uint32_t reserved;         /**< 0 */
} plp_query_options;

/** @brief Fills `options`: no cutoff yet, 1000 N/m, PLP_LAW_SPRINGS, torques about B's origin, up to 1024
 * overlaps.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_query_options_init(plp_query_options* options, size_t size);

/**
 * @brief Finds every local minimum distance within the cutoff between two models at one pose, and the wrench
 * of their springs on B. Points, normals, forces and the torque are in A's frame.
 * @param a_from_b B's frame in A's. @param result receives the outcome; read it with plp_query_result_get.
 * @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT or _OUT_OF_MEMORY; then `result` is empty.
 * @threadsafety object (the result; models may be shared) @since 0.1
 */
PLP_API plp_result plp_query(plp_model a, plp_model b, const plp_pose* a_from_b,
                             const plp_query_options* options, plp_query_result result);

/** @brief Reads an outcome. The arrays are valid until the result is used in another plp_query or released.
 *  @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety object @since 0.1 */
PLP_API plp_result plp_query_result_get(plp_query_result result, plp_contacts* contacts);

/* ------------------------------------------------------------------------------------------------------------
 * scene */

/** Bodies, one of which is the tool that the hand moves. */
typedef struct plp_scene_t* plp_scene;

/** How a scene finds its LMDs in each step. */
typedef enum plp_mode {
  PLP_MODE_GLOBAL = 0, /**< the complete set, searched from scratch */
  PLP_MODE_DESCENT =
      1, /**< local descent from the last search, which is repeated every few steps: new LMDs come late */
  PLP_MODE_CERTIFIED = 2 /**< the complete set, kept up to date with proof as the models move */
} plp_mode;

/** How a scene is made. */
typedef struct plp_scene_options {
  uint32_t struct_size;  /**< set by plp_scene_options_init() */
  uint32_t max_overlaps; /**< list at most so many overlapping pairs */
  plp_space space;       /**< of poses, points and wrenches of this scene */
  double cutoff;         /**< units of the space, positive */
  double stiffness;      /**< N/m, not negative */
  int32_t mode;          /**< plp_mode */
  uint32_t global_every; /**< PLP_MODE_DESCENT: steps from one search to the next; 0 for 10 */
  int32_t law;           /**< plp_law */
  uint32_t threads;      /**< of plp_scene_step, with the caller's, at most 256; 0 and 1: the caller's alone.
                            The outcome does not depend on it, but with more the step blocks and locks. */
  double damping; /**< N·s/m, not negative: what a spring of weight 1 adds to its push while it closes. As
                     a device samples, this stays passive up to about m / (2 time_step), m the mass that
                     the hand holds; from stiffness × time_step on it makes up for the energy that
                     holding the force from step to step gives. */
  double stiffness_cap; /**< N/m: all springs together are no stiffer against translation in any direction,
                           and push the more the deeper the tool goes. Each yields to what all push: a face
                           of the stiffness k by itself feels like k / (1 + 2 k / stiffness_cap), at most
                           half of the cap, because there may be another across. 0: what the device that
                           holds the tool can render (plp_device_info::max_stiffness, see
                           plp_scene_set_device), none without a device; negative: none */
  double friction;  /**< Coulomb's coefficient, not negative. Below a slip of 5 mm/s, or where it would damp
                       more  than 20 N·s/m for a spring of weight 1, it is proportional to the slip. */
  double fade_time; /**< PLP_MODE_DESCENT: seconds in which a spring fades that is lost, or found late, nearer
                       than the cutoff; every mode: that hands over from a wall. 0: at once */
  double time_step; /**< seconds from one plp_scene_step to the next, for velocities, within 1e-6 and
                       1; 0 for 0.001 */
  uint32_t tick_budget; /**< PLP_MODE_CERTIFIED: at most so many tests of pairs of nodes and of triangles in a
                           step, shared equally by the bodies searched, at least 128 each; then descent. What
                           is left comes first in the next step, also if nothing moves. 0: no limit */
  uint32_t reserved;    /**< 0 */
} plp_scene_options;

/** @brief Fills `options`: Palpate's space, no cutoff yet, PLP_LAW_SMOOTH, 1000 N/m without damping or
 * friction, capped by the device alone, fading in 0.02 s, steps of 0.001 s, up to 1024 overlaps.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_scene_options_init(plp_scene_options* options, size_t size);

/** @brief Makes an empty scene. @param scene receives the handle; release it. @return
 * PLP_ERROR_INVALID_ARGUMENT, _LIMIT (about a million) or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_create(const plp_scene_options* options, plp_scene* scene);

/** @brief Releases a scene and its bodies and stops its servo. Null is allowed. @return
 * PLP_ERROR_INVALID_HANDLE.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_release(plp_scene scene);

/** What a body is in its scene. */
typedef enum plp_body_kind {
  PLP_BODY_STATIC = 0,
  PLP_BODY_MOVING = 1,
  PLP_BODY_TOOL = 2 /**< at most one in a scene */
} plp_body_kind;

/** How a body is added. */
typedef struct plp_body_options {
  uint32_t struct_size; /**< set by plp_body_options_init() */
  plp_body_kind kind;   /**< what it is in its scene */
  plp_model model;      /**< the scene keeps a reference */
  plp_pose pose;    /**< of the model's frame in the scene's space; a mirrored space mirrors the model, too */
  double stiffness; /**< N/m against the tool; 0: the scene's */
  double reference_point[3]; /**< of the tool, its own frame, scene units: torques are about it */
  double damping;            /**< N·s/m against the tool; 0: the scene's */
  double friction;           /**< coefficient against the tool; 0: the scene's, negative: none */
  int32_t intangible;        /**< 1: the tool passes through it; 0 for the tool itself */
  uint32_t reserved;         /**< 0 */
} plp_body_options;

/** @brief Fills `options`: static, identity pose, the scene's stiffness. @threadsafety any @since 0.1 */
PLP_API void plp_body_options_init(plp_body_options* options, size_t size);

/** @brief Adds a body. The scene keeps the model.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT (also for a second tool), _LIMIT or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_add_body(plp_scene scene, const plp_body_options* options, plp_body* body);

/** @brief Removes a body. @return PLP_ERROR_INVALID_HANDLE or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_remove_body(plp_scene scene, plp_body body);

/** @brief Sets a body's pose. A static body may be moved, too.
 *  @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_pose(plp_scene scene, plp_body body, const plp_pose* pose);

/** @brief Reads a body's pose, as it was set last. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_get_pose(plp_scene scene, plp_body body, plp_pose* pose);

/** @brief Sets the cutoff (units of the scene's space, positive). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_cutoff(plp_scene scene, double cutoff);

/** @brief Sets how LMDs are found from the next step on (plp_mode). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_mode(plp_scene scene, int32_t mode);

/** @brief Sets what pushes from the next step on (plp_law). A servo goes on with PLP_LAW_SPRINGS until its
 * near pairs are ready for the smooth law. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_law(plp_scene scene, int32_t law);

/** @brief Sets the stiffness (N/m, not negative). @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_stiffness(plp_scene scene, double stiffness);

/** @brief Sets the damping of closing springs (N·s/m, not negative). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_damping(plp_scene scene, double damping);

/** @brief Sets the bound on the stiffness of all springs together (N/m; 0: what the device can render,
 *  negative: none). @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_stiffness_cap(plp_scene scene, double stiffness_cap);

/** @brief Sets the coefficient of friction (not negative). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_set_friction(plp_scene scene, double friction);

/**
 * @brief Searches the tool against every other body that is near and computes the wrench on the tool about
 * its reference point, in the scene's space. Without a tool there are no contacts. The same inputs give the
 * same bits.
 * @return PLP_ERROR_INVALID_HANDLE, _WRONG_STATE (its servo runs) or _OUT_OF_MEMORY; then the last outcome is
 * kept, and the next step gives what this one would have, in PLP_MODE_DESCENT or under a tick_budget after a
 * search that begins anew. A device has had its tick all the same, without a new wrench.
 * @threadsafety object @since 0.1
 */
PLP_API plp_result plp_scene_step(plp_scene scene);

/** @brief Reads the outcome of the last step, the caller's or the servo's. The arrays are valid until the
 * next plp_scene_step or plp_scene_get_contacts of this scene, or its release; a running servo does not touch
 * them.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT or _OUT_OF_MEMORY.
 *  @threadsafety object (beside plp_scene_step alone; all else may go on meanwhile) @since 0.1 */
PLP_API plp_result plp_scene_get_contacts(plp_scene scene, plp_contacts* contacts);

/** What a body is. */
typedef struct plp_body_info {
  uint32_t struct_size; /**< set by plp_body_info_init() */
  plp_body_kind kind;   /**< what it is in its scene */
  char name[256];       /**< of its node; "" if it has none; UTF-8 and terminated, cut where it is longer */
  int32_t node;         /**< index in the glTF file that it comes from; -1: from none */
  int32_t intangible;   /**< 1: the tool passes through it */
  plp_body above;       /**< the nearest body above it in the file's hierarchy; 0: none */
  uint64_t triangles;   /**< of its model, as it is searched */
  double stiffness;     /**< N/m against the tool; 0: the scene's */
  double damping;       /**< N·s/m against the tool; 0: the scene's */
  double friction;      /**< coefficient against the tool; 0: the scene's, negative: none */
} plp_body_info;

/** @brief Fills `info` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_body_info_init(plp_body_info* info, size_t size);

/** @brief Tells what a body is. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_get_body_info(plp_scene scene, plp_body body, plp_body_info* info);

/** @brief Lists the bodies of a scene, as long as none was removed in the order in which they were added.
 *  @param bodies `capacity` of them; may be null if that is 0. @param count receives how many there are,
 * which may be more.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_list_bodies(plp_scene scene, plp_body* bodies, size_t capacity, size_t* count);

/** @brief Finds a body by the whole name of its node; of several the first that plp_scene_list_bodies lists.
 *  @param name UTF-8, not empty.
 *  @return PLP_ERROR_INVALID_ARGUMENT (also if no body has that name) or _INVALID_HANDLE.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_find_body(plp_scene scene, const char* name, plp_body* body);

/** @brief Gives a new handle of a body's model: release it.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT, _LIMIT or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_get_body_model(plp_scene scene, plp_body body, plp_model* model);

/* ------------------------------------------------------------------------------------------------------------
 * glTF scenes */

/** How plp_scene_load_gltf takes a file into a scene. */
typedef struct plp_gltf_scene_options {
  uint32_t struct_size;           /**< set by plp_gltf_scene_options_init() */
  uint32_t flags;                 /**< 0; others are refused */
  const plp_model_options* model; /**< how meshes become models, and which of the file's scenes; null for the
                                     defaults. Its max_triangles counts a shared mesh for every node. */
  const char* tool; /**< UTF-8: name of the node that is the tool, with all that is below it; or, such as
                       "/nodes/5", its index in the file, if no node is called so; null: no tool */
  plp_pose pose;    /**< of the file's scene in this scene's space */
  double cutoff;    /**< the scene's from now on, units of its space, positive; 0: as it is */
} plp_gltf_scene_options;

/** @brief Fills `options`: no tool, identity pose, the cutoff as it is. @threadsafety any @since 0.1 */
PLP_API void plp_gltf_scene_options_init(plp_gltf_scene_options* options, size_t size);

/**
 * @brief Adds the nodes of a .gltf or .glb file that have meshes as bodies, parents before children. All or
 * nothing; in a scene whose servo runs they arrive within the next steps. A body is called by its node's name
 * or, if that has none, by its mesh's.
 *
 * A body's frame is that of its node without scale, mirror and shear, which its model holds; of a mirrored
 * node the third axis is turned. Bodies share a model if they have the same mesh and the same scale to six
 * digits. Deformed by its skin or morph targets a mesh is taken as it stands in the file. Nodes without a
 * triangle of positive area are no bodies; the log names them.
 *
 * What a body feels like is taken from the first that says something: the numbers `stiffness` (N/m),
 * `damping` (N·s/m) and `friction` (Coulomb's coefficient) in the `extras` of its node; the same of its mesh;
 * the same of the mesh's material in MPEG_material_haptic, whose textures are not read; `dynamicFriction` in
 * KHR_physics_rigid_bodies. A stiffness or damping of 0 is the scene's; a friction of 0 is none. Nodes with a
 * `motion` in KHR_physics_rigid_bodies, and those below them, are PLP_BODY_MOVING, others static. Triggers,
 * and bodies that by the collision filters never touch the tool's node, are intangible. Of a collider's
 * geometry nothing is read: what is touched is the mesh of the node itself.
 *
 * @param path UTF-8. @param options null for the defaults. @param bodies receives the first `capacity` of the
 * new bodies; may be null if that is 0. @param count receives how many there are, at most 1,000,000; may be
 * null.
 * @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT (also if none or several nodes have the tool's name, or
 * if the scene has a tool already), _FILE_NOT_FOUND, _FILE_READ, _BAD_FORMAT, _UNSUPPORTED, _NO_TRIANGLES,
 * _NON_FINITE, _LIMIT, _UNSAFE_PATH or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_scene_load_gltf(plp_scene scene, const char* path,
                                       const plp_gltf_scene_options* options, plp_body* bodies,
                                       size_t capacity, size_t* count);

/**
 * @brief Gives the transform that the body's node would have in its file, so that the file shows the bodies
 * where they are now: under a parent that is a body where that is now, and moved with the nearest such one
 * above.
 * @param matrix 16 numbers: receives parent_from_node as glTF's `matrix` has it: column by column, metres,
 * the file's axes, whatever the space of the scene. It may shear where a body was turned under a parent of
 * unequal scales.
 * @return PLP_ERROR_INVALID_ARGUMENT if the body comes from no file; _WRONG_STATE if the body above it was
 * removed or a node above scales to nothing; _INVALID_HANDLE.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_scene_get_node_matrix(plp_scene scene, plp_body body, double* matrix);

/* ------------------------------------------------------------------------------------------------------------
 * servo */

/** How the servo of a scene runs. */
typedef struct plp_servo_options {
  uint32_t struct_size; /**< set by plp_servo_options_init() */
  uint32_t flags;       /**< 0; others are refused */
  double rate;          /**< steps a second, 1 to 20000; 0 for 1000 */
  int32_t priority;     /**< of SCHED_FIFO, 1 to 99; 0: a usual one; -1: none. Only if the system allows. */
  int32_t cpu;          /**< the only one that it runs on, if the system allows; -1: any */
} plp_servo_options;

/** @brief Fills `options`: 1000 steps a second, real-time priority if the system allows, any processor.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_servo_options_init(plp_servo_options* options, size_t size);

/**
 * @brief Starts a scene's servo: a thread of this library that steps the scene at a fixed rate, and another
 * that searches beside it. Bodies may be added, removed and moved and settings changed meanwhile from any
 * thread; a change takes effect in the next step. plp_scene_get_contacts reads the newest outcome. The servo
 * never waits and never allocates: a body that comes near is first made ready beside it (PLP_STATUS_WAITING),
 * and no more than 1,024 points of LMDs and 1,024 overlaps are listed, while the wrench is of all
 * (PLP_STATUS_CUT). What is near already is ready when this returns. In PLP_MODE_DESCENT searches from
 * scratch go on continuously while anything near moves by more than 1 % of the cutoff;
 * plp_scene_options::global_every is not used. With a device that has a loop of its own (`openhaptics:`) that
 * loop is the servo: the options are not used, and a step sees the sample and gives the wrench of one tick of
 * it. The servo moves when such a device comes or goes, and counts anew.
 * @param options null for the defaults.
 * @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT, _WRONG_STATE (it runs already), _LIMIT (the system
 * allows no more threads) or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_scene_start(plp_scene scene, const plp_servo_options* options);

/** @brief Stops a scene's servo and waits until it rests, and until a search that is under way has ended. The
 * scene keeps its bodies, settings and last outcome and may be stepped by plp_scene_step. Does nothing if no
 * servo runs.
 *  @return PLP_ERROR_INVALID_HANDLE. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_stop(plp_scene scene);

/** How a servo runs or, if it was stopped, ran. Times are in microseconds: the 50th, 99th and 99.9th
 * percentile, which may be an eighth too long, and the maximum. */
typedef struct plp_servo_state {
  uint32_t struct_size;   /**< set by plp_servo_state_init() */
  int32_t running;        /**< 1: the servo runs */
  int32_t priority;       /**< of SCHED_FIFO as the system granted it; 0: none */
  int32_t cpu;            /**< the only one that it runs on, as granted; -1: any */
  double wanted_rate;     /**< steps a second */
  double rate;            /**< as measured, over the last second or so */
  uint64_t ticks;         /**< steps since the start */
  uint64_t missed;        /**< steps that ended after the next one's time */
  uint64_t skipped;       /**< steps left out because their time had passed: none is made up for */
  double work_us[4];      /**< of a step, its outcome handed over */
  double lateness_us[4];  /**< from a step's time to its begin */
  uint64_t waiting_ticks; /**< steps with PLP_STATUS_WAITING */
  uint64_t cut_ticks;     /**< steps with PLP_STATUS_CUT */
  uint64_t preparations;  /**< pairs of models made ready for the servo */
  uint64_t searches;      /**< PLP_MODE_DESCENT: searches from scratch beside the servo */
  uint64_t result_age; /**< PLP_MODE_DESCENT: steps since the pose of the search the newest LMDs come from */
} plp_servo_state;

/** @brief Fills `state` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_servo_state_init(plp_servo_state* state, size_t size);

/** @brief Tells how a scene's servo runs. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_get_servo(plp_scene scene, plp_servo_state* state);

/** @brief Stops the servos of all scenes, as plp_scene_stop does. It happens by itself when the process
 * exits; closing the library leaves it in memory and its servos running. May be called more than once; in the
 * child of a fork() it does nothing.
 *  @return PLP_OK. @threadsafety any @since 0.1 */
PLP_API plp_result plp_shutdown_all(void);

/* ------------------------------------------------------------------------------------------------------------
 * device */

/**
 * A haptic device in its safety limits; reference counted.
 *
 * A device's base frame is right-handed, +x to the right, +y up, +z to the user, in metres whatever the space
 * of a scene. Its handle is where the hand holds it: the centre of its gimbal.
 *
 * **Safety.** Nothing reaches the motors but through the limits, which no call removes. They clamp force and
 * torque to the device's own maxima with their direction kept, limit how fast both change, let force fade in
 * after arming and after every fault, and give no force at all while the device is disarmed or not
 * calibrated, while a dead-man button is let go, or in a fault: a wrench or a pose that is not finite, a pose
 * that jumps, a servo or a pose that is stale. A device begins disarmed. A loop is stable only where the
 * stiffness that the hand feels is one that the device can render (plp_device_info::max_stiffness is its
 * maker's figure): a scene keeps to it unless plp_scene_options::stiffness_cap tells it otherwise; the limits
 * bound an unstable loop, they do not calm it. Keep the face away from an armed
 * device, and arm with the hand on the handle.
 */
typedef struct plp_device_t* plp_device;

/** What a device, or the way to it, says of itself. All but the first two give no force. */
typedef enum plp_condition {
  PLP_CONDITION_READY = 0,
  PLP_CONDITION_NEEDS_CALIBRATION = 1, /**< its pose is not to be trusted yet, and there is no force */
  PLP_CONDITION_WARM_MOTORS = 2,       /**< until they have cooled down */
  PLP_CONDITION_EXCEEDED_FORCE = 3,    /**< told to push harder than it can, it has let go for a while */
  PLP_CONDITION_EXCEEDED_VELOCITY = 4, /**< moved faster than it follows, it has let go for a while */
  PLP_CONDITION_LOST = 5,              /**< it does not answer; once it does, it is taken up again */
  PLP_CONDITION_FAILED = 6,            /**< its driver reports another error */
  PLP_CONDITION_NO_LIBRARY = 7,    /**< listed only, as the next three: what reaches it is not installed */
  PLP_CONDITION_WRONG_LIBRARY = 8, /**< what is installed lacks a part */
  PLP_CONDITION_CANNOT_OPEN = 9,
  PLP_CONDITION_WITHHELD = 10 /**< another way to it is the right one, or the system does not permit it */
} plp_condition;

/** What a device is and can do. A degree of freedom that is not actuated has limits of zero. */
typedef struct plp_device_info {
  uint32_t struct_size;       /**< set by plp_device_info_init() */
  uint32_t buttons;           /**< how many it has */
  uint32_t sensed;            /**< bits 0 to 2: translation along x, y, z; bits 3 to 5: rotation about them */
  uint32_t actuated;          /**< the same for forces and torques */
  char uri[256];              /**< what plp_device_open takes; UTF-8 and terminated, as all three texts */
  char name[256];             /**< for people */
  char serial[64];            /**< "" if it has none */
  double max_force;           /**< N, for short */
  double continuous_force;    /**< N, for ever */
  double max_torque;          /**< N·m, for short */
  double continuous_torque;   /**< N·m, for ever */
  double max_stiffness;       /**< N/m that the hand may feel; 0: unknown, and caps nothing */
  double max_damping;         /**< N·s/m */
  double position_resolution; /**< m at the handle */
  double angle_resolution;    /**< rad */
  double update_rate;         /**< Hz */
  double workspace_min[3];    /**< m, base frame */
  double workspace_max[3];    /**< m, base frame */
  int32_t condition;          /**< plp_condition, now */
  uint32_t reserved;          /**< 0 */
  char status[512];           /**< what its user can do about its condition; UTF-8 and terminated */
} plp_device_info;

/** @brief Fills `info` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_device_info_init(plp_device_info* info, size_t size);

/**
 * @brief Lists the devices that could be opened now, and the ways to devices that are missing something, with
 * their condition and what is to be done. Limits that only an open device tells are zero.
 * @param infos `capacity` of them; the first one's struct_size counts for all, and is the distance from one
 * to the next. May be null if `capacity` is 0. @param count receives how many devices there are, which may be
 * more.
 * @return PLP_ERROR_INVALID_ARGUMENT or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_device_list(plp_device_info* infos, size_t capacity, size_t* count);

/**
 * @brief Opens a device. `sim:premium6dof` and `sim:touch` are simulated and always there: a PHANToM Premium
 * 1.5/6DOF and a Touch, which has no torque, in a simulated hand (plp_device_set_hand). Each opening makes
 * another one; `?delay=N` behind makes its sensors N samples late, 0 to 8.
 *
 * `openhaptics:NAME` is a PHANToM Premium, Touch or Touch X through the maker's library, libHD of OpenHaptics
 * 3.4, under the name that it was given when it was set up; without a name, the library's default. The
 * library is opened now: the one at PATH with `?library=PATH` behind, else the one that the environment
 * variable PALPATE_OPENHAPTICS_LIBRARY names, else an installed one. Its scheduler ticks the device and is
 * the servo of a running scene that has it; a wrench that plp_scene_step computes, which has to follow the
 * scheduler's rate, is felt a tick later. While another such device is opened or closed, and for a moment
 * every two seconds while one is lost, it rests: the force of the others ends and fades in anew. Limits are
 * the device's own or those known of its model, whichever are tighter. Beside its buttons, the last one of a
 * device with an inkwell is held while the stylus is out of it.
 *
 * `hid:VENDOR:PRODUCT`, in four hexadecimal digits each, and `hid:VENDOR:PRODUCT:SERIAL` are devices on USB
 * and Bluetooth, each of which can be open once: SpaceMice, which move the tool at the rate at which they are
 * pushed and have no force (0.15 m/s and 1.5 rad/s at full deflection, nothing within 6 % of it, up to 0.3 m
 * from where it began), and haptic devices that speak the open protocol of engine/device/hid/PROTOCOL.md. One
 * that is pulled out is PLP_CONDITION_LOST, and is taken up again when it is plugged in.
 * @param uri null or "" for `sim:premium6dof`. @param device receives the handle; release it.
 * @return PLP_ERROR_DEVICE if there is no such device or it cannot be opened: the sentence names those that
 * there are, or says what is missing; _INVALID_ARGUMENT, _LIMIT or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_device_open(const char* uri, plp_device* device);

/** @brief Adds a reference. @return PLP_ERROR_INVALID_HANDLE, or _LIMIT with 65,535 references.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_retain(plp_device device);

/** @brief Gives a reference back; with the last one the handle becomes invalid. A scene keeps its device,
 * which is closed when nobody has it. Null is allowed. @return PLP_ERROR_INVALID_HANDLE.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_release(plp_device device);

/** @brief Tells what a device is. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_get_info(plp_device device, plp_device_info* info);

/** What the safety limits let a device do. */
typedef enum plp_safety {
  PLP_SAFETY_DISARMED = 0, /**< no force: not armed, not calibrated, or the dead-man button let go */
  PLP_SAFETY_RAMPING = 1,  /**< force fades in */
  PLP_SAFETY_ARMED = 2,
  PLP_SAFETY_FAULT = 3 /**< no force until its cause has been away for a while; then it fades in by itself */
} plp_safety;

/** What can change a wrench on its way to the motors. */
typedef enum plp_limiter {
  PLP_LIMITER_LONG_TICK = 0,         /**< time stood still, as at a breakpoint: force fades in anew */
  PLP_LIMITER_NON_FINITE_WRENCH = 1, /**< fault */
  PLP_LIMITER_NON_FINITE_POSE = 2,   /**< fault */
  PLP_LIMITER_POSE_JUMP = 3,         /**< fault: faster than a hand */
  PLP_LIMITER_STALE_SERVO = 4,       /**< fault: no new wrench */
  PLP_LIMITER_STALE_POSE = 5,        /**< fault: no new sample */
  PLP_LIMITER_FORCE_CLAMP = 6,
  PLP_LIMITER_TORQUE_CLAMP = 7,
  PLP_LIMITER_FORCE_SLEW = 8,
  PLP_LIMITER_TORQUE_SLEW = 9,
  PLP_LIMITER_RAMP = 10,
  PLP_LIMITER_DEVICE = 11 /**< fault: the device reports one (plp_device_state::condition) */
} plp_limiter;

/** A device after a tick. Poses, velocities and wrenches are in its base frame. */
typedef struct plp_device_state {
  uint32_t struct_size;       /**< set by plp_device_state_init() */
  uint32_t buttons;           /**< bit i: button i is held */
  plp_pose pose;              /**< of the handle, metres */
  double linear_velocity[3];  /**< m/s */
  double angular_velocity[3]; /**< rad/s */
  double time;                /**< s, of the sample, by the device's own clock */
  uint64_t sequence;          /**< grows with every sample */
  int32_t calibrated;         /**< 0: its pose is not to be trusted, and there is no force */
  int32_t safety;             /**< plp_safety */
  plp_wrench commanded;       /**< asked for, about the handle */
  plp_wrench applied;         /**< sent to the motors, about the handle */
  double gain;                /**< of the fading in, 0 to 1 */
  uint32_t limiters;          /**< bit 1 << plp_limiter: acting in the last tick */
  int32_t unactuated;         /**< 1: part of `commanded` was dropped, because there are no motors for it */
  uint64_t ticks;             /**< since it was opened */
  uint64_t limiter_ticks[16]; /**< by plp_limiter: ticks in which each has acted */
  int32_t condition;          /**< plp_condition */
  uint32_t reserved;          /**< 0 */
  double temperature;         /**< of the hottest motor: 0 cold, 1 too hot; 0 where none is measured */
  uint64_t lost;              /**< samples that were taken but never arrived, since it was opened */
} plp_device_state;

/** @brief Fills `state` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_device_state_init(plp_device_state* state, size_t size);

/** @brief Reads the state of the device's last tick: a step of the scene that has it. Before the first one it
 * is that of its opening. Waits for no tick. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_get_state(plp_device device, plp_device_state* state);

/** @brief Lets force fade in from the next tick on. @return PLP_ERROR_INVALID_HANDLE or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_arm(plp_device device);

/** @brief Tells a device that needs it that its handle is now where its maker wants it for calibration: of a
 * PHANToM Premium all links are at right angles. Force ends meanwhile. Its condition tells whether it
 * succeeded. @return PLP_ERROR_UNSUPPORTED for a device that calibrates itself; _INVALID_HANDLE.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_calibrate(plp_device device);

/** @brief Ends all force from the next tick on, at once. @return as plp_device_arm.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_disarm(plp_device device);

/** Limits that are tighter than a device's own. A number that is 0 is the device's own. */
typedef struct plp_safety_limits {
  uint32_t struct_size; /**< set by plp_safety_limits_init() */
  uint32_t dead_man;    /**< bits of buttons that must all be held for any force; 0: none */
  double max_force;     /**< N */
  double max_torque;    /**< N·m */
  double force_slew;    /**< N/s */
  double torque_slew;   /**< N·m/s */
  double max_speed;     /**< m/s: a faster pose jumps */
  double max_turn_rate; /**< rad/s */
  double watchdog;      /**< s without a new wrench, pose or tick */
  double ramp_time;     /**< s in which force fades in; not shorter than the device's own */
  double fault_hold;    /**< s without a cause that end a fault; not shorter than the device's own */
} plp_safety_limits;

/** @brief Fills `limits`: the device's own, no dead-man button. @threadsafety any @since 0.1 */
PLP_API void plp_safety_limits_init(plp_safety_limits* limits, size_t size);

/** @brief Tightens the limits from the next tick on, from the device's own and not from those before.
 *  @return PLP_ERROR_INVALID_ARGUMENT for one that is looser than the device's own, or for a button that it
 * has not; _INVALID_HANDLE or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_set_limits(plp_device device, const plp_safety_limits* limits);

/** How a simulated hand holds the handle. */
typedef enum plp_grip {
  PLP_GRIP_RELEASED = 0, /**< nobody holds it */
  PLP_GRIP_LIGHT = 1,    /**< fingers on a stylus: 200 N/m */
  PLP_GRIP_FIRM = 2,     /**< 1,000 N/m */
  PLP_GRIP_OWN = 3       /**< the numbers of plp_hand_options */
} plp_grip;

/** What a simulated hand does. */
typedef enum plp_hand_script {
  PLP_HAND_HOLD = 0,  /**< stays at the origin */
  PLP_HAND_TAP = 1,   /**< in by the depth and out again, for ever */
  PLP_HAND_PRESS = 2, /**< in by the depth, and stays there */
  PLP_HAND_SLIDE = 3, /**< presses, then to and fro along the travel */
  PLP_HAND_WEDGE = 4, /**< presses in by the depth while it sways to both sides */
  PLP_HAND_CIRCLE = 5 /**< around the origin in the plane of both directions, without depth */
} plp_hand_script;

/** A hand as the handle feels it: its mass moves with the handle, a spring and a damper tie both to where the
 * hand wants to be. Base frame of the device. */
typedef struct plp_hand_options {
  uint32_t struct_size;     /**< set by plp_hand_options_init() */
  int32_t grip;             /**< plp_grip */
  int32_t script;           /**< plp_hand_script */
  uint32_t buttons;         /**< held: bit i for button i */
  double mass;              /**< kg, up to 100; these six are for PLP_GRIP_OWN only, and may be 0 */
  double damping;           /**< N·s/m, up to 1e4 */
  double stiffness;         /**< N/m, up to 1e5 */
  double inertia;           /**< kg·m², up to 1 */
  double angular_damping;   /**< N·m·s/rad, up to 100 */
  double angular_stiffness; /**< N·m/rad, up to 1e3 */
  plp_pose origin;          /**< of the motion, at its beginning */
  double into[3];           /**< direction into the surface; need not have unit length */
  double along[3];          /**< direction across `into` */
  double depth;             /**< m along `into` */
  double travel;            /**< m along `along`: stroke of a slide, half of a sway, radius of a circle */
  double twist;             /**< rad about `into`, to both sides, with the same period */
  double period;            /**< s of one tap, stroke, sway or turn, and of the first press; 1e-3 to 1e6 */
} plp_hand_options;

/** @brief Fills `options`: a light hand that holds the handle at the middle of the workspace; for a script:
 * into -y, along x, 10 mm deep, 20 mm of travel, 1 s. @threadsafety any @since 0.1 */
PLP_API void plp_hand_options_init(plp_hand_options* options, size_t size);

/** @brief Tells a simulated hand how to hold and what to do from the next tick on. The handle follows as its
 * inertia lets it. Lengths are at most 10 m. @return PLP_ERROR_UNSUPPORTED for a device that no simulated
 * hand holds; _INVALID_HANDLE, _INVALID_ARGUMENT or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_set_hand(plp_device device, const plp_hand_options* options);

/** @brief Lets a simulated hand follow recorded poses, straight from one to the next, instead of a script.
 *  @param times seconds, growing; the first is when the next tick begins. @param poses base frame; `count` of
 * both, at least one; they are copied. @return as plp_device_set_hand. @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_set_hand_poses(plp_device device, const double* times, const plp_pose* poses,
                                             size_t count);

/** @brief Moves the handle with the next tick, at once, to where the simulated hand then wants it: an armed
 * device takes that for a jump of its pose. @return PLP_ERROR_UNSUPPORTED, _INVALID_HANDLE or _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_device_place_in_hand(plp_device device);

/** How a device's handle holds a scene's tool. Poses are in the scene's space, in which the axes of a device
 * without a pose of its own point as Palpate's: its +y is the scene's up. */
typedef struct plp_device_mapping {
  uint32_t struct_size;      /**< set by plp_device_mapping_init() */
  uint32_t flags;            /**< PLP_DEVICE_*; an unknown one is refused */
  plp_pose scene_from_base;  /**< where the device stands in the scene */
  plp_pose handle_from_tool; /**< how the tool's frame lies in the handle's */
  double motion_scale;     /**< metres of the scene for a metre of the handle, 1e-9 to 1e9; turns are kept */
  double force_scale;      /**< newtons on the hand for a newton on the tool, up to 1e9; torques are scaled by
                              force_scale / motion_scale */
  uint32_t clutch_buttons; /**< while all are held the handle moves without the tool; 0: no clutch */
  uint32_t reserved;       /**< 0 */
  double
      torque_lever[3]; /**< for a device without motors for torque: from a pivot to the handle, metres in the
                          handle's frame, 0.001 to 1 long. The torque is then felt as the force that has it at
                          the end of this lever, (torque × lever) / lever², at most half of max_force; what no
                          such force stands for is dropped, plp_device_state::unactuated. The force takes
                          part in no balance of energy. Zeros: torque is dropped */
} plp_device_mapping;

enum {
  PLP_DEVICE_KEEP_TOOL_POSE = 1 /**< take the tool up where it is, rather than moving it into the hand */
};

/** @brief Fills `mapping`: base and scene are one, the tool's origin is the handle, nothing is scaled.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_device_mapping_init(plp_device_mapping* mapping, size_t size);

/**
 * @brief Gives the scene's tool to a device. From then on a step is a tick: the tool takes the
 * handle's pose, contacts are found, the wrench goes through the limits to the hand, and the
 * time step passes for a simulated device. The hand feels a stiffness of the scene's, of all springs
 * together, times motion_scale × force_scale; where the scene has no stiffness_cap of its own, that is kept
 * to plp_device_info::max_stiffness. The tool may be added and removed meanwhile; a pose that is set
 * for it lasts while a clutch is held.
 * @param device null to take the tool from its device, which then lets the hand go: the tool stays where it
 * is, and another scene may have the device when this returns. A scene that runs is waited for, a tick as a
 * rule, at most 0.1 s. The scene keeps the device.
 * @param mapping null for the defaults.
 * @return PLP_ERROR_WRONG_STATE if another scene has the device; _LIMIT (a servo that had to move finds no
 * thread, and has stopped); _INVALID_HANDLE or _INVALID_ARGUMENT.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_scene_set_device(plp_scene scene, plp_device device,
                                        const plp_device_mapping* mapping);

/* ------------------------------------------------------------------------------------------------------------
 * trace */

/** How the recording of a scene goes or, from plp_scene_stop_recording, went. */
typedef struct plp_recording {
  uint32_t struct_size; /**< set by plp_recording_init() */
  int32_t running;      /**< 1: the scene is recorded */
  uint64_t ticks;       /**< in the file or on their way to it */
  uint64_t lost;        /**< that found no room */
  uint64_t bytes;       /**< of the file */
} plp_recording;

/** @brief Fills `recording` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_recording_init(plp_recording* recording, size_t size);

/**
 * @brief Records every step of the scene from now on, a caller's and a servo's, with all that its outcome
 * depends on: poses as the engine has them, bodies, settings. A caller's steps are all recorded; a servo
 * never waits for the file, so steps are lost, and counted, if it is slower than they come. A thread of this
 * library writes it. Replayed from its first step in a new scene, a trace gives the same bits.
 * @param path UTF-8; a file that is there is overwritten, and stays as it is where recording is refused: also
 * where the disk is full, if its file system can set room aside. In a folder that is not there:
 * _FILE_NOT_FOUND.
 * @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT, _WRONG_STATE (it is recorded already),
 * _FILE_NOT_FOUND, _FILE_WRITE, _LIMIT (the system allows no more threads) or _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_scene_record(plp_scene scene, const char* path);

/** @brief Ends a recording and its file. It happens by itself when the scene is released. A running servo is
 * waited for, a tick as a rule, at most 0.1 s.
 *  @param recording receives how it went; may be null.
 *  @return PLP_ERROR_FILE_WRITE or _OUT_OF_MEMORY if something went wrong since it began, such as a disk that
 * is full: it has ended all the same, `recording` is filled, and what is whole of the file can be read.
 * _INVALID_HANDLE, _INVALID_ARGUMENT or _WRONG_STATE (the scene is not recorded).
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_stop_recording(plp_scene scene, plp_recording* recording);

/** @brief Tells how a recording goes; zeros if there is none. @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_get_recording(plp_scene scene, plp_recording* recording);

/** The trace of a scene: a file that is open. What it gives is in the space that the scene had. */
typedef struct plp_trace_t* plp_trace;

/**
 * @brief Opens a trace. Of one that was cut off, as by a crash, all steps that are whole can be read:
 * plp_trace_info::complete tells. The file must stay as it is until the release.
 * @param path UTF-8. @param trace receives the handle; release it.
 * @return PLP_ERROR_BAD_FORMAT for what is no trace or a damaged one: the sentence names the byte;
 * _UNSUPPORTED for another version of the format; _INVALID_ARGUMENT, _FILE_NOT_FOUND, _FILE_READ, _LIMIT or
 * _OUT_OF_MEMORY.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_trace_open(const char* path, plp_trace* trace);

/** @brief Closes a trace and releases its arrays. Null is allowed. @return PLP_ERROR_INVALID_HANDLE.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_trace_release(plp_trace trace);

/** What a trace has. */
typedef struct plp_trace_info {
  uint32_t struct_size; /**< set by plp_trace_info_init() */
  int32_t complete;     /**< 0: it was cut off, and the scene went on behind its last step */
  uint64_t ticks;       /**< steps that can be read */
  uint64_t lost;        /**< steps that were not recorded, because the file was too slow */
  uint64_t bodies;      /**< that there ever were */
  uint64_t bytes;       /**< of the file, as far as it is whole */
  double duration;      /**< seconds of the scene from the first step to the last */
} plp_trace_info;

/** @brief Fills `info` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_trace_info_init(plp_trace_info* info, size_t size);

/** @brief Tells what a trace has. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_trace_get_info(plp_trace trace, plp_trace_info* info);

/** @brief Tells how the scene was made, with the settings of the moment in which its recording began and the
 * time step of its first step: make a scene with them to replay it. `threads` is left as it is.
 *  @param options initialised. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety any
 *  @since 0.1 */
PLP_API plp_result plp_trace_get_options(plp_trace trace, plp_scene_options* options);

/** A body of a trace. */
typedef struct plp_trace_body {
  uint32_t struct_size;      /**< set by plp_trace_body_init() */
  int32_t kind;              /**< plp_body_kind */
  plp_body body;             /**< as the scene called it */
  const char* model_name;    /**< the name of its file, followed by such as "#/nodes/5" if it is the node 5 of
                                plp_scene_load_gltf; valid until the trace is released */
  uint64_t model_triangles;  /**< of its model, as it is searched */
  uint64_t model_hash;       /**< plp_model_get_hash */
  double stiffness;          /**< as in plp_body_options, as the rest */
  double damping;            /**< N·s/m */
  double friction;           /**< coefficient */
  double reference_point[3]; /**< its own frame, scene units */
  uint64_t first_tick;       /**< the first step that had it; the number of steps if none had */
  uint64_t end_tick;         /**< the first step without it; the number of steps if it stayed */
  int32_t intangible;        /**< as in plp_body_options */
  uint32_t reserved;         /**< 0 */
} plp_trace_body;

/** @brief Fills `body` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_trace_body_init(plp_trace_body* body, size_t size);

/** @brief Describes a body of a trace. @param index below plp_trace_info::bodies; in the order in which they
 * were added. @param body its model_name is valid until the trace is released.
 * @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety any @since 0.1 */
PLP_API plp_result plp_trace_get_body(plp_trace trace, uint64_t index, plp_trace_body* body);

/** Where a body was placed. */
typedef struct plp_trace_move {
  plp_body body; /**< as the scene called it */
  plp_pose pose; /**< units of the space */
} plp_trace_move;

/** One step of a trace: what was changed before it, the settings that it had, and its outcome. */
typedef struct plp_trace_tick {
  uint32_t struct_size;        /**< set by plp_trace_tick_init() */
  uint32_t status;             /**< PLP_STATUS_* bits */
  uint64_t step;               /**< of its scene, from 1 */
  uint64_t lost;               /**< steps just before it that were not recorded */
  double time;                 /**< seconds of the scene since the first step of the trace */
  double clock;                /**< seconds that had passed since the recording began */
  double time_step;            /**< seconds since the step before */
  double cutoff;               /**< units of the space */
  double stiffness;            /**< N/m */
  double damping;              /**< N·s/m */
  double stiffness_cap;        /**< N/m */
  double friction;             /**< coefficient */
  int32_t mode;                /**< plp_mode */
  int32_t law;                 /**< plp_law */
  plp_body tool;               /**< 0: none */
  plp_pose tool_pose;          /**< as the step had it */
  plp_wrench wrench;           /**< on the tool, N and N·m about its reference point */
  double min_distance;         /**< infinite if there is no LMD */
  uint64_t set_count;          /**< LMDs, a plateau counted once */
  uint64_t lmd_count;          /**< points of LMDs */
  uint64_t overlap_count;      /**< overlapping pairs */
  int32_t overlap;             /**< 1: surfaces touch or cross */
  uint32_t reserved;           /**< 0 */
  double step_us;              /**< all that the step computed */
  const plp_trace_move* moves; /**< bodies that were added or placed anew, but for the tool */
  size_t move_count;           /**< of `moves` */
  size_t move_stride;          /**< bytes from one to the next */
  const plp_body* removed;     /**< bodies that were removed */
  size_t removed_count;        /**< of `removed` */
} plp_trace_tick;

/** @brief Fills `tick` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_trace_tick_init(plp_trace_tick* tick, size_t size);

/**
 * @brief Reads a step.
 * @param index below plp_trace_info::ticks. @param tick receives it; its arrays are valid until the next
 * plp_trace_read of this trace, or its release.
 * @return PLP_ERROR_INVALID_ARGUMENT (also behind the last step), _BAD_FORMAT for damage: the sentence names
 * the byte; _INVALID_HANDLE, _FILE_READ or _OUT_OF_MEMORY. Then there is no step to get contacts of.
 * @threadsafety object @since 0.1
 */
PLP_API plp_result plp_trace_read(plp_trace trace, uint64_t index, plp_trace_tick* tick);

/** @brief Gives the outcome of the step that was read last, with its LMDs but without springs and the list of
 * overlaps, which are not recorded. The arrays are valid as those of plp_trace_read.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT or _WRONG_STATE (none was read). @threadsafety object
 *  @since 0.1 */
PLP_API plp_result plp_trace_get_contacts(plp_trace trace, plp_contacts* contacts);

/**
 * @brief Places a body where a recorded one was, bit by bit, which a plp_pose that was read may miss by its
 * rounding. To replay a trace, make a scene by plp_trace_get_options, add its bodies, and for each step place
 * them, set what settings have changed, and step.
 * @param recorded as the trace calls it. @param body of `scene`.
 * @return PLP_ERROR_INVALID_ARGUMENT if the trace has no such step, or no such body in it; _INVALID_HANDLE,
 * _FILE_READ or _BAD_FORMAT.
 * @threadsafety any @since 0.1
 */
PLP_API plp_result plp_trace_place(plp_trace trace, uint64_t tick, plp_body recorded, plp_scene scene,
                                   plp_body body);

#ifdef __cplusplus
}
#endif

#endif /* PALPATE_PALPATE_H */
