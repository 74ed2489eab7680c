//! `verify` finds drawing and picking equal under every condition that a user can bring about, except where it says
//! that the view is beyond `f32`. It finds wrong pickers and wrong drawings.
#![cfg(feature = "window")]

#[allow(dead_code, reason = "the oracle's tests use the rest")]
#[path = "../exact_picks/aim.rs"]
mod aim;
#[allow(dead_code, reason = "the oracle's tests use the rest")]
#[path = "../exact_picks/blocks.rs"]
mod blocks;
mod broken;
mod broken_drawings;
mod cameras;
mod command;
#[path = "../common/mod.rs"]
mod common;
mod conditions;
#[path = "../common/sections.rs"]
mod cuts;
mod depths;
mod drivers;
mod excuses;
mod extremes;
#[path = "../exact_picks/families.rs"]
mod families;
#[path = "../common/images.rs"]
mod images;
#[allow(dead_code, reason = "the oracle's tests use the rest")]
#[path = "../exact_picks/lattice.rs"]
mod lattice;
mod models;
mod no_such_part;
mod one_place;
mod report;
#[path = "../common/scenes.rs"]
mod scenes;
mod sections;
mod slivers;
#[path = "../exact_picks/ties.rs"]
mod ties;
mod views;

use sightline::{
    camera::View,
    image::{Id, Image},
    render::{Gpu, Rasteriser, Renderer, SceneBuffers, Targets},
    scene::Scene,
    verify::{self, Places, Report},
};
use std::sync::OnceLock;

/// The rasteriser of this machine's driver.
fn rasteriser() -> Rasteriser {
    static FOUND: OnceLock<Rasteriser> = OnceLock::new();
    *FOUND.get_or_init(|| scenes::gpu().rasteriser())
}

/// [`verify::compare`] with this rasteriser.
fn compare(scene: &Scene, view: &View, drawn: &Image<Id>, picked: &Image<Id>) -> Report {
    verify::compare(scene, view, rasteriser(), drawn, picked)
}

/// [`compare`] of a picture that no driver drew, with the common grid: it tells the same on every machine.
fn compare_made(scene: &Scene, view: &View, made: &Image<Id>, picked: &Image<Id>) -> Report {
    verify::compare(scene, view, Rasteriser::COMMON, made, picked)
}

/// [`Places`] with this rasteriser.
fn places<'a>(scene: &'a Scene, view: &View) -> Places<'a> {
    Places::new(scene, view, rasteriser())
}

/// The ids that the GPU draws.
fn drawn(gpu: &Gpu, renderer: &mut Renderer, buffers: &SceneBuffers, view: &View) -> Image<Id> {
    let targets = Targets::new(gpu, view.viewport, 1).expect("fits");
    renderer
        .draw((buffers, &targets, view), &[])
        .expect("draws");
    targets.read_ids(gpu).expect("ids")
}

/// [`drawn`] of one view.
fn drawn_once(scene: &Scene, view: &View) -> Image<Id> {
    let gpu = scenes::gpu();
    let buffers = SceneBuffers::upload(&gpu, scene).expect("fits");
    drawn(&gpu, &mut Renderer::new(&gpu, 1), &buffers, view)
}
