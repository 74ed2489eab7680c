//! What tests share.
#![allow(dead_code, reason = "each test uses its share")]

use glam::DVec3;
use sightline::camera::{Camera, DepthMapping, Lens, Projection, View, Viewport};
use std::path::PathBuf;

/// A perspective lens with reversed depth; `fov` in degrees.
pub fn perspective(fov: f64, near: f64, far: f64) -> Lens {
    Lens {
        projection: Projection::Perspective {
            fov_y: fov.to_radians(),
        },
        near,
        far,
        depth: DepthMapping::Reversed,
    }
}

/// An orthographic lens with reversed depth.
pub fn orthographic(height: f64, near: f64, far: f64) -> Lens {
    Lens {
        projection: Projection::Orthographic { height },
        near,
        far,
        depth: DepthMapping::Reversed,
    }
}

/// A view with y up that shows both sides.
pub fn view(eye: [f64; 3], target: [f64; 3], lens: Lens, size: [u32; 2]) -> View {
    View {
        camera: Camera::new(eye.into(), target.into(), DVec3::Y, lens).expect("a camera"),
        viewport: Viewport::new(size[0], size[1]).expect("a viewport"),
        sides: sightline::geometry::Sides::Both,
    }
}

/// The folder of real files; `None` where there is none, which the test must say ("real files: absent").
pub fn shared() -> Option<PathBuf> {
    let folder = std::env::var_os("SIGHTLINE_SHARED").map(PathBuf::from)?;
    assert!(
        folder.join("models").is_dir(),
        "SIGHTLINE_SHARED is set but holds no models"
    );
    Some(folder)
}
