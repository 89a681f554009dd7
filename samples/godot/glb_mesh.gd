# The triangles of a GLB file, for drawing: Godot 3 imports glTF in its editor only. Its first primitive, with float
# positions and 32-bit indices, as palpate-make-assets writes them.
extends Reference

const HEADER = 12  # bytes; each chunk then has its length and its type before it


# As Mesh.surface_get_arrays gives them: clockwise, where glTF runs counter-clockwise.
static func arrays_of(path):
	var file = File.new()
	if file.open(path, File.READ) != OK:
		push_error(path + ": cannot be read")
		return []
	file.seek(HEADER)
	var json_length = file.get_32()
	file.seek(HEADER + 8)
	var document = JSON.parse(file.get_buffer(json_length).get_string_from_utf8()).result
	var buffer_start = HEADER + 8 + json_length + 8
	var primitive = document.meshes[0].primitives[0]
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = _positions(file, document, primitive.attributes.POSITION, buffer_start)
	arrays[Mesh.ARRAY_INDEX] = _clockwise(file, document, primitive.indices, buffer_start)
	return arrays


static func flat_mesh(arrays):
	var surface = SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	surface.add_smooth_group(false)
	for index in arrays[Mesh.ARRAY_INDEX]:
		surface.add_vertex(arrays[Mesh.ARRAY_VERTEX][index])
	surface.generate_normals()
	return surface.commit()


static func _seek(file, document, accessor, buffer_start):
	var view = document.bufferViews[accessor.bufferView]
	file.seek(int(buffer_start + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)))


static func _positions(file, document, index, buffer_start):
	var accessor = document.accessors[index]
	_seek(file, document, accessor, buffer_start)
	var positions = PoolVector3Array()
	for _i in range(int(accessor.count)):
		var x = file.get_float()
		var y = file.get_float()
		positions.append(Vector3(x, y, file.get_float()))
	return positions


static func _clockwise(file, document, index, buffer_start):
	var accessor = document.accessors[index]
	_seek(file, document, accessor, buffer_start)
	var indices = PoolIntArray()
	for _i in range(int(accessor.count) / 3):
		var first = file.get_32()
		var second = file.get_32()
		indices.append(first)
		indices.append(file.get_32())
		indices.append(second)
	return indices
