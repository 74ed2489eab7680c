//! Where each number of a worked pick is in the world.

use super::{
    hits::{RayHits, triangle},
    worked_numbers::WorkedNumber,
};
use crate::{
    geometry::{Cuboid, Placement, Square},
    pick::Pick,
    scene::Scene,
    study::worked::{WorkedPick, WorkedShape, through_all},
};
use glam::DVec3;

/// What a number is in the world.
#[derive(Clone, Debug, PartialEq)]
pub enum WorkedMark {
    /// A place.
    Dot(DVec3),
    /// A length.
    Line([DVec3; 2]),
    /// A vector.
    Arrow([DVec3; 2]),
    /// A part of a plane, by its corners.
    Area(Vec<DVec3>),
}

/// A working, and where its object is.
pub(super) struct Marks<'a> {
    worked: &'a WorkedPick,
    hits: &'a RayHits,
    placement: &'a Placement,
    /// Of the picked triangle, in the world.
    corners: Option<[DVec3; 3]>,
}

impl<'a> Marks<'a> {
    pub(super) fn new(
        worked: &'a WorkedPick,
        hits: &'a RayHits,
        pick: &Pick,
        scene: &'a Scene,
    ) -> Self {
        Self {
            worked,
            hits,
            placement: &scene.objects()[pick.id - 1].placement,
            corners: triangle(scene, pick),
        }
    }
}

impl Marks<'_> {
    /// What a number is in the world. There may be several marks, or none.
    pub(super) fn of(&self, number: WorkedNumber) -> Vec<WorkedMark> {
        let (plane, start) = (&self.worked.plane, self.worked.origin_world);
        let middle = DVec3::from(plane.middle);
        let [right, up] = plane.half.map(DVec3::from);
        let point = DVec3::from(plane.point);
        let eye = self.hits.view.camera.eye();
        let end = self.worked.hit.map_or(point, |hit| hit.point_world);
        match number {
            WorkedNumber::Pixel => {
                let [width, height] = self.hits.view.viewport.size_px().to_array();
                let (x, y) = (right / width, up / height);
                let corners = [-x - y, x - y, x + y, y - x];
                vec![WorkedMark::Area(corners.map(|by| point + by).to_vec())]
            }
            WorkedNumber::Ndc => {
                let corner = middle + plane.ndc[0] * right;
                vec![
                    WorkedMark::Arrow([middle, corner]),
                    WorkedMark::Arrow([corner, point]),
                ]
            }
            WorkedNumber::Middle => vec![WorkedMark::Dot(middle)],
            WorkedNumber::Length => vec![WorkedMark::Line([eye, middle])],
            WorkedNumber::Alpha => vec![WorkedMark::Area(vec![eye, middle, middle + up])],
            WorkedNumber::Upward => vec![WorkedMark::Arrow([middle, middle + up])],
            WorkedNumber::Rightward => vec![WorkedMark::Arrow([middle, middle + right])],
            WorkedNumber::PlanePoint => vec![WorkedMark::Dot(point)],
            WorkedNumber::Direction | WorkedNumber::DirectionObject => {
                vec![WorkedMark::Arrow([start, end])]
            }
            WorkedNumber::OriginObject => vec![WorkedMark::Dot(start)],
            _ => self.of_shape(number),
        }
    }

    /// The point of the ray in object space, in the world; `None` at infinity.
    fn at(&self, t: f64) -> Option<DVec3> {
        let point = self.worked.origin_object + t * self.worked.direction_object;
        let point = self.placement.point_to_world(point);
        point.is_finite().then_some(point)
    }

    fn dot(&self, t: f64) -> Vec<WorkedMark> {
        self.at(t).map(WorkedMark::Dot).into_iter().collect()
    }

    fn line(&self, from: f64, to: f64) -> Vec<WorkedMark> {
        match [from, to].map(|t| self.at(t)) {
            [Some(from), Some(to)] => vec![WorkedMark::Line([from, to])],
            _ => Vec::new(),
        }
    }

    /// What a number of the shape's own step is, or one of the hit.
    fn of_shape(&self, number: WorkedNumber) -> Vec<WorkedMark> {
        match &self.worked.shape {
            WorkedShape::Sphere(quadratic) => {
                let start = self.worked.origin_world;
                let middle = self.placement.model().translation;
                let nearest = -quadratic.b / (2.0 * quadratic.a);
                match number {
                    WorkedNumber::Coefficient(0) => self.line(0.0, 1.0),
                    WorkedNumber::Coefficient(1) => {
                        let nearest = self.at(nearest);
                        let lines =
                            nearest.map(|at| [WorkedMark::Line([middle, at]), WorkedMark::Dot(at)]);
                        lines.into_iter().flatten().collect()
                    }
                    WorkedNumber::Coefficient(_) => vec![WorkedMark::Line([start, middle])],
                    WorkedNumber::Discriminant => {
                        let Some([near, far]) = quadratic.roots else {
                            return Vec::new();
                        };
                        self.line(near, far)
                    }
                    WorkedNumber::Root(at) => quadratic
                        .roots
                        .map_or(Vec::new(), |roots| self.dot(roots[at])),
                    _ => self.of_hit(number),
                }
            }
            WorkedShape::Cube(slabs) => match number {
                WorkedNumber::Slab(axis) => {
                    let mut marks: Vec<_> = [-1.0, 1.0].map(|side| self.face(axis, side)).into();
                    marks.extend(slabs[axis].into_iter().flat_map(|t| self.dot(t)));
                    marks
                }
                WorkedNumber::Through(at) => self.dot(through_all(slabs)[at]),
                _ => self.of_hit(number),
            },
            WorkedShape::Square(on_plane) => match number {
                WorkedNumber::PlaneT => vec![self.face_of_square()],
                WorkedNumber::InSquare => {
                    let [x, y] = on_plane.along;
                    let place = |x, y| self.placement.point_to_world(DVec3::new(x, y, 0.0));
                    let (middle, corner, point) = (place(0.0, 0.0), place(x, 0.0), place(x, y));
                    vec![
                        WorkedMark::Arrow([middle, corner]),
                        WorkedMark::Arrow([corner, point]),
                    ]
                }
                _ => self.of_hit(number),
            },
            WorkedShape::Triangle(areas) => {
                let Some([a, b, c]) = self.corners else {
                    return Vec::new();
                };
                let point = self.at(areas.t);
                let area = |p, q| {
                    let corners = point.map(|point| vec![point, p, q]);
                    corners.map(WorkedMark::Area).into_iter().collect()
                };
                match number {
                    WorkedNumber::PlaneT | WorkedNumber::Sum => {
                        vec![WorkedMark::Area(vec![a, b, c])]
                    }
                    WorkedNumber::Share(0) => area(b, c),
                    WorkedNumber::Share(1) => area(c, a),
                    WorkedNumber::Share(_) => area(a, b),
                    _ => self.of_hit(number),
                }
            }
        }
    }

    fn of_hit(&self, number: WorkedNumber) -> Vec<WorkedMark> {
        let Some(hit) = self.worked.hit else {
            return Vec::new();
        };
        let point = hit.point_world;
        match number {
            WorkedNumber::Point | WorkedNumber::PointObject => vec![WorkedMark::Dot(point)],
            WorkedNumber::Normal | WorkedNumber::NormalObject => {
                // A tenth of the ray's length is seen from where the ray is.
                vec![WorkedMark::Arrow([
                    point,
                    point + 0.1 * hit.t_world * hit.normal_world,
                ])]
            }
            WorkedNumber::T => vec![WorkedMark::Line([self.worked.origin_world, point])],
            _ => Vec::new(),
        }
    }

    /// A face of the cube at a right angle to an axis.
    fn face(&self, axis: usize, side: f64) -> WorkedMark {
        let half = Cuboid::HALF_SIDE;
        let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
        let corner = |(u, v): (f64, f64)| {
            let mut corner = DVec3::ZERO;
            corner[axis] = side * half;
            corner[(axis + 1) % 3] = u;
            corner[(axis + 2) % 3] = v;
            self.placement.point_to_world(corner)
        };
        WorkedMark::Area(corners.map(corner).to_vec())
    }

    fn face_of_square(&self) -> WorkedMark {
        let half = Square::HALF_SIDE;
        let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
        let corner = |(x, y)| self.placement.point_to_world(DVec3::new(x, y, 0.0));
        WorkedMark::Area(corners.map(corner).to_vec())
    }
}
