"""Has Blender's oslc compile the shader of an export and Cycles render it, and compares it with the CPU evaluation.

Usage: python clients/blender.py --pavo PAVO --folder DIR [--json]
Each test vector is a plane of its own before an orthographic camera, in whose material a Script node gives the colour
of an emission. Exit codes are those of the command pavo.
"""

import math
import sys

import bpy
import numpy

import _cycles  # It is there once bpy is loaded.
import vectors

# Pixels along a side of a plane: the one in its middle is read.
PIXELS = 8


def material(name, bytecode, values):
    """A material that emits what the shader computes of these values."""
    made = bpy.data.materials.new(name)
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    script = nodes.new("ShaderNodeScript")
    script.mode = "EXTERNAL"
    script.bytecode = bytecode
    script.bytecode_hash = "1"
    for parameter, numbers in values.items():
        kind = "NodeSocketColor" if len(numbers) == 3 else "NodeSocketFloat"
        socket = script.inputs.new(kind, parameter, identifier=parameter)
        socket.default_value = (*numbers, 1.0) if len(numbers) == 3 else numbers[0]
    script.outputs.new("NodeSocketColor", "Reflectance", identifier="Reflectance")
    emission = nodes.new("ShaderNodeEmission")
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(script.outputs["Reflectance"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return made


def settings(scene, columns, rows, picture):
    """One sample a pixel, through the pixel's middle as nearly as Cycles has it, written as linear floats."""
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.shading_system = True
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x, scene.render.resolution_y = columns * PIXELS, rows * PIXELS
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Raw"
    scene.render.filepath = str(picture)


def main():
    given = vectors.arguments()
    folder = vectors.exported(given, "blender")
    compiled = folder / "pavo_thin_film.oso"
    if not _cycles.osl_compile(str(folder / "pavo_thin_film.osl"), str(compiled)):
        sys.exit("oslc refuses pavo_thin_film.osl")
    bytecode = compiled.read_text()

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    points = vectors.vectors(folder)
    columns = math.ceil(math.sqrt(len(points)))
    rows = math.ceil(len(points) / columns)
    for index, (values, _) in enumerate(points):
        bpy.ops.mesh.primitive_plane_add(size=1.0, location=(index % columns + 0.5, index // columns + 0.5, 0.0))
        bpy.context.object.data.materials.append(material(f"point {index}", bytecode, values))
    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.ortho_scale = max(columns, rows)
    placed = bpy.data.objects.new("camera", camera)
    placed.location = (columns / 2.0, rows / 2.0, 5.0)
    scene.collection.objects.link(placed)
    scene.camera = placed
    picture = given.folder / "blender.exr"
    settings(scene, columns, rows, picture)
    bpy.ops.render.render(write_still=True)

    image = bpy.data.images.load(str(picture))
    image.colorspace_settings.name = "Non-Color"
    texels = numpy.empty(columns * rows * PIXELS * PIXELS * 4, dtype=numpy.float32)
    image.pixels.foreach_get(texels)
    texels = texels.reshape(rows * PIXELS, columns * PIXELS, 4)
    middle = PIXELS // 2
    found = [
        [float(number) for number in texels[index // columns * PIXELS + middle, index % columns * PIXELS + middle, :3]]
        for index in range(len(points))
    ]
    vectors.report(given, "blender", bpy.app.version_string, "Cycles on the CPU", found, [color for _, color in points])


main()
