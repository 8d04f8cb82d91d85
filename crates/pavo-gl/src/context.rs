//! A context of OpenGL without a surface.

use crate::GlError;
use glow::HasContext;
use khronos_egl as egl;

/// `EGL_PLATFORM_SURFACELESS_MESA`, of the extension `EGL_MESA_platform_surfaceless`.
const PLATFORM_SURFACELESS: egl::Enum = 0x31DD;

/// `EGL_CONTEXT_OPENGL_PROFILE_MASK` of EGL 1.5 with its bit for the core profile, and the version of a context.
const CORE_PROFILE: [egl::Int; 2] = [0x30FD, 1];
const MAJOR_VERSION: egl::Int = 0x3098;
const MINOR_VERSION: egl::Int = 0x30FB;

type Egl = egl::DynamicInstance<egl::EGL1_5>;

/// Which OpenGL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Api {
    /// OpenGL 3.3 core: it reads `#version 330 core`.
    OpenGl33,
    /// OpenGL ES 3.0: it reads `#version 300 es`.
    OpenGlEs30,
}

/// A driver of OpenGL that draws without a window. It belongs to the thread that opened it.
pub struct GlDevice {
    pub(crate) gl: glow::Context,
    pub(crate) description: String,
    egl: Egl,
    display: egl::Display,
    context: egl::Context,
}

impl GlDevice {
    /// Opens the first driver that needs no display.
    ///
    /// # Errors
    /// [`GlError::Missing`] where libEGL or a driver is not installed, [`GlError::NoFloatTarget`] where the driver
    /// cannot draw to 32-bit floats.
    pub fn open(api: Api) -> Result<Self, GlError> {
        // SAFETY: libEGL is the system's own; loading it runs its initialisers and nothing else.
        let egl = unsafe { Egl::load_required() }.map_err(|error| missing("libEGL", &error))?;
        // SAFETY: the platform takes no native display, and the list of attributes is empty and ended.
        let display =
            unsafe { egl.get_platform_display(PLATFORM_SURFACELESS, egl::DEFAULT_DISPLAY, &[egl::ATTRIB_NONE]) }
                .map_err(|error| missing("EGL without a display", &error))?;
        egl.initialize(display).map_err(|error| missing("EGL's driver", &error))?;
        let (interface, renderable, version) = match api {
            Api::OpenGl33 => (egl::OPENGL_API, egl::OPENGL_BIT, [3, 3]),
            Api::OpenGlEs30 => (egl::OPENGL_ES_API, egl::OPENGL_ES3_BIT, [3, 0]),
        };
        let driver = |error: egl::Error| missing("a driver of OpenGL 3.3 and ES 3.0", &error);
        egl.bind_api(interface).map_err(driver)?;
        let wanted = [egl::SURFACE_TYPE, 0, egl::RENDERABLE_TYPE, renderable, egl::NONE];
        let config = egl.choose_first_config(display, &wanted).map_err(driver)?;
        let config = config.ok_or_else(|| driver(egl::Error::BadConfig))?;
        let mut attributes = vec![MAJOR_VERSION, version[0], MINOR_VERSION, version[1]];
        if api == Api::OpenGl33 {
            attributes.extend(CORE_PROFILE);
        }
        attributes.push(egl::NONE);
        let context = egl.create_context(display, config, None, &attributes).map_err(driver)?;
        egl.make_current(display, None, None, Some(context)).map_err(driver)?;
        // SAFETY: the context is current, and EGL gives the addresses of its own functions.
        let (gl, description) = unsafe {
            let gl = glow::Context::from_loader_function(|name| {
                egl.get_proc_address(name).map_or(std::ptr::null(), |function| function as *const _)
            });
            let description =
                format!("{}, {}", gl.get_parameter_string(glow::RENDERER), gl.get_parameter_string(glow::VERSION));
            (gl, description)
        };
        let draws_floats = api == Api::OpenGl33 || gl.supported_extensions().contains("GL_EXT_color_buffer_float");
        let device = Self { gl, description, egl, display, context };
        if draws_floats { Ok(device) } else { Err(GlError::NoFloatTarget { device: device.description.clone() }) }
    }

    /// The driver and its version, as it names itself.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// Makes the context the one that OpenGL's functions speak to: another device may have been opened since.
    pub(crate) fn make_current(&self) -> Result<(), GlError> {
        self.egl.make_current(self.display, None, None, Some(self.context)).map_err(|error| GlError::Failed {
            device: self.description.clone(),
            what: "become current",
            reason: error.to_string(),
        })
    }
}

impl Drop for GlDevice {
    fn drop(&mut self) {
        // What cannot be released at the end is released with the process.
        let _ = self.egl.make_current(self.display, None, None, None);
        let _ = self.egl.destroy_context(self.display, self.context);
    }
}

fn missing(what: &'static str, reason: &dyn std::fmt::Display) -> GlError {
    GlError::Missing { what, reason: reason.to_string() }
}
