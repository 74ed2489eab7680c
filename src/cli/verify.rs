//! `sightline verify`: compares the drawn picture with picks, pixel by pixel.

use super::{CliError, SceneArgs, ViewArgs, build_trees, check_memory, load_beside_gpu, value};
use crate::{
    camera::View,
    image::{Id, Image, Rgb},
    json,
    look::Background,
    pick, plain,
    render::{self, Gpu, GpuError, Rasteriser},
    scene::Scene,
    study::methods::usual,
    verify::{
        self, COLOURS, Class, Disagreement, IN_ONE_PLACE, OUTLINE_CEILING_PX, Places, Report,
        Verdict,
    },
};
use serde::Serialize;
use std::{
    fmt::Write as _,
    io::{ErrorKind, Write as _},
    path::PathBuf,
    time::Instant,
};

/// Arguments of `sightline verify`.
#[derive(Debug, clap::Args)]
pub struct VerifyArgs {
    /// What to look at.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Write the picture in grey; pixels that differ have a colour and a dark rim, pixels in one place a tint
    #[arg(long, value_name = "FILE.png", value_parser = value::png())]
    pub image: Option<PathBuf>,
    /// Print one line of JSON instead of the table
    #[arg(long)]
    pub json: bool,
    /// The method that picks: the program's own, or the usual one for comparison
    #[arg(long, value_enum, default_value_t = Picker::Exact)]
    pub picker: Picker,
    /// How to look at it.
    #[command(flatten)]
    pub view: ViewArgs,
}

/// The method that picks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Picker {
    /// The program's own picks, the same as on a click.
    Exact,
    /// In f32: rays from the inverse of Projection * View, tested by Moeller-Trumbore.
    Usual,
}

/// Bytes per pixel that picking and comparing take beside the drawn picture: the picked ids, the marks of pixels in one
/// place, and the picture for `--image`.
const CHECK_BYTES: usize = size_of::<Id>() + size_of::<bool>() + size_of::<Rgb>();

/// Draws, picks, compares and prints the report.
pub(super) fn run(args: &VerifyArgs) -> Result<(), CliError> {
    let (mut loaded, gpu) = load_beside_gpu(&args.scene, Gpu::headless)?;
    let view = args.view.apply(&mut loaded)?;
    let scene = &loaded.scene;
    let nothing_drawn = |error: GpuError| {
        let text =
            format!("{error}; `sightline pick` and `sightline render --by raycast` do without");
        CliError::new(4, text)
    };
    let gpu = gpu.map_err(nothing_drawn)?;
    let start = Instant::now();
    let (drawn, colours) =
        render::render(&gpu, scene, &view, None, Background::DARK).map_err(nothing_drawn)?;
    let drawn_s = start.elapsed().as_secs_f64();
    check_memory(view.viewport, CHECK_BYTES)?;
    build_trees(scene);
    let start = Instant::now();
    let picked = picked(args.picker, scene, &view);
    let picked_s = start.elapsed().as_secs_f64();
    let report = verify::compare(scene, &view, gpu.rasteriser(), &drawn, &picked);
    let in_one_place = Places::new(scene, &view, gpu.rasteriser()).pixels(|| false);
    if let Some(path) = &args.image {
        verify::paint(&colours, &in_one_place, &report.disagreements).write_png(path)?;
    }
    let outcome = Outcome {
        scene,
        report: &report,
        in_one_place: in_one_place.len(),
        size: [view.viewport.width(), view.viewport.height()],
        adapter: gpu.adapter_name(),
        rasteriser: gpu.rasteriser(),
        seconds: [drawn_s, picked_s],
    };
    let text = if args.json {
        outcome.json()?
    } else {
        outcome.text(args.image.is_some())
    };
    // The exit code says what was found, also when nobody reads on.
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => return Err(CliError::stdout(error)),
        _ => {}
    }
    let one_sided = |pixels: usize, there: &str, missing: &str| {
        format!(
            "{pixels} pixels are {there}, and nothing at all is {missing}; render --by raycast shows what is picked"
        )
    };
    let defect = match report.verdict() {
        Verdict::Agrees => return Ok(()),
        Verdict::BeyondF32(pixels) => format!(
            "f32 is too coarse to draw this view: {pixels} pixels differ from their picks; picks are right, and so is render --by raycast"
        ),
        Verdict::NothingDrawn(pixels) => one_sided(pixels, "picked", "drawn"),
        Verdict::NothingPicked(pixels) => one_sided(pixels, "drawn", "picked"),
        Verdict::Unexplained(pixels) => format!(
            "{pixels} pixels are drawn as one thing and picked as another, and no outline, depth or section explains why"
        ),
    };
    Err(CliError::new(1, defect))
}

fn picked(picker: Picker, scene: &Scene, view: &View) -> Image<Id> {
    match picker {
        Picker::Exact => pick::ids(scene, view),
        Picker::Usual => pick::ids_by(scene, view, |px| usual::closest(scene, view, px)),
    }
}

/// The report.
struct Outcome<'a> {
    scene: &'a Scene,
    report: &'a Report,
    /// The number of pixels whose nearest surfaces lie in one place.
    in_one_place: usize,
    size: [u32; 2],
    adapter: &'a str,
    rasteriser: Rasteriser,
    /// The time for drawing, and the time for picking.
    seconds: [f64; 2],
}

/// What the drawn or the picked side shows at a pixel. Ids count from 1 and triangles from 0, as in picks.
#[derive(Serialize)]
struct Answer<'a> {
    object: &'a str,
    id: u32,
    triangle: Option<u32>,
    /// View depth at the pixel's centre.
    depth: Option<f64>,
}

impl<'a> Outcome<'a> {
    fn answer(&self, id: Id, depth: f64) -> Option<Answer<'a>> {
        let index = (id.object as usize).checked_sub(1)?;
        let object = self.scene.objects().get(index);
        Some(Answer {
            object: object.map_or("", |object| &object.name),
            id: id.object,
            triangle: id.triangle.checked_sub(1),
            depth: finite(depth),
        })
    }

    /// The pixel hardest to explain.
    fn worst(&self, at: &Disagreement) -> impl Serialize {
        json::object! {
            pixel: at.pixel,
            class: at.class,
            drawn: self.answer(at.drawn, at.depth[0]),
            picked: self.answer(at.picked, at.depth[1]),
            // The distance from the pixel's centre to the outline that explains the difference, or comes closest to it.
            outline_px: finite(at.outline_px),
            // How far drawing may move that outline.
            outline_error_px: finite(at.outline_px).and(finite(at.outline_error_px)),
            // The distance that the explanation needs, divided by the distance allowed. The explanation holds up to 1.
            strain: finite(at.strain),
        }
    }

    fn json(&self) -> Result<String, CliError> {
        let report = self.report;
        let line = json::object! {
            size: self.size,
            pixels: report.pixels,
            drawn: report.drawn,
            picked: report.picked,
            outline: report.outline,
            outline_differ: report.outline_differ,
            same: report.same(),
            edge: report.count(Class::Edge),
            depth: report.count(Class::Depth),
            section: report.count(Class::Section),
            f32_limit: report.count(Class::F32Limit),
            beyond_f32: report.count(Class::BeyondF32),
            unexplained: report.count(Class::Unexplained),
            in_one_place: self.in_one_place,
            share_of_outline: report.share_of_outline(),
            worst: report.worst().map(|at| self.worst(at)),
            adapter: self.adapter,
            sub_pixel_bits: self.rasteriser.sub_pixel_bits(),
            drawn_s: self.seconds[0],
            picked_s: self.seconds[1],
        };
        let line = json::text(&line);
        line.map(|line| line + "\n").map_err(CliError::stdout)
    }

    fn text(&self, with_image: bool) -> String {
        let report = self.report;
        let [width, height] = self.size;
        let mut text = format!(
            "{width}x{height} pixels, {} show something as drawn and {} as picked, {} lie on outlines\n",
            report.drawn, report.picked, report.outline
        );
        let mut row = |name: &str, count: usize, what: &str| {
            let row = format!("{name:<13}{count:>9}  {what}");
            text.extend([row.trim_end(), "\n"]);
        };
        let painted = |colour: &str| {
            if with_image {
                format!(" ({colour})")
            } else {
                String::new()
            }
        };
        row("same", report.same(), "");
        let grid = 1 << self.rasteriser.sub_pixel_bits();
        for (class, _, colour) in COLOURS {
            let what = match class {
                Class::Edge => format!("the centre lies on an outline, to 1/{grid} pixel"),
                Class::Depth => {
                    "the depth buffer may show either of two surfaces; they are at most half a pixel's width apart"
                        .into()
                }
                Class::Section => format!(
                    "the section cuts the surface here, within 1/{grid} pixel or the error of f32, at most half a pixel's width away"
                ),
                Class::F32Limit => format!(
                    "the centre lies on an outline as far as f32 can tell, at most {OUTLINE_CEILING_PX} px from it"
                ),
                Class::BeyondF32 => {
                    "f32 is too coarse to draw this view: use render --by raycast".to_owned()
                }
                Class::Unexplained => "defects".to_owned(),
            };
            let what = what + &painted(colour);
            row(class.name(), report.count(class), &what);
        }
        let what = "of all the pixels above: surfaces closer together than drawing can tell apart";
        let what = what.to_owned() + &painted(IN_ONE_PLACE.1);
        row("in one place", self.in_one_place, &what);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{} of {} outline pixels differ ({:.2} %), {} elsewhere",
            report.outline_differ,
            report.outline,
            100.0 * report.share_of_outline(),
            report.differ_off_outlines()
        );
        if let Some(at) = report.worst() {
            let _ = writeln!(text, "{}", self.worst_line(at));
        }
        let [drawn_s, picked_s] = self.seconds;
        let _ = writeln!(
            text,
            "drawn in {drawn_s:.2} s by {}, picked in {picked_s:.2} s",
            self.adapter
        );
        text
    }

    fn worst_line(&self, at: &Disagreement) -> String {
        let say = |id, depth| match self.answer(id, depth) {
            None => "nothing".to_owned(),
            Some(answer) => {
                let triangle = answer
                    .triangle
                    .map(|triangle| format!(", triangle {triangle}"));
                let depth = answer.depth.map(|depth| format!(", depth {depth}"));
                format!(
                    "{} (id {}{}{})",
                    plain::plain(answer.object),
                    answer.id,
                    triangle.unwrap_or_default(),
                    depth.unwrap_or_default()
                )
            }
        };
        let [x, y] = at.pixel;
        let measure = if at.outline_px.is_finite() {
            format!(
                "{:.2e} px from an outline that drawing may move by {:.2e} px",
                at.outline_px, at.outline_error_px
            )
        } else if at.strain.is_finite() {
            let what = match at.class {
                Class::Section => "drawing",
                _ => "the depth buffer",
            };
            format!("{:.2} times the error that {what} may have", at.strain)
        } else {
            "no outline and no depth explains it".to_owned()
        };
        format!(
            "worst: pixel {x},{y}: drawn {}, picked {}; {}: {measure}",
            say(at.drawn, at.depth[0]),
            say(at.picked, at.depth[1]),
            at.class.name()
        )
    }
}

/// The value; `None` for infinities and NaN, which JSON does not have.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
