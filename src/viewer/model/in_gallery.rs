//! A scene of the failure gallery on show: picks by a method of the study, beside what this program picks there.

use crate::{
    camera::View,
    scene::{Scene, gallery::Exhibit},
    study::{
        breaks::{self, Break},
        swap::{Found, Swap},
    },
};
use glam::DVec2;

/// A scene of the gallery, and which method picks in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Showing {
    /// The scene.
    pub exhibit: &'static Exhibit,
    /// The method that picks; `None` for this program's own, which is the default.
    pub method: Option<Swap>,
    /// What the method said about the last click.
    pub compared: Option<Compared>,
}

/// One click by a method and by this program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// The view that the click was in.
    pub view: View,
    /// Where the click was: the centre of a pixel.
    pub px: DVec2,
    /// What the method picks.
    pub theirs: Option<Found>,
    /// What this program picks, and the picture shows.
    pub ours: Option<Found>,
}

/// What is wrong with a method's pick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// It hits nothing where there is something.
    Missed,
    /// It hits something where there is nothing.
    Phantom,
    /// It hits another object or triangle.
    Other,
    /// It hits the right object and triangle, this far from the right point.
    Off(Distance),
}

/// How far two hits on one surface are from each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// Between the points as the picture shows them, in pixels; 0 where one of them lies behind the eye.
    pub px: f64,
    /// Between the points, in world units.
    pub world: f64,
    /// The same, divided by the distance from the eye.
    pub relative: f64,
    /// Between the outward normals, in degrees.
    pub normal_deg: f64,
}

impl Fault {
    /// Whether anybody would see it.
    pub fn is_wrong(&self) -> bool {
        !matches!(self, Self::Off(by) if !by.shows())
    }
}

impl Distance {
    /// Whether anybody would see it: half a pixel, a degree or a ten-thousandth of the distance is enough.
    pub fn shows(&self) -> bool {
        // NaN counts as visible.
        let small = self.px < 0.5 && self.normal_deg < 1.0 && self.relative < 1e-4;
        !small
    }
}

impl Showing {
    /// A scene that has just been opened, where Sightline's own method picks.
    pub fn new(exhibit: &'static Exhibit) -> Self {
        Self {
            exhibit,
            method: None,
            compared: None,
        }
    }

    /// The method before or after the present one, in a ring with this program's own.
    pub fn next_method(&self, forward: bool) -> Option<Swap> {
        let swaps = breaks::swaps(self.exhibit.name);
        let own = swaps.len();
        let is_now = |swap: &Swap| self.method == Some(*swap);
        let now = swaps.iter().position(is_now).unwrap_or(own);
        let step = if forward { 1 } else { own };
        swaps.get((now + step) % (own + 1)).copied()
    }

    /// Which of the breaks on this scene to show: the present method's own, else one of the same step, else the first.
    pub fn subject(&self) -> Option<&'static Break> {
        let breaks = || breaks::breaks_on(self.exhibit.name);
        let own = || breaks().find(|known| known.swap() == self.method);
        let step = |known: &&Break| self.method.is_some_and(|swap| swap.step == known.step);
        own()
            .or_else(|| breaks().find(step))
            .or_else(|| breaks().next())
    }
}

impl Compared {
    /// One click, picked both ways.
    pub fn at(scene: &Scene, view: &View, method: &Swap, px: DVec2) -> Self {
        Self {
            view: *view,
            px,
            theirs: method.pick(scene, view, px),
            ours: Found::sightlines(scene, view, px),
        }
    }

    /// What is wrong with the method's pick; `None` where both hit nothing.
    pub fn fault(&self) -> Option<Fault> {
        let what = |found: &Found| {
            let triangle = found.hit.hit.on_triangle.map(|at| at.triangle);
            (found.hit.object, triangle)
        };
        Some(match (&self.theirs, &self.ours) {
            (None, None) => return None,
            (None, Some(_)) => Fault::Missed,
            (Some(_), None) => Fault::Phantom,
            (Some(theirs), Some(ours)) if what(theirs) != what(ours) => Fault::Other,
            (Some(theirs), Some(ours)) => Fault::Off(distance(&self.view, theirs, ours)),
        })
    }
}

fn distance(view: &View, theirs: &Found, ours: &Found) -> Distance {
    let px = |found: &Found| view.project(found.point_world).map(|at| at.px);
    let world = theirs.point_world.distance(ours.point_world);
    let normals = [theirs, ours].map(|found| found.normal_world);
    let turned = libm::atan2(
        normals[0].cross(normals[1]).length(),
        normals[0].dot(normals[1]),
    );
    let apart = match (px(theirs), px(ours)) {
        (Some(theirs), Some(ours)) => theirs.distance(ours),
        _ => 0.0,
    };
    Distance {
        px: apart,
        world,
        relative: world / ours.point_world.distance(view.camera.eye()),
        normal_deg: turned.to_degrees(),
    }
}
