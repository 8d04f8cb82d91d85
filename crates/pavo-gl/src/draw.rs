//! Draws one pixel a point.

use crate::{GlDevice, GlError, NUMBERS_PER_TEXEL, POINTS_PER_ROW};
use glow::HasContext;

/// One triangle over the whole target.
const VERTEX: &str = "
void main() {
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
";

impl GlDevice {
    /// Compiles and links a fragment shader and evaluates it at points.
    ///
    /// The shader begins with its `#version` and reads point `i` from the texture `inputs`, whose texels have four
    /// floats: that of pixel (x, y) lies in row y, from texel x times `ceil(components / 4)` on. It writes a colour to
    /// location 0, of which three numbers are given back. Each point has `components` numbers.
    ///
    /// # Errors
    /// [`GlError::Refused`] with the log of the driver's compiler, [`GlError::Points`] where a point has another number
    /// of components, [`GlError::Failed`] where OpenGL fails.
    pub fn evaluate(&self, fragment: &str, points: &[Vec<f32>], components: usize) -> Result<Vec<[f32; 3]>, GlError> {
        if let Some((index, point)) = points.iter().enumerate().find(|(_, point)| point.len() != components) {
            return Err(GlError::Points { index, found: point.len(), expected: components });
        }
        if points.is_empty() {
            return Ok(Vec::new());
        }
        self.make_current()?;
        let texels = components.div_ceil(NUMBERS_PER_TEXEL).max(1);
        let rows = points.len().div_ceil(POINTS_PER_ROW);
        let mut inputs = vec![0.0_f32; rows * POINTS_PER_ROW * texels * NUMBERS_PER_TEXEL];
        for (place, point) in inputs.chunks_exact_mut(texels * NUMBERS_PER_TEXEL).zip(points) {
            place[..components].copy_from_slice(point);
        }
        let [width, input_width, height] =
            [POINTS_PER_ROW, POINTS_PER_ROW * texels, rows].map(|size| i32::try_from(size).unwrap_or(i32::MAX));
        let version = fragment.lines().next().unwrap_or_default();
        let gl = &self.gl;
        // SAFETY: the context is current; sizes and formats are those of the buffers that OpenGL reads and writes.
        let pixels = unsafe {
            let program = gl.create_program().map_err(|reason| self.failed("make a program", reason))?;
            let shaders = [
                self.compile(glow::VERTEX_SHADER, "vertex", &format!("{version}{VERTEX}"))?,
                self.compile(glow::FRAGMENT_SHADER, "fragment", fragment)?,
            ];
            for shader in shaders {
                gl.attach_shader(program, shader);
            }
            gl.link_program(program);
            if !gl.get_program_link_status(program) {
                return Err(self.refused("linked", gl.get_program_info_log(program)));
            }
            gl.use_program(Some(program));
            gl.uniform_1_i32(gl.get_uniform_location(program, "inputs").as_ref(), 0);

            gl.active_texture(glow::TEXTURE0);
            let source = self.texture(input_width, height, Some(bytes(&inputs)))?;
            let target = self.texture(width, height, None)?;
            let framebuffer = gl.create_framebuffer().map_err(|reason| self.failed("make a target", reason))?;
            gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
            gl.framebuffer_texture_2d(glow::FRAMEBUFFER, glow::COLOR_ATTACHMENT0, glow::TEXTURE_2D, Some(target), 0);
            let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
            if status != glow::FRAMEBUFFER_COMPLETE {
                return Err(self.failed("draw to 32-bit floats", format!("status {status:#x}")));
            }
            gl.bind_texture(glow::TEXTURE_2D, Some(source));
            let array = gl.create_vertex_array().map_err(|reason| self.failed("make a vertex array", reason))?;
            gl.bind_vertex_array(Some(array));
            gl.viewport(0, 0, width, height);
            gl.draw_arrays(glow::TRIANGLES, 0, 3);
            let mut pixels = vec![0_u8; rows * POINTS_PER_ROW * NUMBERS_PER_TEXEL * size_of::<f32>()];
            let destination = glow::PixelPackData::Slice(Some(&mut pixels));
            gl.read_pixels(0, 0, width, height, glow::RGBA, glow::FLOAT, destination);
            let error = gl.get_error();

            gl.delete_vertex_array(array);
            gl.delete_framebuffer(framebuffer);
            gl.delete_texture(source);
            gl.delete_texture(target);
            for shader in shaders {
                gl.delete_shader(shader);
            }
            gl.delete_program(program);
            if error != glow::NO_ERROR {
                return Err(self.failed("draw", format!("error {error:#x}")));
            }
            pixels
        };
        let (numbers, _) = pixels.as_chunks::<4>();
        let numbers: Vec<f32> = numbers.iter().map(|bytes| f32::from_ne_bytes(*bytes)).collect();
        let colors = numbers.chunks_exact(NUMBERS_PER_TEXEL).map(|color| [color[0], color[1], color[2]]);
        Ok(colors.take(points.len()).collect())
    }

    /// # Safety
    /// The context is current.
    unsafe fn compile(&self, kind: u32, stage: &'static str, text: &str) -> Result<glow::Shader, GlError> {
        // SAFETY: as the caller has it.
        unsafe {
            let shader = self.gl.create_shader(kind).map_err(|reason| self.failed("make a shader", reason))?;
            self.gl.shader_source(shader, text);
            self.gl.compile_shader(shader);
            if self.gl.get_shader_compile_status(shader) {
                return Ok(shader);
            }
            Err(self.refused(stage, self.gl.get_shader_info_log(shader)))
        }
    }

    /// A texture of 32-bit floats, four a texel, read as it is.
    ///
    /// # Safety
    /// The context is current, and the numbers fill the texture.
    unsafe fn texture(&self, width: i32, height: i32, numbers: Option<&[u8]>) -> Result<glow::Texture, GlError> {
        let gl = &self.gl;
        // SAFETY: as the caller has it.
        unsafe {
            let texture = gl.create_texture().map_err(|reason| self.failed("make a texture", reason))?;
            gl.bind_texture(glow::TEXTURE_2D, Some(texture));
            let nearest = i32::try_from(glow::NEAREST).unwrap_or_default();
            for filter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
                gl.tex_parameter_i32(glow::TEXTURE_2D, filter, nearest);
            }
            let format = i32::try_from(glow::RGBA32F).unwrap_or_default();
            let data = glow::PixelUnpackData::Slice(numbers);
            gl.tex_image_2d(glow::TEXTURE_2D, 0, format, width, height, 0, glow::RGBA, glow::FLOAT, data);
            Ok(texture)
        }
    }

    fn refused(&self, stage: &'static str, log: String) -> GlError {
        GlError::Refused { stage, device: self.description.clone(), log }
    }

    fn failed(&self, what: &'static str, reason: String) -> GlError {
        GlError::Failed { device: self.description.clone(), what, reason }
    }
}

/// The numbers as the bytes that OpenGL takes.
fn bytes(numbers: &[f32]) -> &[u8] {
    // SAFETY: any f32 is four valid bytes, and bytes need no alignment.
    unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast(), size_of_val(numbers)) }
}
