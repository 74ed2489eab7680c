//! Every other instruction set of this processor gives the answers that the oracle has judged.

use super::{
    blocks::Sample,
    program::{self, Answer},
    tally::Tally,
};
use glam::DVec2;
use sightline::{
    geometry::{Mesh, Simd},
    pick::Pick,
    scene::{Scene, Shape},
};
use std::{
    collections::HashMap,
    sync::{Arc, atomic::AtomicBool},
};

/// One in so many positions is also asked for its record.
const RECORD_EVERY: usize = 8;

/// The answers at a position.
type Said = (Option<Answer>, Vec<Answer>, Option<Pick>);

fn said(sample: &Sample, scene: &Scene) -> Vec<Said> {
    let view = &sample.view;
    let at = |(i, &px): (usize, &DVec2)| {
        let record = i % RECORD_EVERY == 0;
        (
            program::closest(scene, view, px),
            program::all(scene, view, px),
            record.then(|| program::record(scene, view, px)).flatten(),
        )
    };
    sample.positions.iter().enumerate().map(at).collect()
}

/// The same scene. Its meshes have trees for other instructions.
fn walked_by(simd: Simd, scene: &Scene) -> Scene {
    let mut copies: HashMap<*const Mesh, Arc<Mesh>> = HashMap::new();
    let mut objects = scene.objects().to_vec();
    for object in &mut objects {
        if let Shape::Mesh { mesh, .. } = &mut object.shape {
            // Objects that share a mesh share its copy.
            let copy = copies.entry(Arc::as_ptr(mesh)).or_insert_with(|| {
                let copy = Mesh::new(mesh.data().clone()).expect("as before");
                copy.build_tree_by(simd, &AtomicBool::new(false));
                Arc::new(copy)
            });
            *mesh = Arc::clone(copy);
        }
    }
    Scene::new(objects)
}

/// Whether an answer is a triangle found by a tree.
fn is_walked(scene: &Scene, answer: &Answer) -> bool {
    match &scene.objects()[answer.object].shape {
        Shape::Mesh { mesh, .. } => !mesh.tree_boxes(0, 1).is_empty(),
        _ => false,
    }
}

/// Asks again by the other instructions, at all positions of a sample. Its trees are built and its answers are judged.
pub fn check(sample: &Sample, tally: &mut Tally) {
    let judged = said(sample, &sample.scene);
    let is_walked = |(_, all, _): &&Said| all.iter().any(|hit| is_walked(&sample.scene, hit));
    tally.walks += judged.iter().filter(is_walked).count();
    for simd in Simd::available().filter(|simd| *simd != Simd::fastest()) {
        let scene = walked_by(simd, &sample.scene);
        for ((judged, said), px) in (judged.iter().zip(said(sample, &scene))).zip(&sample.positions)
        {
            if said != *judged {
                let place = format!("{px:?} of {:?}", sample.view);
                tally.wrong_with_trees += 1;
                let example =
                    format!("another answer by {simd:?} at {place}: {said:?} for {judged:?}");
                let entry = tally.kinds.entry("instructions").or_insert((0, example));
                entry.0 += 1;
            }
        }
    }
}
