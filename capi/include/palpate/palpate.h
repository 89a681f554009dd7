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
 * **Growing structs.** Structs that may grow start with `struct_size`. Fill one with its `plp_*_init()` and
 * change what you need. Zero in a field that was appended later means the behaviour from before it existed.
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

#define PLP_VERSION_MAJOR 0
#define PLP_VERSION_MINOR 1
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
  PLP_ERROR_BAD_FORMAT = -6,   /**< not glTF, or glTF that breaks its own rules */
  PLP_ERROR_UNSUPPORTED = -7,  /**< glTF that requires an extension this library does not have */
  PLP_ERROR_NO_TRIANGLES = -8, /**< nothing to touch: no triangle of positive area */
  PLP_ERROR_NON_FINITE = -9,   /**< an infinite or NaN coordinate */
  PLP_ERROR_LIMIT = -10,       /**< larger than a limit that the options or this library set */
  PLP_ERROR_UNSAFE_PATH = -11, /**< a glTF names a buffer outside its own folder */
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
  double position[3];
  double orientation[4];
} plp_pose;

/** A force in newtons and a torque in newton-metres about a point that the producing function states. */
typedef struct plp_wrench {
  double force[3];
  double torque[3];
} plp_wrench;

/** The space that a scene's poses, points and wrenches are given in. `axes[i]` says along which Palpate axis
 * the i-th axis of that space points: ±1, ±2 or ±3 for ±x, ±y or ±z, each axis once. Palpate's own is {1, 2,
 * 3}, right-handed and, as glTF, with +y up. {-1, 2, 3} is Unity with models as UnityGLTF and glTFast load
 * them; {1, 2, -3} Unity as OpenXR gives poses; {1, 3, -2} has z up (Blender, Panda3D). Forces stay in
 * newtons and torques in newton-metres; under a mirror torques turn as the pseudo-vectors they are. */
typedef struct plp_space {
  int32_t axes[3];
  int32_t reserved;       /**< 0 */
  double metres_per_unit; /**< 1e-9 to 1e9 */
} plp_space;

/* -----------------------------------------------------------------------------------------------------------
 * models */

/** A triangle model: immutable, reference counted, shared between scenes and threads. */
typedef struct plp_model_t* plp_model;

/** How a model is made from what comes. */
typedef struct plp_model_options {
  uint32_t struct_size;
  uint32_t flags;        /**< PLP_MODEL_*; an unknown one is refused */
  double weld_tolerance; /**< metres; 0 welds exactly equal positions only */
  int32_t gltf_scene;    /**< index of the glTF scene; -1 for the file's default one */
  uint32_t reserved;
  uint64_t
      max_triangles; /**< more are PLP_ERROR_LIMIT; 0 for the default of 100,000,000; at most 1,000,000,000 */
} plp_model_options;

enum {
  PLP_MODEL_DOUBLE_SIDED =
      1, /**< both sides of every triangle are touched, also of a closed surface's inside */
  PLP_MODEL_KEEP_WINDING = 2 /**< trust the winding as it comes: turn nothing */
};

/** @brief Fills `options` with the defaults. @threadsafety any @since 0.1 */
PLP_API void plp_model_options_init(plp_model_options* options);

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
 * @brief The same from the bytes of a .gltf or .glb file. The bytes are not kept.
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
  uint32_t struct_size;
  uint32_t reserved;
  const void* positions;  /**< vertex_count × 3 numbers */
  size_t position_stride; /**< bytes from one vertex to the next, any alignment; 0: tightly packed */
  size_t vertex_count;
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
PLP_API void plp_triangles_init(plp_triangles* triangles);

/**
 * @brief Makes a model from triangles in the caller's memory.
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
  uint64_t triangles;
  uint64_t vertices;
  uint64_t edges;
  uint64_t boundary_edges;     /**< one triangle */
  uint64_t nonmanifold_edges;  /**< more than two triangles */
  uint64_t inconsistent_edges; /**< two triangles that run the same way */
  uint64_t components;         /**< sets of triangles joined through shared vertices */
  int32_t orientation;         /**< plp_orientation */
  int32_t watertight;          /**< 1: no boundary, non-manifold or inconsistent edge */
} plp_surface_counts;

/** What a model is and what was done to it. */
typedef struct plp_model_info {
  uint32_t struct_size;
  uint32_t note_count;         /**< for plp_model_note */
  plp_surface_counts source;   /**< as it came, welded only */
  plp_surface_counts searched; /**< as it is searched, after repair */
  uint64_t stored_vertices;
  uint64_t degenerate_triangles; /**< dropped: two equal corners or an area of exactly zero */
  uint64_t duplicate_triangles;  /**< dropped: the three vertices of an earlier one */
  uint64_t split_triangles;      /**< split at the middle vertex of a dropped neighbour without area */
  uint64_t reversed_triangles;   /**< winding turned */
  uint64_t flipped_components;   /**< closed components that faced the wrong way */
  uint64_t double_sided_triangles;
  double bounds_min[3]; /**< metres */
  double bounds_max[3]; /**< metres */
  double diagonal;      /**< metres */
  uint64_t mesh_bytes;  /**< memory of triangles and connectivity */
  uint64_t tree_bytes;  /**< memory of the hierarchy; 0 as long as it is not built */
  uint64_t tree_nodes;
  double load_us; /**< time to read, weld and repair */
  double tree_us; /**< time to build the hierarchy */
} plp_model_info;

/** @brief Fills `info` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_model_info_init(plp_model_info* info);

/** @brief Tells what a model is. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_get_info(plp_model model, plp_model_info* info);

/** @brief One sentence about something that was repaired, kept or skipped; null if there is no such note.
 *  Valid as long as the model. @threadsafety any @since 0.1 */
PLP_API const char* plp_model_note(plp_model model, uint32_t index);

/** @brief Builds the model's hierarchy now rather than when something first comes near.
 *  @return PLP_ERROR_INVALID_HANDLE or _OUT_OF_MEMORY. @threadsafety any @since 0.1 */
PLP_API plp_result plp_model_prepare(plp_model model);

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
  double distance;
  double weight;     /**< of this point in its set: the weights of one set sum to 1 */
  double force[3];   /**< newtons, on the second model or on the tool, at point_b */
  plp_body body_a;   /**< 0 from plp_query */
  plp_body body_b;   /**< 0 from plp_query */
  uint32_t set;      /**< points of one plateau share it; 0, 1, … in order */
  uint8_t feature_a; /**< plp_feature */
  uint8_t feature_b; /**< plp_feature */
  uint8_t corner_a; /**< of triangle_a as it is searched: which vertex, or which edge (k joins corners k and k
                       + 1); 0 for a face. Turning a triangle's winding exchanges two of its corners. */
  uint8_t corner_b;
  uint32_t triangle_a; /**< a triangle that holds the feature, as numbered in the input */
  uint32_t triangle_b;
} plp_lmd;

/** Two triangles that touch or cross. */
typedef struct plp_overlap {
  plp_body body_a;
  plp_body body_b;
  uint32_t triangle_a; /**< as numbered in the input */
  uint32_t triangle_b;
} plp_overlap;

/** Work that a search did. */
typedef struct plp_work {
  uint64_t bodies;         /**< bodies whose bounding sphere was tested against the tool's */
  uint64_t body_pairs;     /**< searched */
  uint64_t node_pairs;     /**< pairs of hierarchy nodes visited */
  uint64_t triangle_pairs; /**< pairs of triangles tested */
  uint64_t descents;       /**< PLP_MODE_DESCENT: LMDs followed */
  uint64_t descent_steps;  /**< PLP_MODE_DESCENT: moves to other triangles */
  uint64_t front_entries;  /**< PLP_MODE_CERTIFIED: certificates kept */
  uint64_t front_expired;  /**< PLP_MODE_CERTIFIED: of those, renewed in this step */
  uint64_t age;            /**< steps since the search that the LMDs come from */
  double global_us;        /**< time of searches from scratch in this step */
  uint64_t rebuilds;       /**< PLP_MODE_CERTIFIED: of the node pairs, those tested to renew what is kept */
} plp_work;

/** What is not as it should be with an outcome: bits of plp_contacts::status. */
enum {
  PLP_STATUS_BY_DESCENT = 1 /**< plp_scene_options::tick_budget ran out: local descent from the last step
                               completed the set, which may lack new LMDs; all that it has are LMDs */
};

/** The outcome of a search. The arrays belong to the result or scene that it was read from. */
typedef struct plp_contacts {
  uint32_t struct_size;
  int32_t overlap; /**< 1: surfaces touch or cross, where no spring pushes; 0 also if one body is inside
                      another */
  const plp_lmd* lmds;
  size_t lmd_count;
  size_t lmd_stride; /**< bytes from one to the next: may be more than sizeof(plp_lmd) of this header */
  size_t set_count;  /**< LMDs, a plateau counted once */
  const plp_overlap* overlaps;
  size_t overlap_count;
  size_t overlap_stride;
  int32_t overlaps_cut; /**< 1: more pairs overlap than are listed */
  uint32_t reserved;
  double min_distance; /**< of the LMDs; infinite if there is none */
  plp_wrench wrench;
  double search_us;
  plp_work work;
  uint32_t status; /**< PLP_STATUS_* bits; 0: all well */
  uint32_t reserved2;
} plp_contacts;

/** @brief Fills `contacts` with zeros and its size. @threadsafety any @since 0.1 */
PLP_API void plp_contacts_init(plp_contacts* contacts);

/* ------------------------------------------------------------------------------------------------------------
 * query */

/** Room for the outcome of plp_query; reuse one to avoid allocations. */
typedef struct plp_query_result_t* plp_query_result;

/** @brief Makes an empty result. @return PLP_ERROR_INVALID_ARGUMENT, _LIMIT (about a million) or
 * _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_query_result_create(plp_query_result* result);

/** @brief Releases a result and its arrays. Null is allowed. @return PLP_ERROR_INVALID_HANDLE.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_query_result_release(plp_query_result result);

/** How plp_query searches and pushes. */
typedef struct plp_query_options {
  uint32_t struct_size;
  uint32_t max_overlaps;     /**< list at most so many overlapping pairs */
  double cutoff;             /**< metres, positive: LMDs farther apart are not searched */
  double stiffness;          /**< N/m, not negative: force = stiffness × (cutoff − distance) × weight */
  double reference_point[3]; /**< frame of B: torques are about it */
} plp_query_options;

/** @brief Fills `options`: no cutoff yet, 1000 N/m, torques about B's origin, up to 1024 overlaps.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_query_options_init(plp_query_options* options);

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
  uint32_t struct_size;
  uint32_t max_overlaps;
  plp_space space;       /**< of poses, points and wrenches of this scene */
  double cutoff;         /**< units of the space, positive */
  double stiffness;      /**< N/m, not negative */
  int32_t mode;          /**< plp_mode */
  uint32_t global_every; /**< PLP_MODE_DESCENT: steps from one search to the next; 0 for 10 */
  uint32_t threads;      /**< of plp_scene_step, with the caller's, at most 256; 0 and 1: the caller's alone.
                            The outcome does not depend on it, but with more the step blocks and locks. */
  uint32_t tick_budget; /**< PLP_MODE_CERTIFIED: at most so many tests of pairs of nodes and of triangles in a
                           step, shared equally by the bodies searched, at least 128 each; then descent. What
                           is left comes first in the next step, also if nothing moves. 0: no limit */
} plp_scene_options;

/** @brief Fills `options`: Palpate's space, no cutoff yet, 1000 N/m, up to 1024 overlaps.
 *  @threadsafety any @since 0.1 */
PLP_API void plp_scene_options_init(plp_scene_options* options);

/** @brief Makes an empty scene. @return PLP_ERROR_INVALID_ARGUMENT, _LIMIT (about a million) or
 * _OUT_OF_MEMORY.
 *  @threadsafety any @since 0.1 */
PLP_API plp_result plp_scene_create(const plp_scene_options* options, plp_scene* scene);

/** @brief Releases a scene and its bodies. Null is allowed. @return PLP_ERROR_INVALID_HANDLE.
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
  uint32_t struct_size;
  plp_body_kind kind;
  plp_model model;
  plp_pose pose;    /**< of the model's frame in the scene's space; a mirrored space mirrors the model, too */
  double stiffness; /**< N/m against the tool; 0: the scene's */
  double reference_point[3]; /**< of the tool, its own frame, scene units: torques are about it */
} plp_body_options;

/** @brief Fills `options`: static, identity pose, the scene's stiffness. @threadsafety any @since 0.1 */
PLP_API void plp_body_options_init(plp_body_options* options);

/** @brief Adds a body. The scene keeps the model.
 *  @return PLP_ERROR_INVALID_HANDLE, _INVALID_ARGUMENT (also for a second tool), _LIMIT or _OUT_OF_MEMORY.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_add_body(plp_scene scene, const plp_body_options* options, plp_body* body);

/** @brief Removes a body. @return PLP_ERROR_INVALID_HANDLE. @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_remove_body(plp_scene scene, plp_body body);

/** @brief Sets a body's pose. A static body may be moved, too.
 *  @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_set_pose(plp_scene scene, plp_body body, const plp_pose* pose);

/** @brief Reads a body's pose. @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_get_pose(plp_scene scene, plp_body body, plp_pose* pose);

/** @brief Sets the cutoff (units of the scene's space, positive). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_set_cutoff(plp_scene scene, double cutoff);

/** @brief Sets how LMDs are found from the next step on (plp_mode). @return PLP_ERROR_INVALID_HANDLE or
 *  _INVALID_ARGUMENT. @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_set_mode(plp_scene scene, int32_t mode);

/** @brief Sets the stiffness (N/m, not negative). @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT.
 *  @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_set_stiffness(plp_scene scene, double stiffness);

/**
 * @brief Searches the tool against every other body that is near and computes the wrench on the tool about
 * its reference point, in the scene's space. Without a tool there are no contacts. The same inputs give the
 * same bits.
 * @return PLP_ERROR_INVALID_HANDLE or _OUT_OF_MEMORY; then the last outcome is kept.
 * @threadsafety object @since 0.1
 */
PLP_API plp_result plp_scene_step(plp_scene scene);

/** @brief Reads the outcome of the last step. The arrays are valid until the next step or the scene's
 * release.
 *  @return PLP_ERROR_INVALID_HANDLE or _INVALID_ARGUMENT. @threadsafety object @since 0.1 */
PLP_API plp_result plp_scene_get_contacts(plp_scene scene, plp_contacts* contacts);

#ifdef __cplusplus
}
#endif

#endif /* PALPATE_PALPATE_H */
