//! One camera for picture and pick: matrices and rays agree with each other and with the textbook.
#![cfg(feature = "window")]

#[path = "../common/mod.rs"]
mod common;
mod matrices;
mod poses;
mod rays;

use common::{Random, orthographic, perspective, view};
use sightline::camera::{DepthMapping, Lens, View};

const MAPPINGS: [DepthMapping; 2] = [DepthMapping::Reversed, DepthMapping::Standard];

fn with_depth(lens: Lens, depth: DepthMapping) -> Lens {
    Lens { depth, ..lens }
}

/// Views through both lenses and mappings, over fields of view and distances from the origin.
fn views() -> Vec<View> {
    let mut random = Random::new(1);
    let mut views = Vec::new();
    for far_out in [0.0, 1e3, 1e6] {
        for fov in [0.5, 30.0, 90.0, 178.0] {
            for depth in MAPPINGS {
                for lens in [perspective(fov, 0.1, 100.0), orthographic(fov, -3.0, 100.0)] {
                    let eye = far_out * random.direction() + random.point(2.0);
                    let target = eye + random.within(0.5, 20.0) * random.direction();
                    let lens = with_depth(lens, depth);
                    views.push(view(eye.into(), target.into(), lens, [640, 360]));
                }
            }
        }
    }
    views
}
