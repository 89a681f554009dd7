"""palpate.h as it is: its constants, structs and functions under their own names. Nothing is checked here."""

from collections.abc import Callable
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int, c_int32, c_size_t, c_uint8, c_uint32,
                    c_uint64, c_void_p)
from typing import Any

from ._library import load

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

PLP_BODY_STATIC = 0
PLP_BODY_MOVING = 1
PLP_BODY_TOOL = 2
PLP_MODE_GLOBAL = 0
PLP_MODE_DESCENT = 1
PLP_MODE_CERTIFIED = 2
PLP_STATUS_BY_DESCENT = 1

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
        ("threads", c_uint32),
        ("tick_budget", c_uint32),
    ]


class plp_body_options(Structure):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int),
        ("model", c_void_p),
        ("pose", plp_pose),
        ("stiffness", c_double),
        ("reference_point", c_double * 3),
    ]


# A handle is an opaque value of a pointer's size; ctypes gives a null one back as None.
_handle = c_void_p
_body = c_uint64
_result = c_int32
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

plp_model_options_init = _function("plp_model_options_init", None, POINTER(plp_model_options))
plp_model_load_file = _function("plp_model_load_file", _result, c_char_p, POINTER(plp_model_options), POINTER(_handle))
plp_model_load_memory = _function("plp_model_load_memory", _result, c_void_p, c_size_t, c_char_p,
                                  POINTER(plp_model_options), POINTER(_handle))
plp_triangles_init = _function("plp_triangles_init", None, POINTER(plp_triangles))
plp_model_create_from_triangles = _function("plp_model_create_from_triangles", _result, POINTER(plp_triangles),
                                            POINTER(plp_model_options), POINTER(_handle))
plp_model_retain = _function("plp_model_retain", _result, _handle)
plp_model_release = _function("plp_model_release", _result, _handle)
plp_model_info_init = _function("plp_model_info_init", None, POINTER(plp_model_info))
plp_model_get_info = _function("plp_model_get_info", _result, _handle, POINTER(plp_model_info))
plp_model_note = _function("plp_model_note", c_char_p, _handle, c_uint32)
plp_model_prepare = _function("plp_model_prepare", _result, _handle)

plp_contacts_init = _function("plp_contacts_init", None, POINTER(plp_contacts))
plp_query_result_create = _function("plp_query_result_create", _result, POINTER(_handle))
plp_query_result_release = _function("plp_query_result_release", _result, _handle)
plp_query_options_init = _function("plp_query_options_init", None, POINTER(plp_query_options))
plp_query = _function("plp_query", _result, _handle, _handle, POINTER(plp_pose), POINTER(plp_query_options), _handle)
plp_query_result_get = _function("plp_query_result_get", _result, _handle, POINTER(plp_contacts))

plp_scene_options_init = _function("plp_scene_options_init", None, POINTER(plp_scene_options))
plp_scene_create = _function("plp_scene_create", _result, POINTER(plp_scene_options), POINTER(_handle))
plp_scene_release = _function("plp_scene_release", _result, _handle)
plp_body_options_init = _function("plp_body_options_init", None, POINTER(plp_body_options))
plp_scene_add_body = _function("plp_scene_add_body", _result, _handle, POINTER(plp_body_options), POINTER(_body))
plp_scene_remove_body = _function("plp_scene_remove_body", _result, _handle, _body)
plp_scene_set_pose = _function("plp_scene_set_pose", _result, _handle, _body, POINTER(plp_pose))
plp_scene_get_pose = _function("plp_scene_get_pose", _result, _handle, _body, POINTER(plp_pose))
plp_scene_set_cutoff = _function("plp_scene_set_cutoff", _result, _handle, c_double)
plp_scene_set_mode = _function("plp_scene_set_mode", _result, _handle, c_int32)
plp_scene_set_stiffness = _function("plp_scene_set_stiffness", _result, _handle, c_double)
plp_scene_step = _function("plp_scene_step", _result, _handle)
plp_scene_get_contacts = _function("plp_scene_get_contacts", _result, _handle, POINTER(plp_contacts))
