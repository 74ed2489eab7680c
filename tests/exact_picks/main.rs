//! Whole picks are what exact arithmetic says, for scenes, views and positions of many kinds. Each hit and each record
//! is compared with an oracle, which computes it from the stored numbers by brute force and shares no code with the
//! program.
//!
//! Each position is asked without trees and with them, and with each instruction set of this processor. Some positions
//! are asked again from the scene narrowed to the position, and some views are cast as whole pictures.
//!
//! `SIGHTLINE_POSITIONS=100000 cargo test --locked --release --test exact_picks -- --nocapture families` asks that many
//! positions of each family and prints a line for each.
#![cfg(feature = "window")]

mod aim;
mod along_faces;
mod attacked;
mod blocks;
mod borders;
mod by_hand;
#[path = "../common/mod.rs"]
mod common;
mod compare;
#[path = "../common/sections.rs"]
mod cuts;
#[path = "../common/exact/mod.rs"]
mod exact;
mod families;
mod findings;
mod instructions;
mod lattice;
mod narrowed;
mod program;
mod rays;
mod sections;
mod sight;
mod snap;
mod tally;
mod ties;
mod together;

use blocks::{Layout, Sample};
use common::Random;
use compare::Case;
use exact::truth::World;
use tally::Tally;

/// Positions of each family in an ordinary run.
const POSITIONS: usize = 1000;

/// The least that a family must show in a thousand positions. Two families have no mesh worth a tree.
#[derive(Default)]
struct AtLeast {
    hits: usize,
    ties: usize,
    borders: usize,
    planes: usize,
    cut: usize,
    on_section: usize,
    hairs: usize,
    steps: usize,
    walks: usize,
    /// One position in four is asked, and most views have pyramids.
    narrowed: usize,
}

/// Positions of each family in this run.
fn wanted() -> usize {
    common::wanted("SIGHTLINE_POSITIONS", POSITIONS)
}

fn run(name: &str, seed: u64, make: fn(&mut Random) -> Sample, at_least: &AtLeast) {
    let mut random = Random::new(seed);
    let mut tally = Tally::default();
    while tally.positions < wanted() {
        let sample = make(&mut random);
        ask(&sample, &mut tally);
    }
    println!("{name:16} {}", tally.row());
    let per_mille = |count: usize| count * 1000 / tally.positions;
    assert!(
        // A section leaves fewer triangles.
        per_mille(tally.together) >= if at_least.cut > 0 { 900 } else { 1_500 },
        "{name}: few triangles in whole pictures"
    );
    for (what, seen, least) in [
        ("hits", tally.hits, at_least.hits),
        ("ties", tally.ties, at_least.ties),
        ("borders", tally.borders, at_least.borders),
        ("planes", tally.planes, at_least.planes),
        ("cut", tally.cut, at_least.cut),
        ("on section", tally.on_section, at_least.on_section),
        ("hairs", tally.hairs, at_least.hairs),
        ("steps", tally.steps, at_least.steps),
        ("walks", tally.walks, at_least.walks),
        ("narrowed", tally.narrowed, at_least.narrowed),
    ] {
        assert!(per_mille(seen) >= least, "{name}: only {seen} {what}");
    }
    let wrong = tally.wrong + tally.wrong_with_trees;
    assert!(
        wrong == 0,
        "{name}: {wrong} wrong answers\n{}",
        tally.mistakes()
    );
}

/// Asks at all positions of a sample, before there are trees and with them, by all instruction sets of this processor.
fn ask(sample: &Sample, tally: &mut Tally) {
    let world = World::of(&sample.scene);
    let case = Case {
        scene: &sample.scene,
        view: &sample.view,
        world: &world,
    };
    let before: Vec<_> = sample
        .positions
        .iter()
        .map(|&px| case.check(px, true, tally))
        .collect();
    sample.scene.build_trees();
    for (i, (&px, before)) in sample.positions.iter().zip(before).enumerate() {
        case.recheck(px, (i % 8 == 0).then_some(before), tally);
    }
    instructions::check(sample, tally);
    narrowed::check(sample, tally);
    together::check(sample, tally);
    match sample.layout {
        Layout::Anywhere => {}
        Layout::Pairs => tally.steps += case.steps(&sample.positions),
        Layout::Picture => case.check_pictures(&sample.positions, tally),
    }
}

macro_rules! families {
    ($($name:ident, $seed:literal, $make:path, $at_least:expr;)*) => {
        mod families_agree {
            use super::*;
            $(#[test] fn $name() { run(stringify!($name), $seed, $make, &$at_least); })*
        }
    };
}

families! {
    ordinary, 1, families::ordinary, AtLeast { hits: 550, walks: 85, narrowed: 200, ..AtLeast::default() };
    culled, 2, families::culled, AtLeast { hits: 500, walks: 80, narrowed: 200, ..AtLeast::default() };
    condition, 3, families::condition, AtLeast { hits: 550, hairs: 50, walks: 55, narrowed: 40, ..AtLeast::default() };
    far_eyes, 4, families::far_eyes, AtLeast { hits: 550, hairs: 10, walks: 100, narrowed: 80, ..AtLeast::default() };
    sizes, 5, families::sizes, AtLeast { hits: 550, walks: 115, narrowed: 200, ..AtLeast::default() };
    narrow_gaps, 6, families::narrow_gaps, AtLeast { hits: 550, hairs: 300, narrowed: 200, ..AtLeast::default() };
    borders, 7, borders::borders, AtLeast { hits: 600, steps: 300, walks: 100, narrowed: 150, ..AtLeast::default() };
    planes_nearly, 8, borders::planes_nearly, AtLeast { hits: 550, hairs: 900, walks: 95, narrowed: 130, ..AtLeast::default() };
    exact_borders, 9, lattice::exact_borders, AtLeast { hits: 800, borders: 200, ties: 100, walks: 230, narrowed: 200, ..AtLeast::default() };
    planes, 10, lattice::planes, AtLeast { hits: 180, planes: 220, walks: 12, narrowed: 200, ..AtLeast::default() };
    ties, 11, ties::ties, AtLeast { hits: 800, ties: 500, borders: 200, walks: 220, narrowed: 200, ..AtLeast::default() };
    ties_at_the_eye, 12, ties::ties_at_the_eye, AtLeast { hits: 700, ties: 450, planes: 200, walks: 220, narrowed: 200, ..AtLeast::default() };
    long_ties, 13, ties::long_ties, AtLeast { hits: 550, ties: 300, narrowed: 200, ..AtLeast::default() };
    sections, 15, sections::anywhere, AtLeast { hits: 250, cut: 250, walks: 30, ..AtLeast::default() };
    exact_sections, 16, sections::exact, AtLeast { hits: 250, cut: 200, on_section: 50, walks: 30, ..AtLeast::default() };
}
