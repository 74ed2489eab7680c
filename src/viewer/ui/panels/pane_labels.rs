//! Writes and draws over one of the four views: the followed point with its ray and pixel, the camera's eye and planes,
//! axes, corners, and what a row of a matrix does.

use super::{
    field::{point, short},
    pane_page::Page,
    prelude::*,
};
use crate::{
    camera::{DepthMapping, NdcSpace, View},
    look,
    viewer::model::{Stage, Steps},
};
use glam::DVec2;

/// The corners of a view that names keep clear of, with their sizes: its heading, and its cross of axes.
const CORNERS: [(Align2, Vec2); 2] = [
    (Align2::LEFT_TOP, vec2(10_000.0, 34.0)),
    (Align2::LEFT_BOTTOM, vec2(92.0, 92.0)),
];

/// Shown over a view's rectangle. `seen` is the view that the picture at `place` is drawn through.
pub(super) fn show(
    ui: &mut Ui,
    stage: Stage,
    rect: Rect,
    place: SceneRect,
    state: &State,
    seen: &View,
) {
    let corner =
        |(align, size): (Align2, Vec2)| align.align_size_within_rect(size.min(rect.size()), rect);
    let mut page = Page {
        ui,
        rect,
        place,
        seen,
        stage,
        state,
        names: Vec::new(),
    };
    page.lit_row();
    page.followed();
    page.example();
    match stage {
        Stage::Object => page.object_axes(),
        Stage::World | Stage::View => page.camera(),
        Stage::Ndc => page.corners(),
    }
    page.write(CORNERS.map(corner).into());
}

impl Page<'_> {
    /// The followed point with its numbers at this stage, the ray that its pixel casts, and the pixel.
    fn followed(&mut self) {
        let (state, colour) = (self.state, color32(look::SELECTION));
        let (Some(followed), Some(world)) = (state.followed(), state.followed_world()) else {
            return;
        };
        let object = &state.scene().objects()[followed.object];
        let steps = Steps::follow(state.view(), object, followed.point_object);
        if let Some(steps) = steps {
            // Uncut: a section decides what is hit, but not where the pixel is.
            let ray = state.view().uncut().ray(steps.px);
            let near = ray.at(ray.t_min);
            let begin = if self.stage == Stage::Ndc {
                near
            } else {
                ray.origin
            };
            let ends = (self.at_stage(begin), self.at_stage(ray.at(ray.t_max)));
            if let (Some(from), Some(to)) = ends {
                self.line(from, to, 1.5, colour);
            }
            if state.view().viewport.contains(steps.px)
                && self.stage != Stage::Object
                && let Some(at) = self.at_stage(near)
            {
                self.dot(at, 3.0, colour);
                if !self.is_small() {
                    let DVec2 { x, y } = steps.px.floor();
                    self.name(at, format!("pixel {x}, {y}"), colour, "the pixel that shows the point, counted from the top left corner; drawn where its ray crosses the near plane");
                }
            }
        }
        if self.stage == Stage::Object && state.pane_object() != Some(followed.object) {
            return;
        }
        let numbers = match (self.stage, steps) {
            (Stage::Object, _) => Some(followed.point_object),
            (Stage::World, _) => Some(world),
            (Stage::View, Some(steps)) => Some(steps.view),
            (Stage::Ndc, Some(steps)) => Some(steps.ndc),
            (_, None) => None,
        };
        let (Some(at), Some(DVec3 { x, y, z })) = (self.at_stage(world), numbers) else {
            return;
        };
        self.dot(at, 4.5, colour);
        self.dot(at, 1.5, Color32::BLACK);
        let [x, y, z] = [x, y, z].map(|value| format!("{value:.3}"));
        let hint = "the followed point in this view's own coordinates: the same point in all four";
        self.name(at, format!("({x}, {y}, {z})"), colour, hint);
    }

    /// The point that the tour works out.
    fn example(&mut self) {
        let example = self.state.example().filter(|_| self.stage != Stage::Object);
        let Some(example) = example else { return };
        let numbers = match self.stage {
            Stage::Ndc => example.ndc,
            _ => example.view,
        };
        if let Some(at) = self.at_stage(example.world) {
            self.dot(at, 4.5, Color32::WHITE);
            let hint = "the tour's point, in view space, and in NDC";
            self.name(at, point(numbers), Color32::WHITE, hint);
        }
    }

    /// The object's own axes. They start at its origin, or at a corner of its box if the origin is far from it.
    fn object_axes(&mut self) {
        let Some(object) = self.state.pane_object() else {
            return;
        };
        let bounds = self.state.object_bounds(object);
        let radius = bounds.radius();
        let is_near = bounds.center().length() <= 3.0 * radius;
        let origin = if is_near { DVec3::ZERO } else { bounds.min };
        let axes = DVec3::AXES.map(|axis| 0.75 * radius * axis);
        let hint = "an axis of the object's own space";
        self.axes(origin, axes, Some(["x", "y", "z"]), hint);
    }

    /// Three axes as arrows from a point, and their names.
    fn axes(
        &mut self,
        from: DVec3,
        axes: [DVec3; 3],
        names: Option<[&str; 3]>,
        hint: &'static str,
    ) {
        for (i, axis) in axes.into_iter().enumerate() {
            let (to, colour) = (from + axis, color32(look::AXES[i]));
            self.arrow(from, to, colour);
            if let Some(names) = names {
                self.name(to, names[i], colour, hint);
            }
        }
    }

    /// The scene's camera: its eye, its axes and its planes.
    fn camera(&mut self) {
        let view = self.state.view();
        let (camera, lens) = (&view.camera, view.camera.lens());
        let colour = color32(look::CAMERA);
        let corners = view.frustum_corners();
        let eye = camera.eye();
        self.dot(eye, 3.5, colour);
        self.name(eye, "eye", colour, "where the scene's camera stands");
        let near = format!("near {}", short(lens.near));
        let hint = "the near plane: its depth is the panel's near";
        self.name(self.outermost(&corners[..4], &corners), near, colour, hint);
        let far = format!("far {}", short(lens.far));
        let hint = "the far plane: its depth is the panel's far";
        self.name(self.outermost(&corners[4..], &corners), far, colour, hint);
        let size = 0.2 * self.state.scene().visible_bounds().radius();
        // A point has no radius; that of nothing is infinite.
        let has_size = size > 0.0 && size.is_finite();
        let size = if has_size { size } else { 0.1 * lens.far };
        let names = match self.stage {
            Stage::View => ["x right", "y up", "z forward = depth"],
            _ => ["R", "U", "F, depth"],
        };
        let axes = [camera.right(), camera.up(), camera.forward()].map(|axis| size * axis);
        let hint = "an axis of the camera: view space measures along it";
        self.axes(eye, axes, (!self.is_small()).then_some(names), hint);
    }

    /// The box of NDC: the numbers of its corners, and its axes.
    fn corners(&mut self) {
        let ([near, far], origin, z) = match self.state.view().camera.lens().depth {
            DepthMapping::Reversed => ([1, 0], DVec3::NEG_Z, DVec3::Z),
            DepthMapping::Standard => ([0, 1], DVec3::ZERO, DVec3::NEG_Z),
        };
        let is_small = self.is_small();
        let names = (!is_small).then_some(["x", "y", "z = depth"]);
        let axes = [DVec3::X, DVec3::Y, z].map(|axis| 0.5 * axis);
        self.axes(origin, axes, names, "an axis of NDC, from its origin");
        let colour = color32(look::CAMERA);
        for (name, number, z) in [("near", near, 0.0), ("far", far, -1.0)] {
            let (at, text) = (DVec3::new(0.0, 1.0, z), format!("{name}: z = {number}"));
            self.name(at, text, colour, "what the frustum's plane becomes");
        }
        for at in NdcSpace::FRUSTUM
            .corners()
            .into_iter()
            .filter(|_| !is_small)
        {
            let number = if at.z == 0.0 { near } else { far };
            let text = format!("({}, {}, {number})", at.x, at.y);
            let hint = "a corner of the box that the frustum becomes";
            self.name(at, text, colour, hint);
        }
    }
}
