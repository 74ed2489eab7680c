//! `sightline render`: draws a picture without a window.

use super::{
    CliError, SceneArgs, ViewArgs, build_trees, check_memory, load, load_beside_gpu, pick::inside,
    value,
};
use crate::{
    camera::View,
    image::{Id, Image, ImageError, Picture, Rgb},
    look::{Backdrop, Background},
    pick,
    render::{self, Gpu, GpuError},
    replace::target,
    scene::Scene,
    viewer::{self, model::Views},
};
use glam::DVec2;
use std::{path::PathBuf, time::Instant};

/// Arguments of `sightline render`.
#[derive(Debug, clap::Args)]
pub struct RenderArgs {
    /// What to draw.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The PNG file to write; - writes it to standard output
    #[arg(short, long, value_name = "FILE.png", value_parser = value::png_or_stdout())]
    pub output: PathBuf,
    /// What draws: the graphics adapter, or rays on the CPU [default: the adapter; rays where none draws]
    #[arg(long, value_enum)]
    pub by: Option<By>,
    /// Draw the object at this position as selected
    #[arg(long, value_name = "X,Y", value_parser = value::point, allow_hyphen_values = true)]
    pub pick: Option<DVec2>,
    /// Also write object ids, as 16-bit grey: 0 for the background, n for the object with id n
    #[arg(long, value_name = "FILE.png", value_parser = value::png_or_stdout())]
    pub ids: Option<PathBuf>,
    /// Draw the four views side by side, or one of them, as the window does, with a graphics adapter [default: picture]
    #[arg(long, value_name = "VIEWS", value_parser = value::word(value::VIEWS), conflicts_with_all = ["ids", "by"])]
    pub views: Option<Views>,
    /// What is behind the scene
    #[arg(long, value_name = "BACKGROUND", value_parser = value::word(Backdrop::NAMED), default_value = "dark")]
    pub background: Backdrop,
    /// How to look at it.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// What draws the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum By {
    /// The graphics adapter.
    Raster,
    /// One ray per pixel, on the CPU.
    Raycast,
}

/// Draws and writes the picture.
pub(super) fn run(args: &RenderArgs) -> Result<(), CliError> {
    if let Some(px) = args.pick {
        inside(args.view.size(), px)?;
    }
    let output = target(&args.output);
    if args.ids.as_ref().is_some_and(|ids| target(ids) == output) {
        return Err(CliError::usage(
            "--output and --ids name one file, which cannot hold both",
        ));
    }
    let views = args.views.filter(|views| *views != Views::Picture);
    let needs_ids = args.ids.is_some() || args.pick.is_some();
    let (mut loaded, gpu) = if args.by == Some(By::Raycast) || views.is_some() {
        (load(&args.scene)?, None)
    } else {
        let open = if needs_ids {
            Gpu::headless
        } else {
            Gpu::headless_for_colours
        };
        let (loaded, gpu) = load_beside_gpu(&args.scene, open)?;
        (loaded, Some(gpu))
    };
    let view = args.view.apply(&mut loaded)?;
    // The warnings were printed already.
    loaded.warnings.clear();
    if let Some(views) = views {
        let options = viewer::Options {
            paths: args.scene.scenes.clone(),
            camera: args.view.choice(),
            sides: args.view.sides(),
            visibility: args.view.visibility(),
            views,
            ..viewer::Options::default()
        };
        let size = args.view.size();
        let picture = viewer::picture_of_views(loaded, options, size, args.pick, args.background);
        let picture = picture.map_err(|error| {
            CliError::new(4, format!("{error}; without `--views`, rays can draw"))
        })?;
        return Ok(picture.write_png(&args.output)?);
    }
    let scene = &loaded.scene;
    if args.ids.is_some() {
        let last = u32::try_from(scene.objects().len()).unwrap_or(u32::MAX);
        u16::try_from(last).map_err(|_| ImageError::TooManyObjects(last))?;
    }
    let at = args.pick.map(|px| view.ray(px));
    let selection = at.and_then(|ray| pick::closest(scene, ray, view.sides));
    let selection = selection.map(|hit| hit.object);
    let start = Instant::now();
    let rays_draw = |error: GpuError| {
        if args.by.is_some() {
            return Err(without(&error));
        }
        log::warn!("drawn by rays on the CPU: {error}");
        Ok(())
    };
    let mut adapter = match gpu {
        Some(Ok(gpu)) => Some(gpu),
        Some(Err(error)) => rays_draw(error).map(|()| None)?,
        None => None,
    };
    let mut ids = None;
    let picture = Picture::on(args.background, |background| {
        if let Some(gpu) = &adapter {
            match raster(gpu, scene, &view, selection, args.ids.is_some(), background) {
                Ok((drawn, colours)) => {
                    ids = drawn;
                    return Ok(colours);
                }
                Err(
                    error @ (GpuError::PictureTooLarge { .. } | GpuError::SceneTooLarge { .. }),
                ) => rays_draw(error)?,
                Err(error) => return Err(without(&error)),
            }
            adapter = None;
        }
        check_memory(view.viewport, pick::RAYCAST_BYTES)?;
        let (picked, colours) = raycast(scene, &view, selection, background);
        ids = Some(picked);
        Ok(colours)
    })?;
    log::info!("drew the picture in {:.1?}", start.elapsed());
    // Neither file is replaced unless both can be written.
    let ids = match (&args.ids, ids) {
        (Some(path), Some(ids)) => Some((path, ids.write_png_beside(path)?)),
        _ => None,
    };
    picture.write_png(&args.output)?;
    ids.map_or(Ok(()), |(path, ids)| {
        let placed = ids.put_in_place();
        placed.map_err(|error| CliError::file(path, &error))
    })
}

/// The picture, and the ids where they are wanted or tell what is selected.
fn raster(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    selection: Option<usize>,
    wants_ids: bool,
    background: Background,
) -> Result<(Option<Image<Id>>, Image<Rgb>), GpuError> {
    log::info!("drawing with {}", gpu.adapter_name());
    if wants_ids || selection.is_some() {
        let drawn = render::render(gpu, scene, view, selection, background);
        drawn.map(|(ids, colours)| (Some(ids), colours))
    } else {
        render::picture(gpu, scene, view, background).map(|colours| (None, colours))
    }
}

/// The error of an adapter, with what draws without one.
fn without(error: &GpuError) -> CliError {
    CliError::new(4, format!("{error}; `--by raycast` needs no adapter"))
}

fn raycast(
    scene: &Scene,
    view: &View,
    selection: Option<usize>,
    background: Background,
) -> (Image<Id>, Image<Rgb>) {
    build_trees(scene);
    let (ids, mut colours) = pick::raycast(scene, view, background);
    if let Some(object) = selection {
        pick::mark(object, &ids, &mut colours, background);
    }
    (ids, colours)
}
