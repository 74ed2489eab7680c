//! A map of wrong picks: the course's method beside this program's, on the same hard scene.

use super::picture::{Anchor, COLOURS, Colour, INK, Picture, QUIET};
use crate::study::{
    methods::picks::{PickCase, PickWorld, Picked},
    step::Case,
    workloads::picks::ball_scene,
};
use glam::DVec2;
use std::{num::NonZero, sync::Arc, thread};

/// How far out the scene stands, in the ball's radii.
pub const OFFSET: f64 = 100.0;
/// Every how many pixels a pick is made.
const STRIDE: u32 = 2;

/// What a pick is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Background,
    Right,
    Missed,
    Wrong,
}

impl Class {
    fn colour(self) -> Colour {
        match self {
            Self::Background => [0xf4, 0xf4, 0xf4],
            Self::Right => [0xc4, 0xcf, 0xd6],
            Self::Missed => COLOURS[1],
            Self::Wrong => COLOURS[0],
        }
    }
}

/// The chart.
#[must_use]
pub fn chart(title: &str) -> Picture {
    let (scene, view) = ball_scene(OFFSET);
    let world = Arc::new(PickWorld::new(&scene, view, None));
    let (columns, rows) = (
        view.viewport.width() / STRIDE,
        view.viewport.height() / STRIDE,
    );
    let at = |i: u32| {
        let px =
            DVec2::new(f64::from(i % columns), f64::from(i / columns)) * f64::from(STRIDE) + 0.5;
        PickCase::new(&world, px)
    };
    let cases: Vec<PickCase> = (0..columns * rows).map(at).collect();
    let truths = each(&cases, &PickCase::truth);
    let mut picture = Picture::new(1600, 650);
    picture.text([40.0, 36.0], Anchor::Left, 27.0, INK, title);
    let line = format!(
        "The same {} picks on a ball of 5120 triangles, {OFFSET} of its radii from the origin: every one decided by exact arithmetic.",
        cases.len()
    );
    picture.text([40.0, 68.0], Anchor::Left, 17.0, QUIET, line);
    let shown = [
        ("the course's", "The course's steps, f32"),
        ("Sightline's", "Sightline's"),
    ];
    for (place, (name, words)) in shown.into_iter().enumerate() {
        let Some(method) = PickCase::methods().find(|method| method.name == name) else {
            continue;
        };
        let answers = each(&cases, &method.run);
        let classes: Vec<Class> = truths
            .iter()
            .zip(&answers)
            .map(|(t, a)| class(t, a))
            .collect();
        #[expect(clippy::cast_precision_loss, reason = "a hundred thousand at most")]
        let [wrong, all] = [
            classes
                .iter()
                .filter(|c| matches!(c, Class::Missed | Class::Wrong))
                .count() as f64,
            truths.iter().flatten().count() as f64,
        ];
        #[expect(clippy::cast_precision_loss, reason = "two")]
        let left = 40.0 + 780.0 * place as f64;
        let words = format!(
            "{words}: {} of the picks on the ball wrong",
            percent(100.0 * wrong / all)
        );
        picture.text([left, 114.0], Anchor::Left, 20.0, INK, words);
        map(
            &mut picture,
            &classes,
            columns,
            [left, 136.0],
            740.0 / f64::from(columns),
        );
    }
    let legend = [
        (Class::Right, "right"),
        (Class::Missed, "falls through to the background"),
        (Class::Wrong, "another triangle"),
    ];
    for ((class, words), x) in legend.into_iter().zip([40.0, 160.0, 490.0]) {
        picture.rectangle([x, 600.0], [x + 22.0, 622.0], class.colour());
        picture.text([x + 32.0, 611.0], Anchor::Left, 18.0, INK, words);
    }
    picture
}

fn class(truth: &Picked, answer: &Picked) -> Class {
    match (truth, answer) {
        (None, None) => Class::Background,
        (truth, answer) if truth == answer => Class::Right,
        (_, None) => Class::Missed,
        _ => Class::Wrong,
    }
}

fn percent(value: f64) -> String {
    if value == 0.0 {
        "none".to_owned()
    } else {
        format!("{value:.1} %")
    }
}

/// One rectangle a run of equal pixels.
fn map(picture: &mut Picture, classes: &[Class], columns: u32, [left, top]: [f64; 2], size: f64) {
    for (y, row) in (0..).map(f64::from).zip(classes.chunks(columns as usize)) {
        let mut x = 0.0;
        for run in row.chunk_by(PartialEq::eq) {
            #[expect(clippy::cast_precision_loss, reason = "a row")]
            let end = x + run.len() as f64;
            let corner = |x: f64, y: f64| [left + size * x, top + size * y];
            picture.rectangle(corner(x, y), corner(end, y + 1.0), run[0].colour());
            x = end;
        }
    }
}

/// Answers to all cases, on all cores.
fn each(cases: &[PickCase], run: &(dyn Fn(&PickCase) -> Picked + Sync)) -> Vec<Picked> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let share = cases.len().div_ceil(threads).max(1);
    thread::scope(|scope| {
        let workers: Vec<_> = cases
            .chunks(share)
            .map(|cases| scope.spawn(move || cases.iter().map(run).collect::<Vec<_>>()))
            .collect();
        let answers = workers
            .into_iter()
            .map(|worker| worker.join().unwrap_or_default());
        answers.flatten().collect()
    })
}
