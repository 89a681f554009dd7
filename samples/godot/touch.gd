# A hand leads a gear along a crankshaft. A spring ties the gear to the hand; where the gear comes near the crankshaft,
# the forces of Palpate hold it off, so that it slides over the webs instead of going through.
#
#   --models=FOLDER   of crankshaft_45k.glb and gear_6k.glb (res://models)
#   --frames=N        ends after so many, each told on a line of its own
#   --screenshot=FILE saves the last one
extends Spatial

const GlbMesh = preload("res://glb_mesh.gd")

const CUTOFF = 0.004  # m
const STIFFNESS = 2000.0  # N/m of a contact
const HAND = 60.0  # N/m between hand and gear
const DRAG = 15.0  # N·s/m: how slowly the gear gives way
const STEPS = 16  # of Palpate in a frame
const REACH = 0.12  # m, of the hand to both sides
const HEIGHT = 0.085  # m: so low that the gear would go through the crankshaft
const METRES_PER_NEWTON = 0.03  # of the arrow

var scene
var tool_body
var at = Vector3(-REACH, 0.13, 0)
var seconds = 0.0
var frame = 0
var arguments = {"models": "res://models"}


func _ready():
	for argument in OS.get_cmdline_args():
		if argument.begins_with("--") and "=" in argument:
			var parts = argument.substr(2).split("=", true, 1)
			arguments[parts[0]] = parts[1]
	var folder = ProjectSettings.globalize_path(arguments.models)
	var crankshaft = folder.plus_file("crankshaft_45k.glb")
	var gear = folder.plus_file("gear_6k.glb")
	scene = load("res://addons/palpate/scene.gdns").new()
	scene.create({"cutoff": CUTOFF, "stiffness": STIFFNESS})
	scene.add_body(scene.load_model(crankshaft), "static")
	tool_body = scene.add_body(scene.load_model(gear), "tool", Transform(Basis.IDENTITY, at))
	if tool_body == 0:
		get_tree().quit(1)
		return
	if OS.has_feature("Server"):
		return
	_draw($Body, crankshaft, Color(0.55, 0.6, 0.66))
	_draw($Tool, gear, Color(0.9, 0.6, 0.25))
	$Force.material_override = _material(Color(0.8, 0.05, 0.1))
	$Force.material_override.flags_unshaded = true
	$Force.material_override.flags_no_depth_test = true


func _physics_process(delta):
	if tool_body == 0:
		return
	for _i in range(STEPS):
		_step(delta / STEPS)
	$Tool.translation = at
	_draw_force()
	$Label.text = "%d contacts, %.2f N" % [scene.get_set_count(), scene.get_force().length()]
	frame += 1
	if "frames" in arguments:
		var force = scene.get_force()
		print("frame %d: x %.4f y %.4f, %d contacts, force %.3f %.3f %.3f, overlap %s" % [
			frame, at.x, at.y, scene.get_set_count(), force.x, force.y, force.z, scene.is_overlapping()])
		if frame == int(arguments.frames):
			_end()


# A massless gear in a viscous hand: its speed is what spring and contacts push with, over the drag.
func _step(delta):
	seconds += delta
	var hand = Vector3(-REACH * cos(seconds), HEIGHT, 0)
	at += (HAND * (hand - at) + scene.get_force()) * (delta / DRAG)
	scene.set_pose(tool_body, Transform(Basis.IDENTITY, at))
	scene.step()


func _draw(instance, path, colour):
	instance.mesh = GlbMesh.flat_mesh(GlbMesh.arrays_of(path))
	instance.material_override = _material(colour)


func _material(colour):
	var material = SpatialMaterial.new()
	material.albedo_color = colour
	return material


func _draw_force():
	var force = scene.get_force()
	$Force.clear()
	if force.length() == 0:
		return
	$Force.begin(Mesh.PRIMITIVE_LINES)
	$Force.add_vertex(at)
	$Force.add_vertex(at + METRES_PER_NEWTON * force)
	for contact in scene.get_contacts():
		$Force.add_vertex(contact.point_a)
		$Force.add_vertex(contact.point_b)
	$Force.end()


func _end():
	set_physics_process(false)
	if "screenshot" in arguments:
		yield(VisualServer, "frame_post_draw")
		var image = get_viewport().get_texture().get_data()
		image.flip_y()
		image.save_png(arguments.screenshot)
	get_tree().quit()
