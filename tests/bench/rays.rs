//! Rays as picks cast them: from an eye through pixels, in order or shuffled; and rays from all around.

use glam::{DVec3, dvec3};
use sightline::geometry::{Aabb, Ray};

/// A ray whose numbers fit in `f32`, so that all rivals get the same.
fn ray(origin: DVec3, direction: DVec3) -> Ray {
    Ray {
        origin: origin.as_vec3().as_dvec3(),
        direction: direction.as_vec3().as_dvec3(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    }
}

/// Random numbers (splitmix64).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// In [0, 1).
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let p = dvec3(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0;
            if p.length_squared() <= 1.0 && p != DVec3::ZERO {
                return p.normalize();
            }
        }
    }
}

/// Rays through the pixels of a square picture that a box fills: neighbours after each other, or shuffled.
pub fn camera(bounds: &Aabb, side: u32, shuffled: bool) -> Vec<Ray> {
    let towards = dvec3(-1.0, -0.8, -1.6).normalize();
    let right = towards.cross(DVec3::Y).normalize();
    let up = right.cross(towards);
    let half = (22.5_f64).to_radians().tan();
    let eye = bounds.center() - towards * (1.05 * bounds.radius() / (22.5_f64).to_radians().sin());
    let share = |i: u32| half * ((f64::from(i) + 0.5) * 2.0 / f64::from(side) - 1.0);
    let pixels = (0..side).flat_map(|j| (0..side).map(move |i| (i, j)));
    let mut rays: Vec<_> = pixels
        .map(|(i, j)| ray(eye, towards + share(i) * right - share(j) * up))
        .collect();
    if shuffled {
        let mut random = Random(1);
        for i in (1..rays.len()).rev() {
            let other = random.bits() % (i as u64 + 1);
            rays.swap(i, usize::try_from(other).expect("fits"));
        }
    }
    rays
}

/// Rays between random points of the sphere about a box.
pub fn from_all_around(bounds: &Aabb, count: usize) -> Vec<Ray> {
    let mut random = Random(2);
    let on_sphere = |random: &mut Random| bounds.center() + bounds.radius() * random.direction();
    let rays = (0..count).map(|_| {
        let (from, to) = (on_sphere(&mut random), on_sphere(&mut random));
        ray(from, to - from)
    });
    rays.collect()
}
