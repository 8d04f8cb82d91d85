//! The bubble in a window.

use crate::bubble::SurfaceUniforms;
use crate::gpu::{Bubble, Gpu};
use std::error::Error;
use std::sync::Arc;
use winit::application::ApplicationHandler;
use winit::dpi::PhysicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};

/// How many pixels a side of the window has.
const SIZE: u32 = 768;

/// Shows the bubble until the window is closed.
pub fn show(uniforms: SurfaceUniforms) -> Result<(), Box<dyn Error>> {
    let mut viewer = Viewer { uniforms, shown: None, failure: None };
    EventLoop::new()?.run_app(&mut viewer)?;
    viewer.failure.map_or(Ok(()), Err)
}

struct Viewer {
    uniforms: SurfaceUniforms,
    shown: Option<Shown>,
    failure: Option<Box<dyn Error>>,
}

struct Shown {
    window: Arc<Window>,
    surface: wgpu::Surface<'static>,
    configuration: wgpu::SurfaceConfiguration,
    gpu: Gpu,
    bubble: Bubble,
}

impl Shown {
    fn new(event_loop: &ActiveEventLoop, uniforms: &SurfaceUniforms) -> Result<Self, Box<dyn Error>> {
        let size = PhysicalSize::new(SIZE, SIZE);
        let attributes = Window::default_attributes().with_title("soap bubble").with_inner_size(size);
        let window = Arc::new(event_loop.create_window(attributes.with_resizable(false))?);
        let display = Box::new(event_loop.owned_display_handle());
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle_from_env(display));
        let surface = instance.create_surface(window.clone())?;
        let gpu = Gpu::new(&instance, Some(&surface))?;
        let mut configuration =
            surface.get_default_config(&gpu.adapter, SIZE, SIZE).ok_or("the device cannot draw to the window")?;
        // The shader gives linear colours: the target encodes them.
        let formats = surface.get_capabilities(&gpu.adapter).formats;
        configuration.format = formats.into_iter().find(|format| format.is_srgb()).ok_or("no target encodes sRGB")?;
        surface.configure(&gpu.device, &configuration);
        let bubble = Bubble::new(&gpu, configuration.format, SIZE, uniforms);
        Ok(Self { window, surface, configuration, gpu, bubble })
    }

    fn draw(&self) {
        use wgpu::CurrentSurfaceTexture::{Outdated, Suboptimal, Success};
        match self.surface.get_current_texture() {
            Success(target) | Suboptimal(target) => {
                let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
                self.bubble.draw(&mut encoder, &target.texture.create_view(&Default::default()));
                self.gpu.queue.submit([encoder.finish()]);
                self.window.pre_present_notify();
                self.gpu.queue.present(target);
            }
            Outdated => {
                self.surface.configure(&self.gpu.device, &self.configuration);
                self.window.request_redraw();
            }
            // Nothing can be drawn now: the window asks again when it is to be seen.
            _ => {}
        }
    }
}

impl ApplicationHandler for Viewer {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        match Shown::new(event_loop, &self.uniforms) {
            Ok(shown) => {
                shown.window.request_redraw();
                self.shown = Some(shown);
            }
            Err(error) => {
                self.failure = Some(error);
                event_loop.exit();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                if let Some(shown) = &self.shown {
                    shown.draw();
                }
            }
            _ => {}
        }
    }
}
