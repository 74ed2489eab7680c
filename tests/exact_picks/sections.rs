//! Scenes that a section cuts: along faces, through vertices, through the eye, along rays, across axes and anywhere.

use super::{blocks::Sample, borders, cuts::some_section, families, lattice, ties};
use crate::common::Random;

/// A sample of a general family, cut.
pub fn anywhere(random: &mut Random) -> Sample {
    let make = [
        families::ordinary,
        families::culled,
        families::condition,
        families::far_eyes,
        families::sizes,
        families::narrow_gaps,
        borders::borders,
        borders::planes_nearly,
    ][random.below(8)];
    let sample = make(random);
    cut(random, sample)
}

/// A sample of short numbers, whose faces and vertices a plane can meet exactly.
pub fn exact(random: &mut Random) -> Sample {
    let make = [
        lattice::exact_borders,
        lattice::planes,
        ties::ties,
        ties::ties_at_the_eye,
    ][random.below(4)];
    let sample = make(random);
    cut(random, sample)
}

fn cut(random: &mut Random, mut sample: Sample) -> Sample {
    sample.view.section = Some(some_section(random, &sample.scene, &sample.view));
    sample
}
