//! Shows in the four views what a row of a matrix does, while the cursor rests on the row: its planes, axis or length.

use super::{pane_page::Page, prelude::*};
use crate::{
    camera::NdcSpace,
    viewer::model::{Matrix, Stage},
};

/// White. No area of another colour is filled.
const COLOUR: Color32 = Color32::from_rgb(255, 255, 255);
/// Corners of the frustum that bound the two planes of each row of P: left and right, bottom and top, near and far.
const PLANES: [[[usize; 4]; 2]; 3] = [
    [[0, 4, 7, 3], [1, 5, 6, 2]],
    [[3, 7, 6, 2], [0, 4, 5, 1]],
    [[0, 1, 2, 3], [4, 5, 6, 7]],
];

impl Page<'_> {
    /// Shows what the row under the cursor does at this stage.
    pub fn lit_row(&self) {
        match self.state.row() {
            Some((Matrix::Projection, row)) if row < 3 => self.planes(row),
            Some((Matrix::Projection, _)) => self.w(),
            Some((Matrix::View, row)) => self.along_camera(row),
            Some((Matrix::Model, row)) => self.along_world(row),
            None => {}
        }
    }

    /// The planes where the coordinate that a row of P makes is -w or w; for the third row 0 or w.
    fn planes(&self, row: usize) {
        let view = self.state.view();
        let corners = match self.stage {
            Stage::Object => return,
            Stage::World | Stage::View => view.frustum_corners(),
            Stage::Ndc => {
                let around = [(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
                let face = |z| around.map(|(x, y)| DVec3::new(x, y, z));
                let [near, far] = [NdcSpace::FRUSTUM.max.z, NdcSpace::FRUSTUM.min.z].map(face);
                std::array::from_fn(|i| if i < 4 { near[i] } else { far[i - 4] })
            }
        };
        for plane in PLANES[row] {
            self.area(&plane.map(|corner| corners[corner]), COLOUR);
        }
    }

    /// The depth of the followed point, which becomes w.
    fn w(&self) {
        let camera = &self.state.view().camera;
        if camera.lens().is_orthographic() || !matches!(self.stage, Stage::World | Stage::View) {
            return;
        }
        let depth = self.followed_or(camera.lens().far, |point| camera.to_view(point).z);
        let eye = camera.eye();
        self.line(eye, eye + depth * camera.forward(), 4.0, COLOUR);
    }

    fn followed_or(&self, otherwise: f64, length: impl Fn(DVec3) -> f64) -> f64 {
        self.state.followed_world().map_or(otherwise, length)
    }

    /// How far the followed point lies along an axis of the camera.
    fn along_camera(&self, row: usize) {
        let camera = &self.state.view().camera;
        let axes = [camera.right(), camera.up(), camera.forward()];
        let eye = camera.eye();
        if !matches!(self.stage, Stage::World | Stage::View) {
            return;
        }
        let Some(axis) = axes.get(row) else {
            return self.dot(eye, 7.0, COLOUR);
        };
        let along = self.followed_or(camera.lens().near, |point| camera.to_view(point)[row]);
        self.along(eye, eye + along * *axis);
    }

    /// A length along an axis, and from its end to the followed point.
    fn along(&self, from: DVec3, to: DVec3) {
        self.line(from, to, 4.0, COLOUR);
        if let Some(point) = self.state.followed_world() {
            self.line(to, point, 1.0, COLOUR);
        }
    }

    /// How far the followed point lies along an axis of the world; in object space, the direction in which that length
    /// grows.
    fn along_world(&self, row: usize) {
        let Some(object) = self.state.pane_object() else {
            return;
        };
        let model = self.state.scene().objects()[object].placement.model();
        let radius = self.state.scene().bounds_of(object).radius();
        match self.stage {
            Stage::Object if row < 3 => {
                let grows = model.matrix3.row(row).normalize_or_zero();
                let radius = self.state.object_bounds(object).radius();
                self.line(DVec3::ZERO, 1.2 * radius * grows, 4.0, COLOUR);
            }
            Stage::Object | Stage::World if row >= 3 => {
                if let Some(at) = self.at_stage(model.translation) {
                    self.dot(at, 7.0, COLOUR);
                }
            }
            Stage::World => {
                let along = self.followed_or(radius, |point| point[row]);
                self.along(DVec3::ZERO, along * DVec3::AXES[row]);
            }
            _ => {}
        }
    }
}
