//! A sphere under a soap film in Bevy, drawn without a window into `film.png`, or into the file that is named.

use bevy::app::ScheduleRunnerPlugin;
use bevy::camera::RenderTarget;
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_resource::{AsBindGroup, TextureFormat, TextureUsages};
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use bevy::shader::{Shader, ShaderRef};
use bevy::window::ExitCondition;
use std::time::Duration;

/// The functions of the film, as the module `pavo::thin_film`.
const FILM: &str = include_str!(concat!(env!("OUT_DIR"), "/film.wgsl"));
const SIZE: u32 = 512;
/// How many frames are drawn before the picture is taken: pipelines are compiled meanwhile.
const FRAMES_BEFORE: u32 = 60;
/// After so many frames without a picture something is wrong.
const FRAMES_AT_MOST: u32 = 3_000;

fn main() -> AppExit {
    let without_window = WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() };
    App::new()
        .insert_resource(ClearColor(Color::BLACK))
        .add_plugins(DefaultPlugins.set(without_window))
        .add_plugins(ScheduleRunnerPlugin::run_loop(Duration::from_millis(10)))
        .add_plugins(MaterialPlugin::<FilmMaterial>::default())
        .add_systems(Startup, set_up)
        .add_systems(Update, take_picture)
        .run()
}

/// A thin film over the mesh.
#[derive(Asset, TypePath, AsBindGroup, Debug, Clone)]
struct FilmMaterial {
    /// The thinnest and the thickest film, in nanometres; the rest is unused.
    #[uniform(0)]
    thickness_range_nm: Vec4,
}

impl Material for FilmMaterial {
    fn fragment_shader() -> ShaderRef {
        "film.wgsl".into()
    }
}

/// What is drawn to, and the module that the material imports: it goes when nothing holds it.
#[derive(Resource)]
struct Held {
    target: Handle<Image>,
    _film: Handle<Shader>,
}

fn set_up(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<FilmMaterial>>,
    mut images: ResMut<Assets<Image>>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let film = shaders.add(Shader::from_wgsl(FILM, "film"));
    let mut target = Image::new_target_texture(SIZE, SIZE, TextureFormat::Rgba8UnormSrgb, None);
    target.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    let target = images.add(target);
    commands.spawn((
        Mesh3d(meshes.add(Sphere::new(1.0).mesh().uv(128, 64))),
        MeshMaterial3d(materials.add(FilmMaterial { thickness_range_nm: Vec4::new(50.0, 900.0, 0.0, 0.0) })),
    ));
    commands.spawn((
        Camera3d::default(),
        RenderTarget::Image(target.clone().into()),
        Tonemapping::None,
        Transform::from_xyz(0.0, 0.0, 3.0).looking_at(Vec3::ZERO, Vec3::Y),
    ));
    commands.insert_resource(Held { target, _film: film });
}

fn take_picture(mut commands: Commands, held: Res<Held>, mut frame: Local<u32>, mut exit: MessageWriter<AppExit>) {
    *frame += 1;
    if *frame == FRAMES_BEFORE {
        let path = std::env::args().nth(1).unwrap_or_else(|| "film.png".to_owned());
        commands.spawn(Screenshot::image(held.target.clone())).observe(save_to_disk(path.clone())).observe(
            move |captured: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
                // A material that was not drawn leaves the picture black.
                let pixels = captured.image.data.as_deref().unwrap_or_default();
                let is_drawn = pixels.chunks_exact(4).filter(|pixel| pixel[..3] != [0; 3]).count() > pixels.len() / 16;
                println!("{path}: {}", if is_drawn { "drawn" } else { "EMPTY: the film was not drawn" });
                exit.write(if is_drawn { AppExit::Success } else { AppExit::error() });
            },
        );
    }
    if *frame > FRAMES_AT_MOST {
        eprintln!("error: no picture after {FRAMES_AT_MOST} frames");
        exit.write(AppExit::error());
    }
}
