# Runs every test below in the engine and prints a line for each. Arguments are --NAME=VALUE: models, a folder; vectors,
# a JSON file; trajectory and trace, the CSV file of poses to step through and the file of doubles to write.
extends SceneTree

const GlbMesh = preload("res://glb_mesh.gd")
const PalpateScene = preload("res://addons/palpate/scene.gdns")

const CUTOFF = 0.003  # m

var arguments = {}
var failures = []


func _init():
	for argument in OS.get_cmdline_args():
		if argument.begins_with("--") and "=" in argument:
			var parts = argument.substr(2).split("=", true, 1)
			arguments[parts[0]] = parts[1]
	for method in get_method_list():
		if method.name.begins_with("test_"):
			failures = []
			call(method.name)
			print("failed " if failures else "passed ", method.name, " ", PoolStringArray(failures).join("; "))
	quit()


func expect(condition, what):
	if not condition:
		failures.append(str(what))


func expect_near(actual, expected, tolerance, what):
	expect(abs(actual - expected) <= tolerance, "%s is %s instead of %s" % [what, actual, expected])


func model_path(name):
	return arguments.models.plus_file(name)


func pair(options, body_name = "crankshaft_45k.glb", tool_name = "gear_6k.glb"):
	var scene = PalpateScene.new()
	expect(scene.create(options), "a scene")
	scene.add_body(scene.load_model(model_path(body_name)), "static")
	return [scene, scene.add_body(scene.load_model(model_path(tool_name)), "tool")]


# By JSON, because float("0.1") is 0.1 in single precision.
func trajectory():
	var file = File.new()
	file.open(arguments.trajectory, File.READ)
	file.get_line()
	var poses = []
	while not file.eof_reached():
		var numbers = JSON.parse("[" + file.get_line() + "]").result
		if numbers.size() == 8:
			poses.append(numbers.slice(1, 7))
	return poses


func transform_of(numbers):
	var turn = Quat(numbers[3], numbers[4], numbers[5], numbers[6]).normalized()
	return Transform(Basis(turn), Vector3(numbers[0], numbers[1], numbers[2]))


# Wrenches of all poses by doubles, for the one who started this to compare; then by Transform, which has floats.
func test_trace():
	var set = pair({"cutoff": CUTOFF, "stiffness": 1000, "mode": "certified", "law": "smooth"})
	var file = File.new()
	file.open(arguments.trace, File.WRITE)
	var poses = trajectory()
	expect(poses.size() > 0, "poses")
	var exact = []
	for numbers in poses:
		expect(set[0].set_exact_pose(set[1], numbers) and set[0].step(), set[0].last_error())
		for number in set[0].get_exact_wrench():
			file.store_double(number)
		exact.append(set[0].get_force())
	file.close()
	for i in range(poses.size()):
		expect(set[0].set_pose(set[1], transform_of(poses[i])) and set[0].step(), set[0].last_error())
		# Floats place a point of the gear to about 1e-8 m.
		expect_near((set[0].get_force() - exact[i]).length(), 0, 1e-3, "difference of forces")


func test_a_mesh_gives_the_forces_of_its_file():
	var file = pair({"cutoff": 0.02})
	file[0].set_exact_pose(file[1], [-0.005, 0.0703, -0.02, -0.5, 0, 0, 0.866])
	file[0].step()
	var scene = PalpateScene.new()
	scene.create({"cutoff": 0.02})
	var crankshaft = scene.model_from_arrays(GlbMesh.arrays_of(model_path("crankshaft_45k.glb")), {"keep_winding": true})
	var gear = scene.model_from_arrays(GlbMesh.arrays_of(model_path("gear_6k.glb")), {"keep_winding": true})
	scene.add_body(crankshaft, "static")
	scene.set_exact_pose(scene.add_body(gear, "tool"), [-0.005, 0.0703, -0.02, -0.5, 0, 0, 0.866])
	scene.step()
	expect(file[0].get_set_count() > 0, "contacts")
	expect(file[0].get_exact_wrench() == scene.get_exact_wrench(), scene.get_exact_wrench())


func test_godots_own_meshes_face_outward():
	var scene = PalpateScene.new()
	scene.create({"cutoff": 0.5, "stiffness": 100})
	var cube = CubeMesh.new()  # of 2 m
	var ball = SphereMesh.new()  # of 1 m
	scene.add_body(scene.model_from_arrays(cube.get_mesh_arrays(), {"keep_winding": true}), "static")
	var body = scene.add_body(scene.model_from_arrays(ball.get_mesh_arrays(), {"keep_winding": true}), "tool",
		Transform(Basis.IDENTITY, Vector3(0, 2.25, 0)))
	scene.step()
	expect_near(scene.get_min_distance(), 0.25, 1e-6, "distance")
	expect_near(scene.get_force().y, 25, 1e-2, "force")  # its pole is not quite one point
	var contacts = scene.get_contacts()
	expect(contacts.size() == 1 and contacts[0].body_b == body, contacts)
	expect_near((contacts[0].point_a - Vector3(0, 1, 0)).length(), 0, 1e-6, "point_a")


func test_poses_come_back():
	var set = pair({"cutoff": CUTOFF})
	var random = RandomNumberGenerator.new()
	random.seed = 7
	for _i in range(200):
		var axis = Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
		var pose = Transform(Basis(axis, random.randf_range(-PI, PI)), 10 * axis)
		expect(set[0].set_pose(set[1], pose), set[0].last_error())
		var back = set[0].get_pose(set[1])
		expect_near((back.origin - pose.origin).length(), 0, 1e-6, "origin")
		for column in [0, 1, 2]:
			expect_near((back.basis[column] - pose.basis[column]).length(), 0, 1e-6, "column of the basis")


func test_spaces():
	if not "vectors" in arguments:
		return
	var file = File.new()
	file.open(arguments.vectors, File.READ)
	var vectors = JSON.parse(file.get_as_text()).result
	var found = false
	for told in vectors.spaces:
		if "Godot" in told.name:
			found = true
			check_space(told, vectors.stiffness)
	expect(found, "a space that is Godot's")


func check_space(told, stiffness):
	var scene = PalpateScene.new()
	scene.create({"cutoff": told.cutoff, "stiffness": stiffness, "metres_per_unit": told.metres_per_unit})
	add_told(scene, told.body, "static")
	add_told(scene, told.tool, "tool")
	expect(scene.step(), scene.last_error())
	var wrench = scene.get_exact_wrench()
	for i in range(3):
		expect_near(wrench[i], told.force[i], 1e-3, "force")
		expect_near(wrench[3 + i], told.torque[i], 1e-3, "torque")
	expect_near(scene.get_min_distance(), told.distance, 1e-5 * told.cutoff, "distance")


func add_told(scene, body, kind):
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	var positions = PoolVector3Array()
	for vertex in body.vertices:
		positions.append(Vector3(vertex[0], vertex[1], vertex[2]))
	var indices = PoolIntArray()
	for corners in body.triangles:
		for corner in [0, 2, 1]:  # clockwise
			indices.append(int(corners[corner]))
	arrays[Mesh.ARRAY_VERTEX] = positions
	arrays[Mesh.ARRAY_INDEX] = indices
	var added = scene.add_body(scene.model_from_arrays(arrays, {"keep_winding": true}), kind)
	expect(scene.set_exact_pose(added, body.position + body.orientation), scene.last_error())


func test_a_servo_steps_beside_the_engine():
	var set = pair({"cutoff": CUTOFF})
	set[0].set_exact_pose(set[1], [-0.005, 0.0703, -0.02, -0.5, 0, 0, 0.866])
	set[0].step()
	var stepped = set[0].get_exact_wrench()
	expect(set[0].start(500), set[0].last_error())
	expect(not set[0].step() and "servo" in set[0].last_error(), set[0].last_error())
	for _i in range(1000):
		OS.delay_msec(5)
		if set[0].poll() and set[0].get_set_count() > 0:
			break
	expect(set[0].get_exact_wrench() == stepped, set[0].get_exact_wrench())
	expect(set[0].stop() and set[0].step(), set[0].last_error())


func test_a_device_holds_the_tool():
	var set = pair({"cutoff": CUTOFF})
	expect(not set[0].open_device("sim:none") and "sim:premium6dof" in set[0].last_error(), set[0].last_error())
	expect(not set[0].arm_device(), "there is no device yet")
	set[0].set_pose(set[1], Transform(Basis.IDENTITY, Vector3(5, 5, 5)))
	expect(set[0].open_device("sim:premium6dof") and set[0].arm_device() and set[0].step(), set[0].last_error())
	expect(set[0].get_pose(set[1]).origin.length() < 1, "the tool is in the hand")
	expect(set[0].disarm_device() and set[0].close_device(), set[0].last_error())


func test_mistakes_are_told():
	var scene = PalpateScene.new()
	expect(not scene.step() and scene.last_error() != "", "a step before create")
	expect(not scene.create({"cutof": 1}) and "cutof" in scene.last_error(), scene.last_error())
	expect(not scene.create({"cutoff": "1"}) and "cutoff" in scene.last_error(), scene.last_error())
	expect(not scene.create({"cutoff": 0.01, "mode": "fast"}) and "fast" in scene.last_error(), scene.last_error())
	expect(not scene.create({"cutoff": NAN}), "a cutoff that is none")
	expect(scene.create({"cutoff": 0.01}), scene.last_error())
	expect(scene.load_model("/none.glb") == 0 and "/none.glb" in scene.last_error(), scene.last_error())
	expect(scene.model_from_arrays([]) == 0, "no arrays")
	expect(scene.model_from_arrays([1, 2, 3, 4, 5, 6, 7, 8, 9]) == 0, "arrays of something else")
	expect(scene.add_body(12345, "static") == 0, "a model that is none")
	var model = scene.load_model(model_path("box.glb"))
	expect(scene.add_body(model, "stick") == 0 and "tool" in scene.last_error(), scene.last_error())
	expect(scene.add_body(model, "static", Transform().scaled(Vector3(2, 2, 2))) == 0, "a scaled pose")
	expect(scene.add_body(model, "static", Transform().scaled(Vector3(-1, 1, 1))) == 0, "a mirrored pose")
	expect(scene.add_body(model, "static", Transform(Basis(), Vector3(NAN, 0, 0))) == 0, "a pose that is none")
	expect(scene.set_exact_pose(1, [1, 2, 3]) == false and "seven" in scene.last_error(), scene.last_error())
	expect(scene.set_exact_pose(1, [1, 2, 3, 4, 5, 6, "7"]) == false, "a text among the numbers")
	expect(scene.get_pose(99) == null, "a body that is none")
	expect(scene.add_body("box", "static") == null and "add_body" in scene.last_error(), scene.last_error())
	expect(scene.add_body() == null, "no arguments")
	expect(scene.step(1) == null, "an argument too many")
	expect(scene.add_body(model, "static") != 0 and scene.step(), "it goes on")


func test_a_model_goes_with_the_scene_that_loaded_it():
	var first = PalpateScene.new()
	first.create({"cutoff": 0.01})
	var model = first.load_model(model_path("box.glb"))
	var second = PalpateScene.new()
	second.create({"cutoff": 0.01})
	expect(second.add_body(model, "static") != 0, "a model of another scene")
	first = null
	expect(second.add_body(model, "tool") == 0, "the number went with its scene")
	expect(second.step(), "the body keeps the model")
