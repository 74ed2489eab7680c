//! The ray through a position, from the numbers that a camera holds.

use super::{
    number::{Dyadic, Vector, dot, minus, plus, times, vector},
    root::Parameter,
};
use glam::{DVec2, DVec3};
use sightline::{
    camera::{Projection, View},
    geometry::Ray,
};
use std::cmp::Ordering;

/// The ray through a position. Its points are `(origin + t direction) / scale`.
#[derive(Clone, Debug)]
pub struct Line {
    pub origin: Vector,
    pub direction: Vector,
    /// The picture's height, by which everything is multiplied so that nothing is divided.
    pub scale: Dyadic,
    pub near: Dyadic,
    pub far: Dyadic,
    /// Normal n and offset c.
    pub section: Option<(Vector, Dyadic)>,
}

impl Line {
    pub fn of(view: &View, px: DVec2) -> Self {
        let (camera, viewport) = (&view.camera, view.viewport);
        let scale = Dyadic::of(viewport.height().into());
        let twice = |at: f64, size: u32| &Dyadic::of(at).shifted(1) - &Dyadic::of(size.into());
        let half = Dyadic::of(camera.half_height());
        let right = &half * &twice(px.x, viewport.width());
        let up = &half * &-&twice(px.y, viewport.height());
        let aside = plus(
            &times(&right, &vector(camera.right())),
            &times(&up, &vector(camera.up())),
        );
        let eye = times(&scale, &vector(camera.eye()));
        let forward = times(&scale, &vector(camera.forward()));
        let lens = camera.lens();
        let (origin, direction) = match lens.projection {
            Projection::Perspective { .. } => (eye, plus(&forward, &aside)),
            Projection::Orthographic { .. } => (plus(&eye, &aside), forward),
        };
        Self {
            origin,
            direction,
            scale,
            near: Dyadic::of(lens.near),
            far: Dyadic::of(lens.far),
            section: view
                .section
                .map(|section| (vector(section.normal()), Dyadic::of(section.offset()))),
        }
    }

    /// A ray that is given by its numbers, all of them finite.
    pub fn given(ray: &Ray) -> Self {
        Self {
            origin: vector(ray.origin),
            direction: vector(ray.direction),
            scale: Dyadic::whole(1),
            near: Dyadic::of(ray.t_min),
            far: Dyadic::of(ray.t_max),
            section: None,
        }
    }

    /// On which side of the section the point at `t` lies: `Greater` and `Equal` are kept.
    pub fn side(&self, t: &Parameter) -> Ordering {
        let Some((normal, offset)) = &self.section else {
            return Ordering::Greater;
        };
        // Times the scale.
        let start = &dot(normal, &self.origin) + &(offset * &self.scale);
        let ahead = dot(normal, &self.direction);
        match ahead.sign() {
            Ordering::Equal => start.sign(),
            Ordering::Greater => t.compare(&Parameter::fraction(&-&start, &ahead)),
            Ordering::Less => Parameter::fraction(&-&start, &ahead).compare(t),
        }
    }

    /// The point at `t`.
    pub fn point(&self, t: &Parameter) -> DVec3 {
        t.rounded_point(&self.origin, &self.direction, &self.scale)
            .into()
    }

    /// In units of `t`: the largest coordinate of the start and of the point at `t`, over the direction's largest.
    pub fn reach(&self, t: &Parameter) -> f64 {
        let rounded = |v: &Vector| DVec3::from(v.each_ref().map(|c| c.over(&self.scale)));
        let start = rounded(&self.origin).abs().max_element();
        let size = start.max(self.point(t).abs().max_element());
        size / rounded(&self.direction).abs().max_element()
    }

    /// How far the point at `t` is from another, rounded to `f64`.
    pub fn distance(&self, from: DVec3, t: &Parameter) -> f64 {
        let seen = minus(&self.origin, &times(&self.scale, &vector(from)));
        let [x, y, z] = t.rounded_point(&seen, &self.direction, &self.scale);
        x.hypot(y).hypot(z)
    }
}
