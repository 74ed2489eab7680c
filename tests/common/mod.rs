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

/// Random numbers that are the same in every run (xorshift64*, Vigna 2016).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let value = bits as f64;
        value * f64::EPSILON * 0.5
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Each coordinate uniform in [-half, half).
    pub fn point(&mut self, half: f64) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| self.within(-half, half)))
    }

    /// A unit vector, all directions alike.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let point = self.point(1.0);
            if (0.01..1.0).contains(&point.length_squared()) {
                return point.normalize();
            }
        }
    }
}

/// Fails unless two points differ by no more than `relative` times the larger one's length.
#[track_caller]
pub fn assert_near(a: DVec3, b: DVec3, relative: f64) {
    let size = a.length().max(b.length());
    assert!(
        a.distance(b) <= relative * size,
        "{a} is {} from {b}, more than {relative} of {size}",
        a.distance(b)
    );
}

/// Fails unless two numbers differ by no more than `relative` times the larger one.
#[track_caller]
pub fn assert_close(a: f64, b: f64, relative: f64) {
    let size = a.abs().max(b.abs());
    assert!(
        (a - b).abs() <= relative * size,
        "{a} is {} from {b}, more than {relative} of {size}",
        (a - b).abs()
    );
}
