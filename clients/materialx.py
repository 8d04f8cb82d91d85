"""Has MaterialX generate and render the node of an export, and compares it with the CPU evaluation.

Usage: xvfb-run python clients/materialx.py --pavo PAVO --folder DIR [--json]
Exit codes are those of the command pavo.
"""

import pathlib
import shutil
import subprocess
import sys

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl as gen_glsl
from MaterialX import PyMaterialXGenShader as gen_shader
from MaterialX import PyMaterialXRender as render
from MaterialX import PyMaterialXRenderGlsl as render_glsl

import vectors

# The inputs of the node, for the parameters of the function.
INPUTS = {"CosTheta": "cos_theta", "ThicknessNm": "thickness_nm", "FilmIor": "film_ior", "BaseColor": "base_color"}
SIZE = 4


def document(library):
    """An unlit surface of the node's colour: the document, the node, and the surface."""
    made = mx.createDocument()
    made.setDataLibrary(library)
    node = made.addNode("pavo_thin_film", "film", "color3")
    surface = made.addNode("surface_unlit", "unlit", "surfaceshader")
    surface.addInput("emission_color", "color3").setConnectedNode(node)
    material = made.addMaterialNode("material", surface)
    return made, node, material


def generated(generator, made, material, search):
    """The shader of a material, its colour linear."""
    writer = generator.create()
    writer.registerTypeDefs(made)
    context = gen_shader.GenContext(writer)
    context.registerSourceCodeSearchPath(search)
    context.getOptions().hwSrgbEncodeOutput = False
    return writer.generate("film", material, context)


def compiled(glslang, shader, name, folder, options):
    """Has glslang compile both stages of a shader, which are left in the folder."""
    for stage, suffix in [(gen_shader.VERTEX_STAGE, "vert"), (gen_shader.PIXEL_STAGE, "frag")]:
        source = pathlib.Path(folder) / f"{name}.{suffix}"
        source.write_text(shader.getSourceCode(stage))
        ended = subprocess.run([glslang, "-S", suffix, *options, str(source)], capture_output=True, text=True)
        if ended.returncode != 0:
            raise SystemExit(f"glslang refuses {source}:\n{ended.stdout}{ended.stderr}")


def main():
    given = vectors.arguments()
    glslang = shutil.which("glslangValidator") or shutil.which("glslang")
    if glslang is None:
        print("error: glslang is not here; `cargo xtask setup` brings it. Nothing was rendered", file=sys.stderr)
        raise SystemExit(3)
    folder = vectors.exported(given, "materialx")
    search = mx.getDefaultDataSearchPath()
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, library)
    mx.readFromXmlFile(library, str(folder / "pavo_thin_film.mtlx"))
    search.append(mx.FilePath(str(folder)))

    # Each generator that takes GLSL has to find the node, and glslang has to take what it writes.
    vulkan = ["-V", "-o", str(given.folder / "materialx.spv")]
    generators = [
        (gen_glsl.EsslShaderGenerator, "essl", []),
        (gen_glsl.VkShaderGenerator, "vulkan", vulkan),
        (gen_glsl.GlslShaderGenerator, "glsl", []),
    ]
    made, node, material = document(library)
    for generator, name, options in generators:
        shader = generated(generator, made, material, search)
        text = shader.getSourceCode(gen_shader.PIXEL_STAGE)
        if "pavo_thin_film(" not in text:
            raise SystemExit(f"the shader of {generator.__name__} does not call the node")
        compiled(glslang, shader, f"materialx-{name}", given.folder, options)

    renderer = render_glsl.GlslRenderer.create(SIZE, SIZE, render.BaseType.FLOAT)
    renderer.initialize()
    renderer.setImageHandler(render.ImageHandler.create(render.StbImageLoader.create()))
    found, expected = [], []
    for values, color in vectors.vectors(folder):
        made, node, material = document(library)
        for name, numbers in values.items():
            # As text: a value would be cut to six digits.
            value = node.addInput(INPUTS[name], "color3" if len(numbers) == 3 else "float")
            value.setValueString(", ".join(repr(number) for number in numbers))
        renderer.createProgram(generated(gen_glsl.GlslShaderGenerator, made, material, search))
        renderer.renderTextureSpace(mx.Vector2(0.0, 0.0), mx.Vector2(1.0, 1.0))
        texel = renderer.captureImage(None).getTexelColor(SIZE // 2, SIZE // 2)
        found.append([texel[channel] for channel in range(3)])
        expected.append(color)
    vectors.report(given, "materialx", mx.getVersionString(), "GlslRenderer", found, expected)


main()
