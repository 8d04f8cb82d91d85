# Evaluates the include at the points of a file, draws a sphere with it, and gives both to the page.
extends Node

const POINTS_AT_MOST := 64


func _ready() -> void:
	var numbers := FileAccess.get_file_as_string("res://points.txt").split_floats(" ", false)
	var values := drawn(evaluation(numbers), Vector2i(POINTS_AT_MOST, 3))
	var picture := drawn(sphere(), Vector2i(256, 256))
	# What is drawn in a frame is there after the next.
	for frame in 4:
		await RenderingServer.frame_post_draw
	var result := {
		"version": Engine.get_version_info()["string"],
		"values": Marshalls.raw_to_base64(image(values).get_data()),
		"picture": Marshalls.raw_to_base64(image(picture).save_png_to_buffer()),
	}
	JavaScriptBridge.eval("window.finished(%s)" % JSON.stringify(result), true)


func drawn(content: Node, size: Vector2i) -> SubViewport:
	var viewport := SubViewport.new()
	viewport.size = size
	viewport.transparent_bg = true
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	viewport.add_child(content)
	add_child(viewport)
	return viewport


func image(viewport: SubViewport) -> Image:
	var found := viewport.get_texture().get_image()
	found.convert(Image.FORMAT_RGBA8)
	return found


# A column for each point, a row for each channel: the bytes of a float as a colour.
func evaluation(numbers: PackedFloat64Array) -> Node:
	var given := PackedVector4Array()
	for index in range(0, numbers.size(), 4):
		given.append(Vector4(numbers[index], numbers[index + 1], numbers[index + 2], numbers[index + 3]))
	var rectangle := ColorRect.new()
	rectangle.size = Vector2(POINTS_AT_MOST, 3)
	rectangle.material = material("res://points.gdshader")
	rectangle.material.set_shader_parameter("given", given)
	return rectangle


func sphere() -> Node:
	var world := Node3D.new()
	var camera := Camera3D.new()
	camera.position = Vector3(0, 0, 2)
	camera.fov = 40
	world.add_child(camera)
	world.add_child(DirectionalLight3D.new())
	var body := MeshInstance3D.new()
	body.mesh = SphereMesh.new()
	body.material_override = material("res://sphere.gdshader")
	world.add_child(body)
	return world


func material(path: String) -> ShaderMaterial:
	var made := ShaderMaterial.new()
	made.shader = load(path)
	return made
