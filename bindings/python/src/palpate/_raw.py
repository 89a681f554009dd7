"""palpate.h as it is: its constants, structs and functions under their own names. Nothing is checked here.

Made from the header by bindings/gen/generate.py; do not edit."""

from collections.abc import Callable
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int, c_int32, c_size_t, c_uint8,
                    c_uint32, c_uint64, c_void_p)
from typing import Any

from ._library import load

PLP_VERSION_MAJOR = 0
PLP_VERSION_MINOR = 1
PLP_VERSION_PATCH = 0

PLP_OK = 0
PLP_ERROR_INVALID_ARGUMENT = -1
PLP_ERROR_INVALID_HANDLE = -2
PLP_ERROR_OUT_OF_MEMORY = -3
PLP_ERROR_FILE_NOT_FOUND = -4
PLP_ERROR_FILE_READ = -5
PLP_ERROR_BAD_FORMAT = -6
PLP_ERROR_UNSUPPORTED = -7
PLP_ERROR_NO_TRIANGLES = -8
PLP_ERROR_NON_FINITE = -9
PLP_ERROR_LIMIT = -10
PLP_ERROR_UNSAFE_PATH = -11
PLP_ERROR_WRONG_STATE = -12
PLP_ERROR_DEVICE = -13
PLP_ERROR_FILE_WRITE = -14
PLP_ERROR_INTERNAL = -100

PLP_LOG_ERROR = 0
PLP_LOG_WARNING = 1
PLP_LOG_INFO = 2
PLP_LOG_DEBUG = 3

PLP_MODEL_DOUBLE_SIDED = 1
PLP_MODEL_KEEP_WINDING = 2

PLP_TYPE_NONE = 0
PLP_TYPE_FLOAT32 = 1
PLP_TYPE_FLOAT64 = 2
PLP_TYPE_UINT8 = 3
PLP_TYPE_UINT16 = 4
PLP_TYPE_UINT32 = 5

PLP_ORIENTATION_OPEN = 0
PLP_ORIENTATION_OUTWARD = 1
PLP_ORIENTATION_INWARD = 2
PLP_ORIENTATION_MIXED = 3

PLP_FEATURE_FACE = 0
PLP_FEATURE_EDGE = 1
PLP_FEATURE_VERTEX = 2

PLP_STATUS_BY_DESCENT = 1
PLP_STATUS_CUT = 2
PLP_STATUS_WAITING = 4
PLP_STATUS_WALL = 8

PLP_LAW_SPRINGS = 0
PLP_LAW_SMOOTH = 1

PLP_MODE_GLOBAL = 0
PLP_MODE_DESCENT = 1
PLP_MODE_CERTIFIED = 2

PLP_BODY_STATIC = 0
PLP_BODY_MOVING = 1
PLP_BODY_TOOL = 2

PLP_CONDITION_READY = 0
PLP_CONDITION_NEEDS_CALIBRATION = 1
PLP_CONDITION_WARM_MOTORS = 2
PLP_CONDITION_EXCEEDED_FORCE = 3
PLP_CONDITION_EXCEEDED_VELOCITY = 4
PLP_CONDITION_LOST = 5
PLP_CONDITION_FAILED = 6
PLP_CONDITION_NO_LIBRARY = 7
PLP_CONDITION_WRONG_LIBRARY = 8
PLP_CONDITION_CANNOT_OPEN = 9
PLP_CONDITION_WITHHELD = 10

PLP_SAFETY_DISARMED = 0
PLP_SAFETY_RAMPING = 1
PLP_SAFETY_ARMED = 2
PLP_SAFETY_FAULT = 3

PLP_LIMITER_LONG_TICK = 0
PLP_LIMITER_NON_FINITE_WRENCH = 1
PLP_LIMITER_NON_FINITE_POSE = 2
PLP_LIMITER_POSE_JUMP = 3
PLP_LIMITER_STALE_SERVO = 4
PLP_LIMITER_STALE_POSE = 5
PLP_LIMITER_FORCE_CLAMP = 6
PLP_LIMITER_TORQUE_CLAMP = 7
PLP_LIMITER_FORCE_SLEW = 8
PLP_LIMITER_TORQUE_SLEW = 9
PLP_LIMITER_RAMP = 10
PLP_LIMITER_DEVICE = 11

PLP_GRIP_RELEASED = 0
PLP_GRIP_LIGHT = 1
PLP_GRIP_FIRM = 2
PLP_GRIP_OWN = 3

PLP_HAND_HOLD = 0
PLP_HAND_TAP = 1
PLP_HAND_PRESS = 2
PLP_HAND_SLIDE = 3
PLP_HAND_WEDGE = 4
PLP_HAND_CIRCLE = 5

PLP_DEVICE_KEEP_TOOL_POSE = 1

plp_log_callback = CFUNCTYPE(None, c_int, c_char_p, c_void_p)


class plp_pose(Structure):
    _fields_ = [("position", c_double * 3), ("orientation", c_double * 4)]


class plp_wrench(Structure):
    _fields_ = [("force", c_double * 3), ("torque", c_double * 3)]


class plp_space(Structure):
    _fields_ = [("axes", c_int32 * 3), ("reserved", c_int32), ("metres_per_unit", c_double)]


class plp_model_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("weld_tolerance", c_double),
        ("gltf_scene", c_int32),
        ("reserved", c_uint32),
        ("max_triangles", c_uint64),
        ("scale", c_double),
    ]


class plp_triangles(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("positions", c_void_p),
        ("position_stride", c_size_t),
        ("vertex_count", c_size_t),
        ("indices", c_void_p),
        ("index_stride", c_size_t),
        ("triangle_count", c_size_t),
        ("position_type", c_int),
        ("index_type", c_int),
        ("space", plp_space),
    ]


class plp_surface_counts(Structure):
    _fields_ = [
        ("triangles", c_uint64),
        ("vertices", c_uint64),
        ("edges", c_uint64),
        ("boundary_edges", c_uint64),
        ("nonmanifold_edges", c_uint64),
        ("inconsistent_edges", c_uint64),
        ("components", c_uint64),
        ("orientation", c_int32),
        ("watertight", c_int32),
    ]


class plp_model_info(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("note_count", c_uint32),
        ("source", plp_surface_counts),
        ("searched", plp_surface_counts),
        ("stored_vertices", c_uint64),
        ("degenerate_triangles", c_uint64),
        ("duplicate_triangles", c_uint64),
        ("split_triangles", c_uint64),
        ("reversed_triangles", c_uint64),
        ("flipped_components", c_uint64),
        ("double_sided_triangles", c_uint64),
        ("bounds_min", c_double * 3),
        ("bounds_max", c_double * 3),
        ("diagonal", c_double),
        ("mesh_bytes", c_uint64),
        ("tree_bytes", c_uint64),
        ("tree_nodes", c_uint64),
        ("load_us", c_double),
        ("tree_us", c_double),
        ("read_bytes", c_uint64),
        ("decoded_bytes", c_uint64),
    ]


class plp_lmd(Structure):
    _fields_ = [
        ("point_a", c_double * 3),
        ("point_b", c_double * 3),
        ("normal", c_double * 3),
        ("distance", c_double),
        ("weight", c_double),
        ("force", c_double * 3),
        ("body_a", c_uint64),
        ("body_b", c_uint64),
        ("set", c_uint32),
        ("feature_a", c_uint8),
        ("feature_b", c_uint8),
        ("corner_a", c_uint8),
        ("corner_b", c_uint8),
        ("triangle_a", c_uint32),
        ("triangle_b", c_uint32),
    ]


class plp_overlap(Structure):
    _fields_ = [("body_a", c_uint64), ("body_b", c_uint64), ("triangle_a", c_uint32), ("triangle_b", c_uint32)]


class plp_work(Structure):
    _fields_ = [
        ("bodies", c_uint64),
        ("body_pairs", c_uint64),
        ("node_pairs", c_uint64),
        ("triangle_pairs", c_uint64),
        ("descents", c_uint64),
        ("descent_steps", c_uint64),
        ("front_entries", c_uint64),
        ("front_expired", c_uint64),
        ("age", c_uint64),
        ("global_us", c_double),
        ("rebuilds", c_uint64),
    ]


class plp_contacts(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("overlap", c_int32),
        ("lmds", c_void_p),
        ("lmd_count", c_size_t),
        ("lmd_stride", c_size_t),
        ("set_count", c_size_t),
        ("overlaps", c_void_p),
        ("overlap_count", c_size_t),
        ("overlap_stride", c_size_t),
        ("overlaps_cut", c_int32),
        ("reserved", c_uint32),
        ("min_distance", c_double),
        ("wrench", plp_wrench),
        ("search_us", c_double),
        ("work", plp_work),
        ("springs", c_void_p),
        ("spring_count", c_size_t),
        ("status", c_uint32),
        ("reserved2", c_uint32),
    ]


class plp_query_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("max_overlaps", c_uint32),
        ("cutoff", c_double),
        ("stiffness", c_double),
        ("reference_point", c_double * 3),
        ("law", c_int32),
        ("reserved", c_uint32),
    ]


class plp_scene_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("max_overlaps", c_uint32),
        ("space", plp_space),
        ("cutoff", c_double),
        ("stiffness", c_double),
        ("mode", c_int32),
        ("global_every", c_uint32),
        ("law", c_int32),
        ("threads", c_uint32),
        ("damping", c_double),
        ("stiffness_cap", c_double),
        ("friction", c_double),
        ("fade_time", c_double),
        ("time_step", c_double),
        ("tick_budget", c_uint32),
        ("reserved", c_uint32),
    ]


class plp_body_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int),
        ("model", c_void_p),
        ("pose", plp_pose),
        ("stiffness", c_double),
        ("reference_point", c_double * 3),
        ("damping", c_double),
        ("friction", c_double),
        ("intangible", c_int32),
        ("reserved", c_uint32),
    ]


class plp_body_info(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int),
        ("name", c_char * 256),
        ("node", c_int32),
        ("intangible", c_int32),
        ("above", c_uint64),
        ("triangles", c_uint64),
        ("stiffness", c_double),
        ("damping", c_double),
        ("friction", c_double),
    ]


class plp_gltf_scene_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("model", c_void_p),
        ("tool", c_void_p),
        ("pose", plp_pose),
        ("cutoff", c_double),
    ]


class plp_servo_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("rate", c_double),
        ("priority", c_int32),
        ("cpu", c_int32),
    ]


class plp_servo_state(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("running", c_int32),
        ("priority", c_int32),
        ("cpu", c_int32),
        ("wanted_rate", c_double),
        ("rate", c_double),
        ("ticks", c_uint64),
        ("missed", c_uint64),
        ("skipped", c_uint64),
        ("work_us", c_double * 4),
        ("lateness_us", c_double * 4),
        ("waiting_ticks", c_uint64),
        ("cut_ticks", c_uint64),
        ("preparations", c_uint64),
        ("searches", c_uint64),
        ("result_age", c_uint64),
    ]


class plp_device_info(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("buttons", c_uint32),
        ("sensed", c_uint32),
        ("actuated", c_uint32),
        ("uri", c_char * 256),
        ("name", c_char * 256),
        ("serial", c_char * 64),
        ("max_force", c_double),
        ("continuous_force", c_double),
        ("max_torque", c_double),
        ("continuous_torque", c_double),
        ("max_stiffness", c_double),
        ("max_damping", c_double),
        ("position_resolution", c_double),
        ("angle_resolution", c_double),
        ("update_rate", c_double),
        ("workspace_min", c_double * 3),
        ("workspace_max", c_double * 3),
        ("condition", c_int32),
        ("reserved", c_uint32),
        ("status", c_char * 512),
    ]


class plp_device_state(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("buttons", c_uint32),
        ("pose", plp_pose),
        ("linear_velocity", c_double * 3),
        ("angular_velocity", c_double * 3),
        ("time", c_double),
        ("sequence", c_uint64),
        ("calibrated", c_int32),
        ("safety", c_int32),
        ("commanded", plp_wrench),
        ("applied", plp_wrench),
        ("gain", c_double),
        ("limiters", c_uint32),
        ("unactuated", c_int32),
        ("ticks", c_uint64),
        ("limiter_ticks", c_uint64 * 16),
        ("condition", c_int32),
        ("reserved", c_uint32),
        ("temperature", c_double),
        ("lost", c_uint64),
    ]


class plp_safety_limits(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("dead_man", c_uint32),
        ("max_force", c_double),
        ("max_torque", c_double),
        ("force_slew", c_double),
        ("torque_slew", c_double),
        ("max_speed", c_double),
        ("max_turn_rate", c_double),
        ("watchdog", c_double),
        ("ramp_time", c_double),
        ("fault_hold", c_double),
    ]


class plp_hand_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("grip", c_int32),
        ("script", c_int32),
        ("buttons", c_uint32),
        ("mass", c_double),
        ("damping", c_double),
        ("stiffness", c_double),
        ("inertia", c_double),
        ("angular_damping", c_double),
        ("angular_stiffness", c_double),
        ("origin", plp_pose),
        ("into", c_double * 3),
        ("along", c_double * 3),
        ("depth", c_double),
        ("travel", c_double),
        ("twist", c_double),
        ("period", c_double),
    ]


class plp_device_mapping(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("scene_from_base", plp_pose),
        ("handle_from_tool", plp_pose),
        ("motion_scale", c_double),
        ("force_scale", c_double),
        ("clutch_buttons", c_uint32),
        ("reserved", c_uint32),
        ("torque_lever", c_double * 3),
    ]


class plp_recording(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("running", c_int32),
        ("ticks", c_uint64),
        ("lost", c_uint64),
        ("bytes", c_uint64),
    ]


class plp_trace_info(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("complete", c_int32),
        ("ticks", c_uint64),
        ("lost", c_uint64),
        ("bodies", c_uint64),
        ("bytes", c_uint64),
        ("duration", c_double),
    ]


class plp_trace_body(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("body", c_uint64),
        ("model_name", c_void_p),
        ("model_triangles", c_uint64),
        ("model_hash", c_uint64),
        ("stiffness", c_double),
        ("damping", c_double),
        ("friction", c_double),
        ("reference_point", c_double * 3),
        ("first_tick", c_uint64),
        ("end_tick", c_uint64),
        ("intangible", c_int32),
        ("reserved", c_uint32),
    ]


class plp_trace_move(Structure):
    _fields_ = [("body", c_uint64), ("pose", plp_pose)]


class plp_trace_tick(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("status", c_uint32),
        ("step", c_uint64),
        ("lost", c_uint64),
        ("time", c_double),
        ("clock", c_double),
        ("time_step", c_double),
        ("cutoff", c_double),
        ("stiffness", c_double),
        ("damping", c_double),
        ("stiffness_cap", c_double),
        ("friction", c_double),
        ("mode", c_int32),
        ("law", c_int32),
        ("tool", c_uint64),
        ("tool_pose", plp_pose),
        ("wrench", plp_wrench),
        ("min_distance", c_double),
        ("set_count", c_uint64),
        ("lmd_count", c_uint64),
        ("overlap_count", c_uint64),
        ("overlap", c_int32),
        ("reserved", c_uint32),
        ("step_us", c_double),
        ("moves", c_void_p),
        ("move_count", c_size_t),
        ("move_stride", c_size_t),
        ("removed", c_void_p),
        ("removed_count", c_size_t),
    ]


# A handle is an opaque value of a pointer's size; ctypes gives a null one back as None.
_handle = c_void_p
_result = c_int32
_body = c_uint64
_library = load()


def _function(name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    try:
        function = getattr(_library, name)
    except AttributeError:
        raise ImportError(f"{_library._name} is of another version than this package: it has no {name}") from None
    function.restype = result
    function.argtypes = arguments
    return function  # type: ignore[no-any-return]


plp_version = _function("plp_version", c_uint32)
plp_version_string = _function("plp_version_string", c_char_p)
plp_result_string = _function("plp_result_string", c_char_p, _result)
plp_last_error = _function("plp_last_error", c_char_p)
plp_set_log_callback = _function("plp_set_log_callback", None, plp_log_callback, c_void_p)

plp_model_options_init = _function("plp_model_options_init", None, POINTER(plp_model_options), c_size_t)
plp_model_load_file = _function("plp_model_load_file", _result, c_char_p, POINTER(plp_model_options), POINTER(_handle))
plp_model_load_memory = _function("plp_model_load_memory", _result, c_void_p, c_size_t, c_char_p,
                                  POINTER(plp_model_options), POINTER(_handle))
plp_triangles_init = _function("plp_triangles_init", None, POINTER(plp_triangles), c_size_t)
plp_model_create_from_triangles = _function("plp_model_create_from_triangles", _result, POINTER(plp_triangles),
                                            POINTER(plp_model_options), POINTER(_handle))
plp_model_retain = _function("plp_model_retain", _result, _handle)
plp_model_release = _function("plp_model_release", _result, _handle)
plp_model_info_init = _function("plp_model_info_init", None, POINTER(plp_model_info), c_size_t)
plp_model_get_info = _function("plp_model_get_info", _result, _handle, POINTER(plp_model_info))
plp_model_note = _function("plp_model_note", c_char_p, _handle, c_uint32)
plp_model_prepare = _function("plp_model_prepare", _result, _handle)
plp_model_get_hash = _function("plp_model_get_hash", _result, _handle, POINTER(c_uint64))
plp_model_get_vertices = _function("plp_model_get_vertices", _result, _handle, POINTER(c_double), c_size_t,
                                   POINTER(c_size_t))
plp_model_get_triangles = _function("plp_model_get_triangles", _result, _handle, POINTER(c_uint32), POINTER(c_uint32),
                                    c_size_t, POINTER(c_size_t))

plp_contacts_init = _function("plp_contacts_init", None, POINTER(plp_contacts), c_size_t)

plp_query_result_create = _function("plp_query_result_create", _result, POINTER(_handle))
plp_query_result_release = _function("plp_query_result_release", _result, _handle)
plp_query_options_init = _function("plp_query_options_init", None, POINTER(plp_query_options), c_size_t)
plp_query = _function("plp_query", _result, _handle, _handle, POINTER(plp_pose), POINTER(plp_query_options), _handle)
plp_query_result_get = _function("plp_query_result_get", _result, _handle, POINTER(plp_contacts))

plp_scene_options_init = _function("plp_scene_options_init", None, POINTER(plp_scene_options), c_size_t)
plp_scene_create = _function("plp_scene_create", _result, POINTER(plp_scene_options), POINTER(_handle))
plp_scene_release = _function("plp_scene_release", _result, _handle)
plp_body_options_init = _function("plp_body_options_init", None, POINTER(plp_body_options), c_size_t)
plp_scene_add_body = _function("plp_scene_add_body", _result, _handle, POINTER(plp_body_options), POINTER(_body))
plp_scene_remove_body = _function("plp_scene_remove_body", _result, _handle, _body)
plp_scene_set_pose = _function("plp_scene_set_pose", _result, _handle, _body, POINTER(plp_pose))
plp_scene_get_pose = _function("plp_scene_get_pose", _result, _handle, _body, POINTER(plp_pose))
plp_scene_set_cutoff = _function("plp_scene_set_cutoff", _result, _handle, c_double)
plp_scene_set_mode = _function("plp_scene_set_mode", _result, _handle, c_int32)
plp_scene_set_law = _function("plp_scene_set_law", _result, _handle, c_int32)
plp_scene_set_stiffness = _function("plp_scene_set_stiffness", _result, _handle, c_double)
plp_scene_set_damping = _function("plp_scene_set_damping", _result, _handle, c_double)
plp_scene_set_stiffness_cap = _function("plp_scene_set_stiffness_cap", _result, _handle, c_double)
plp_scene_set_friction = _function("plp_scene_set_friction", _result, _handle, c_double)
plp_scene_step = _function("plp_scene_step", _result, _handle)
plp_scene_get_contacts = _function("plp_scene_get_contacts", _result, _handle, POINTER(plp_contacts))
plp_body_info_init = _function("plp_body_info_init", None, POINTER(plp_body_info), c_size_t)
plp_scene_get_body_info = _function("plp_scene_get_body_info", _result, _handle, _body, POINTER(plp_body_info))
plp_scene_list_bodies = _function("plp_scene_list_bodies", _result, _handle, POINTER(_body), c_size_t,
                                  POINTER(c_size_t))
plp_scene_find_body = _function("plp_scene_find_body", _result, _handle, c_char_p, POINTER(_body))
plp_scene_get_body_model = _function("plp_scene_get_body_model", _result, _handle, _body, POINTER(_handle))

plp_gltf_scene_options_init = _function("plp_gltf_scene_options_init", None, POINTER(plp_gltf_scene_options), c_size_t)
plp_scene_load_gltf = _function("plp_scene_load_gltf", _result, _handle, c_char_p, POINTER(plp_gltf_scene_options),
                                POINTER(_body), c_size_t, POINTER(c_size_t))
plp_scene_get_node_matrix = _function("plp_scene_get_node_matrix", _result, _handle, _body, POINTER(c_double))

plp_servo_options_init = _function("plp_servo_options_init", None, POINTER(plp_servo_options), c_size_t)
plp_scene_start = _function("plp_scene_start", _result, _handle, POINTER(plp_servo_options))
plp_scene_stop = _function("plp_scene_stop", _result, _handle)
plp_servo_state_init = _function("plp_servo_state_init", None, POINTER(plp_servo_state), c_size_t)
plp_scene_get_servo = _function("plp_scene_get_servo", _result, _handle, POINTER(plp_servo_state))
plp_shutdown_all = _function("plp_shutdown_all", _result)

plp_device_info_init = _function("plp_device_info_init", None, POINTER(plp_device_info), c_size_t)
plp_device_list = _function("plp_device_list", _result, POINTER(plp_device_info), c_size_t, POINTER(c_size_t))
plp_device_open = _function("plp_device_open", _result, c_char_p, POINTER(_handle))
plp_device_retain = _function("plp_device_retain", _result, _handle)
plp_device_release = _function("plp_device_release", _result, _handle)
plp_device_get_info = _function("plp_device_get_info", _result, _handle, POINTER(plp_device_info))
plp_device_state_init = _function("plp_device_state_init", None, POINTER(plp_device_state), c_size_t)
plp_device_get_state = _function("plp_device_get_state", _result, _handle, POINTER(plp_device_state))
plp_device_arm = _function("plp_device_arm", _result, _handle)
plp_device_calibrate = _function("plp_device_calibrate", _result, _handle)
plp_device_disarm = _function("plp_device_disarm", _result, _handle)
plp_safety_limits_init = _function("plp_safety_limits_init", None, POINTER(plp_safety_limits), c_size_t)
plp_device_set_limits = _function("plp_device_set_limits", _result, _handle, POINTER(plp_safety_limits))
plp_hand_options_init = _function("plp_hand_options_init", None, POINTER(plp_hand_options), c_size_t)
plp_device_set_hand = _function("plp_device_set_hand", _result, _handle, POINTER(plp_hand_options))
plp_device_set_hand_poses = _function("plp_device_set_hand_poses", _result, _handle, POINTER(c_double),
                                      POINTER(plp_pose), c_size_t)
plp_device_place_in_hand = _function("plp_device_place_in_hand", _result, _handle)
plp_device_mapping_init = _function("plp_device_mapping_init", None, POINTER(plp_device_mapping), c_size_t)
plp_scene_set_device = _function("plp_scene_set_device", _result, _handle, _handle, POINTER(plp_device_mapping))

plp_recording_init = _function("plp_recording_init", None, POINTER(plp_recording), c_size_t)
plp_scene_record = _function("plp_scene_record", _result, _handle, c_char_p)
plp_scene_stop_recording = _function("plp_scene_stop_recording", _result, _handle, POINTER(plp_recording))
plp_scene_get_recording = _function("plp_scene_get_recording", _result, _handle, POINTER(plp_recording))
plp_trace_open = _function("plp_trace_open", _result, c_char_p, POINTER(_handle))
plp_trace_release = _function("plp_trace_release", _result, _handle)
plp_trace_info_init = _function("plp_trace_info_init", None, POINTER(plp_trace_info), c_size_t)
plp_trace_get_info = _function("plp_trace_get_info", _result, _handle, POINTER(plp_trace_info))
plp_trace_get_options = _function("plp_trace_get_options", _result, _handle, POINTER(plp_scene_options))
plp_trace_body_init = _function("plp_trace_body_init", None, POINTER(plp_trace_body), c_size_t)
plp_trace_get_body = _function("plp_trace_get_body", _result, _handle, c_uint64, POINTER(plp_trace_body))
plp_trace_tick_init = _function("plp_trace_tick_init", None, POINTER(plp_trace_tick), c_size_t)
plp_trace_read = _function("plp_trace_read", _result, _handle, c_uint64, POINTER(plp_trace_tick))
plp_trace_get_contacts = _function("plp_trace_get_contacts", _result, _handle, POINTER(plp_contacts))
plp_trace_place = _function("plp_trace_place", _result, _handle, c_uint64, _body, _handle, _body)
