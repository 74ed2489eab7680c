//! Transforms points of objects to view space, with all digits that `f32` may need.

use super::{
    rounding::U,
    view_units::{depth_origin, view_unit},
};
use crate::{
    camera::View,
    geometry::{
        Placement,
        double_double::{DoubleDouble, Rows},
        vector::V3,
    },
};
use glam::{DMat3, DVec2, DVec3};

/// View space in double-double, for points that are too far from the eye or the origin for `f64`.
///
/// The camera's stored axes are unit vectors only to within rounding. View coordinates count along these axes as they
/// are stored, so that a point lies on the ray that a pick casts through its pixel.
#[derive(Clone, Copy, Debug)]
pub struct ViewSpace {
    view: View,
    unit: f64,
    to_view: Rows<DoubleDouble>,
}

/// A point in view space, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewPoint {
    /// Right and up.
    pub aside: DVec2,
    /// Depth from the eye.
    pub depth: f64,
    /// Depth from the near plane, which keeps digits where `depth` has none left.
    pub past_near: f64,
    /// Depth from [`depth_origin`].
    pub buffer_depth: f64,
}

impl ViewSpace {
    /// View space of a view.
    pub fn new(view: &View) -> Self {
        let camera = &view.camera;
        let axes = DMat3::from_cols(camera.right(), camera.up(), camera.forward());
        Self {
            view: *view,
            unit: view_unit(view),
            to_view: Rows::inverse_of(axes),
        }
    }

    /// Its view.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// View units per world unit.
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// An object's point `origin + point_vertex_space`, both in object space.
    pub fn at(&self, placement: &Placement, origin: DVec3, point_vertex_space: DVec3) -> ViewPoint {
        let camera = &self.view.camera;
        let model = placement.model();
        let V3 { x, y, z } = V3::<DoubleDouble>::from(origin) + point_vertex_space.into();
        let column = |i: usize| V3::<DoubleDouble>::from(model.matrix3.col(i));
        let turned = column(0) * x + column(1) * y + column(2) * z;
        let eye_to_origin = V3::from(model.translation) - camera.eye().into();
        let V3 { x, y, z } = self.to_view.times(turned + eye_to_origin);
        ViewPoint {
            aside: DVec2::new(x.into(), y.into()),
            depth: z.into(),
            past_near: (z - camera.lens().near.into()).into(),
            buffer_depth: (z - depth_origin(&self.view).into()).into(),
        }
    }

    /// The linear part of View * Model, less `rounded`.
    pub fn linear_less(&self, placement: &Placement, rounded: DMat3) -> DMat3 {
        let model = placement.model().matrix3;
        let column = |i: usize| {
            let exact = self.to_view.times(model.col(i).into());
            (exact - rounded.col(i).into()).rounded()
        };
        DMat3::from_cols(column(0), column(1), column(2))
    }

    /// [`ViewSpace::at`], in `f64` where that is fine enough for `f32` results: where rounding errors of numbers as
    /// large as the point's and the eye's coordinates are far below a pixel and a step of depth.
    pub(super) fn at_quickly(
        &self,
        placement: &Placement,
        origin: DVec3,
        point: DVec3,
    ) -> ViewPoint {
        let camera = &self.view.camera;
        let lens = camera.lens();
        let from_origin = placement.model().matrix3 * (origin + point);
        let eye_to_origin = placement.model().translation - camera.eye();
        let view = camera.rotation() * (from_origin + eye_to_origin);
        let largest = from_origin.abs() + placement.model().translation.abs() + camera.eye().abs();
        let largest = largest.max_element();
        let half_height = camera.half_height() * lens.w(view.z.abs());
        let pixel = 2.0 * half_height / f64::from(self.view.viewport.height());
        let step = 2.0 * U * (lens.far - lens.near).min(view.z.abs().max(lens.near.abs()));
        let finest = (pixel / 4096.0).min(step / 16.0);
        if 16.0 * f64::EPSILON * largest > finest {
            return self.at(placement, origin, point);
        }
        ViewPoint {
            aside: view.truncate(),
            depth: view.z,
            past_near: view.z - lens.near,
            buffer_depth: view.z - depth_origin(&self.view),
        }
    }
}
