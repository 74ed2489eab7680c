//! Whole pictures, whose rays go through the scene together, show at each pixel what its ray hits alone.

use super::{blocks::Sample, program, tally::Tally};
use glam::DVec2;
use sightline::camera::{View, Viewport};

/// Small, and not a whole number of tiles.
const SIZE: [u32; 2] = [45, 37];

/// One picture for so many positions.
const POSITIONS: usize = 50;

/// Casts a picture once trees are built.
pub fn check(sample: &Sample, tally: &mut Tally) {
    if tally.pictures * POSITIONS > tally.positions {
        return;
    }
    tally.pictures += 1;
    let viewport = Viewport::new(SIZE[0], SIZE[1]).expect("a picture");
    let (scene, view) = (
        &sample.scene,
        &View {
            viewport,
            ..sample.view
        },
    );
    let pictures = program::pictures(scene, view);
    for (i, [x, y]) in (0..SIZE[1])
        .flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]))
        .enumerate()
    {
        let px = DVec2::new(x.into(), y.into()) + 0.5;
        let alone = program::closest(scene, view, px).map_or((0, 0), |answer| {
            let first = program::first_triangle(&scene.objects()[answer.object].shape);
            let triangle = answer.triangle.map_or(0, |triangle| triangle - first + 1);
            (u32::try_from(answer.object + 1).expect("few"), triangle)
        });
        tally.together += usize::from(alone.1 > 0);
        for picture in &pictures {
            if picture[i] != alone {
                tally.wrong_with_trees += 1;
                let example = format!(
                    "together: at {px}: {:?}, not {alone:?}, {view:?}",
                    picture[i]
                );
                let kind = tally.kinds.entry("together").or_insert((0, example));
                kind.0 += 1;
            }
        }
    }
}
