//! The ray parameter of a pick's hit, for its record: in pairs of `f64` where they suffice, else exactly.

use super::{
    super::{WorldRay, local_ray::Exactly},
    enclosure::{Enclosure, rounded_quotient},
    exact_line::LocalLine,
    meeting::{Surface, enclosed, parameter},
    number::{Difference, Ratio},
    root::Root,
    solids, triangle,
};
use crate::geometry::Placement;
use glam::DVec3;
use std::{cell::OnceCell, ptr};

/// The ray parameter of a hit. The ray must meet the surface.
pub(crate) struct Parameter<'a> {
    ray: &'a WorldRay<'a>,
    surface: Surface<'a>,
    enclosed: Option<Ratio<Enclosure>>,
    root: OnceCell<Option<Root>>,
}

impl<'a> Parameter<'a> {
    /// Where a ray meets a surface.
    pub fn new(ray: &'a WorldRay<'a>, surface: Surface<'a>) -> Self {
        Self {
            ray,
            enclosed: enclosed(ray, &surface).ok(),
            surface,
            root: OnceCell::new(),
        }
    }

    /// The exact parameter; `None` where a number is not finite.
    fn root(&self) -> Option<&Root> {
        let root = || parameter(self.ray, &self.surface);
        self.root.get_or_init(root).as_ref()
    }

    /// The nearest `f64`; `None` where a number is not finite.
    pub fn to_f64(&self) -> Option<f64> {
        let rounded = |t: &Ratio<Enclosure>| rounded_quotient(&t.numerator, &t.denominator).ok();
        let rounded = self.enclosed.as_ref().and_then(rounded);
        rounded.or_else(|| Some(self.root()?.to_f64()))
    }

    /// How far it lies behind another of the same ray: the exact difference, rounded once; `None` where a number is not
    /// finite.
    pub fn behind(&self, before: &Self) -> Option<f64> {
        let rounded = || {
            let (a, b) = (self.enclosed.as_ref()?, before.enclosed.as_ref()?);
            let difference = Difference::new([a, b]).product;
            rounded_quotient(&difference, &a.denominator.times(&b.denominator)).ok()
        };
        rounded().or_else(|| Some(self.root()?.behind(before.root()?)))
    }

    /// The point there in the object space of a placement: each coordinate to within three roundings; `None` where a
    /// number is not finite.
    pub fn point_object(&self, placement: &Placement) -> Option<DVec3> {
        let exactly = Exactly::placed(self.ray, placement);
        let enclosed = || {
            let t = self.enclosed.as_ref()?;
            let line = LocalLine::<Enclosure>::new(&exactly);
            let plane = (self.surface.plane()).filter(|(own, _)| ptr::eq(*own, placement));
            let known = plane.map(|(_, known)| known);
            solids::at(&line, [&t.numerator, &t.denominator], known).ok()
        };
        enclosed().or_else(|| solids::point_at(&exactly, self.root()?))
    }

    /// The barycentric weights there, each to within three roundings. `None` for anything but a triangle, and when the
    /// ray runs along the triangle's plane.
    pub fn weights(&self) -> Option<[f64; 3]> {
        let Surface::Triangle(triangle) = &self.surface else {
            return None;
        };
        triangle::weights(&self.ray.line, triangle)
    }
}
