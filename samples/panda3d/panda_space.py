"""Between Panda3D and Palpate: the vertex buffers of models, and poses. Panda3D has z up, and so has a scene made with
`space=SPACE`."""

import numpy
from panda3d.core import CullFaceAttrib, GeomEnums, GeomNode, InternalName, LQuaternion

import palpate

SPACE = palpate.Space((1, -3, 2))
INDEX_TYPES = {GeomEnums.NT_uint8: numpy.uint8, GeomEnums.NT_uint16: numpy.uint16, GeomEnums.NT_uint32: numpy.uint32}


def model_of(node_path):
    """All triangles of a node and below it, in the frame of that node. Double-sided if all are drawn so."""
    positions, corners, sides, count = [], [], set(), 0
    itself = [node_path] if isinstance(node_path.node(), GeomNode) else []
    for found in [*itself, *node_path.find_all_matches("**/+GeomNode")]:
        moved = numpy.array([list(row) for row in found.get_mat(node_path)])
        for geom, state in zip(found.node().get_geoms(), found.node().get_geom_states()):
            vertices = vertex_positions(geom.get_vertex_data())
            positions.append(vertices if found.get_transform(node_path).is_identity()
                             else vertices @ moved[:3, :3] + moved[3, :3])
            corners.append(triangle_indices(geom) + numpy.uint32(count))
            sides.add(is_double_sided(state))
            count += len(vertices)
    return palpate.Model.from_arrays(numpy.concatenate(positions), numpy.concatenate(corners), space=SPACE,
                                     double_sided=sides == {True})


def vertex_positions(data):
    """The rows of the buffer that hold the positions, without a copy."""
    array = data.get_array(data.get_format().get_array_with(InternalName.get_vertex()))
    column = array.get_array_format().get_column(InternalName.get_vertex())
    number = numpy.float32 if column.get_numeric_type() == GeomEnums.NT_float32 else numpy.float64
    stride = array.get_array_format().get_stride()
    return numpy.ndarray((array.get_num_rows(), 3), number, memoryview(array).cast("B"), column.get_start(),
                         (stride, number().itemsize))


def triangle_indices(geom):
    """Rows of three; strips and fans as the triangles that they are."""
    rows = []
    for primitive in geom.decompose().get_primitives():
        if primitive.is_indexed():
            indices = numpy.frombuffer(memoryview(primitive.get_vertices()).cast("B"),
                                       INDEX_TYPES[primitive.get_index_type()])
        else:
            first = primitive.get_first_vertex()
            indices = numpy.arange(first, first + primitive.get_num_vertices())
        rows.append(indices.astype(numpy.uint32).reshape(-1, 3))
    return numpy.concatenate(rows)


def is_double_sided(state):
    culling = state.get_attrib(CullFaceAttrib)
    return culling is not None and culling.get_actual_mode() == CullFaceAttrib.M_cull_none


def pose_of(node_path, other):
    """Where a node is in the frame of another one; it must not be scaled."""
    w, x, y, z = node_path.get_quat(other)
    return palpate.Pose(tuple(node_path.get_pos(other)), (x, y, z, w))


def set_pose(node_path, other, pose):
    x, y, z, w = pose.orientation
    node_path.set_pos_quat(other, tuple(pose.position), LQuaternion(w, x, y, z))
