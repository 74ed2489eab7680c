//! A scene narrowed to a position gives the records that the oracle has judged.

use super::{blocks::Sample, program, tally::Tally};

/// One in so many positions is asked.
const EVERY: usize = 4;

/// Asks once trees are built.
pub fn check(sample: &Sample, tally: &mut Tally) {
    let Sample {
        scene,
        view,
        positions,
        ..
    } = sample;
    for &px in positions.iter().step_by(EVERY) {
        let Some(narrowed) = program::narrowed(scene, view, px) else {
            continue;
        };
        tally.narrowed += 1;
        let [expected, found] = [scene, &narrowed].map(|scene| {
            (
                program::record(scene, view, px),
                program::records(scene, view, px),
            )
        });
        if expected != found {
            tally.wrong_with_trees += 1;
            let example = format!("narrowed: at {px}: {found:?}, not {expected:?}, {view:?}");
            let kind = tally.kinds.entry("narrowed").or_insert((0, example));
            kind.0 += 1;
        }
    }
}
