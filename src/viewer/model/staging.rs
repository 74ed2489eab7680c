//! The four views: one scene and its one camera at each stage of the pipeline, each seen by an observer of its own.

use super::{
    four_views::Panes,
    observer::{Observer, Points},
    stages::{Stage, Views},
    state::State,
    viewing::with_frustum,
};
use crate::{
    camera::{NdcSpace, Orbit, UpAxis, View},
    geometry::{Aabb, Placement},
    scene::{Object, Scene},
};
use glam::{DAffine3, DMat3, DVec3};

impl State {
    /// What the window shows of the scene.
    pub fn views(&self) -> Views {
        match &self.panes {
            None => Views::Picture,
            Some(panes) => panes.large.map_or(Views::Four, Views::One),
        }
    }

    /// The stages on screen; none where the picture is.
    pub fn stages(&self) -> Vec<Stage> {
        match self.views() {
            Views::Picture => Vec::new(),
            Views::Four => Stage::ALL.map(|(stage, _)| stage).into(),
            Views::One(stage) => vec![stage],
        }
    }

    /// This one of the four views large, or, if one is large, all four again.
    pub(in crate::viewer) fn views_with_other_size(&self, stage: Stage) -> Views {
        match self.views() {
            Views::One(_) => Views::Four,
            _ => Views::One(stage),
        }
    }

    pub(super) fn show_views(&mut self, views: Views) {
        if views == Views::Picture {
            if self.panes.take().is_some() && self.frozen.is_some() {
                // The frozen camera shows again, so near and far must enclose it.
                self.fit();
            }
            return;
        }
        self.cursor = None;
        let large = match views {
            Views::One(stage) => Some(stage),
            _ => None,
        };
        if let Some(panes) = &mut self.panes {
            panes.large = large;
            return;
        }
        self.panes = Some(Box::new(Panes {
            large,
            entered: None,
            observers: Stage::ALL.map(|(stage, _)| self.observer(stage, &NdcSpace::FRUSTUM)),
            of: None,
            object: None,
            alone: Scene::default(),
            alone_of: None,
            point: None,
        }));
        self.refresh_panes();
    }

    /// After each change: brings the object that the views show up to date with scene and selection.
    pub(super) fn refresh_panes(&mut self) {
        let Some(mut panes) = self.panes.take() else {
            return;
        };
        let count = self.scene.objects().len();
        let is_there = |object: &usize| *object < count;
        let selected = self.selected();
        let before = panes.object;
        panes.object = selected
            .or(before.filter(|_| panes.of == Some(self.document)))
            .or_else(|| self.object_in_the_middle())
            .filter(is_there);
        panes.point = panes.point.filter(|(of, _)| selected == Some(*of));
        if let Some(object) = panes.object {
            // Its colour and shape change only with the scene; its placement is not shown.
            let of = Some((self.scene_revision, object));
            if panes.alone_of != of {
                let alone = Object {
                    placement: Placement::IDENTITY,
                    visible: true,
                    ..self.scene.objects()[object].clone()
                };
                (panes.alone, panes.alone_of) = (Scene::new(vec![alone]), of);
                let corners = with_axes(&panes.alone.bounds());
                panes.observers[Stage::Object as usize].frame(&corners);
            }
        }
        let is_of_another = panes.of.replace(self.document) != Some(self.document);
        self.panes = Some(panes);
        if is_of_another {
            for (stage, _) in Stage::ALL {
                self.frame_pane(stage);
            }
        }
    }

    /// The object in the middle of the camera's picture, else the first that is visible.
    fn object_in_the_middle(&self) -> Option<usize> {
        let ray = self.view.ray(self.view.viewport.size_px() / 2.0);
        let hit = self.quick_hit(&ray).map(|hit| hit.object);
        hit.or_else(|| {
            let mut objects = self.scene.objects().iter();
            objects.position(|object| object.visible)
        })
    }

    /// The object whose space the object view shows.
    pub fn pane_object(&self) -> Option<usize> {
        self.panes.as_ref()?.object
    }

    /// The box about an object in its own space; empty unless the object view shows it.
    pub fn object_bounds(&self, object: usize) -> Aabb {
        match &self.panes {
            Some(panes) if panes.object == Some(object) => panes.alone.bounds(),
            _ => Aabb::EMPTY,
        }
    }

    /// The camera's NDC.
    pub fn ndc(&self) -> NdcSpace {
        NdcSpace { of: self.view }
    }

    /// The scene that a stage shows: one object, or the whole. `None` while the views are closed.
    pub(super) fn pane_scene(&self, stage: Stage) -> Option<&Scene> {
        let panes = self.panes.as_ref()?;
        Some(match stage {
            Stage::Object => &panes.alone,
            Stage::World | Stage::View | Stage::Ndc => &self.scene,
        })
    }

    fn bounds_with_camera(&self) -> Aabb {
        with_frustum(self.scene.visible_bounds(), self.view)
    }

    /// The view of a stage's observer: in the object's space, in the world (that of the view stage, too), or in NDC.
    /// `None` while the views are closed.
    pub fn pane_view(&self, stage: Stage) -> Option<View> {
        let panes = self.panes.as_ref()?;
        let bounds = match stage {
            Stage::Object => panes.alone.bounds(),
            Stage::World | Stage::View => self.bounds_with_camera(),
            Stage::Ndc => {
                let drawn = self.ndc().drawn_box(&self.scene.visible_bounds());
                drawn.union(NdcSpace::FRUSTUM)
            }
        };
        let observer = &panes.observers[stage as usize];
        let view = observer.view(&self.drawn_to_scene(stage), &bounds, self.view.sides)?;
        // A lone object is shown whole. NDC is cut as the camera's view is.
        let section = match stage {
            Stage::World | Stage::View => self.view.section,
            Stage::Object | Stage::Ndc => None,
        };
        Some(View { section, ..view })
    }

    /// From the right-handed space that a stage is drawn in to that of its observer's view. View space is left-handed,
    /// (right, up, forward), and is drawn as (right, up, backward): the same places in other coordinates.
    pub(super) fn drawn_to_scene(&self, stage: Stage) -> DAffine3 {
        let camera = &self.view.camera;
        match stage {
            Stage::View => DAffine3::from_mat3_translation(
                DMat3::from_cols(camera.right(), camera.up(), -camera.forward()),
                camera.eye(),
            ),
            _ => DAffine3::IDENTITY,
        }
    }

    /// An observer who sees all of a stage.
    fn observer(&self, stage: Stage, object: &Aabb) -> Observer {
        let camera = &self.view.camera;
        let panes = self.panes.as_ref();
        let viewport = panes.map_or(self.view.viewport, |panes| {
            panes.observers[stage as usize].viewport
        });
        let to_drawn = self.drawn_to_scene(stage).inverse();
        // The scene, the frustum and its eye.
        let mut points = corners_of(&self.scene.visible_bounds());
        points[..8].copy_from_slice(&self.view.frustum_corners());
        points[8] = camera.eye();
        let points = points.map(|point| to_drawn.transform_point3(point));
        let up = self.rig.up_axis;
        let (up_axis, from, points) = match stage {
            Stage::Object => (up, Orbit::FROM, corners_of(object)),
            Stage::World => (up, self.beside_camera(), points),
            Stage::View => (UpAxis::Y, DVec3::new(1.2, 0.7, 0.8), points),
            Stage::Ndc => (
                UpAxis::Y,
                DVec3::new(0.8, 0.6, 1.5),
                corners_of(&NdcSpace::FRUSTUM),
            ),
        };
        Observer::new(up_axis, from, &points, viewport)
    }

    /// The camera's picture has a new shape: views that the user has not moved show all of the camera's frustum again.
    pub(super) fn frame_untouched(&mut self) {
        for (stage, _) in Stage::ALL {
            let is_untouched = |panes: &Panes| panes.observers[stage as usize].is_untouched();
            if self.panes.as_deref().is_some_and(is_untouched) {
                self.frame_pane(stage);
            }
        }
    }

    /// Shows all of a stage, from the direction it was seen from at first.
    pub(super) fn frame_pane(&mut self, stage: Stage) {
        let Some(panes) = &self.panes else { return };
        let observer = self.observer(stage, &panes.alone.bounds());
        if let Some(panes) = &mut self.panes {
            panes.observers[stage as usize] = observer;
        }
    }
}

/// The corners of a box, grown to leave room for axes.
fn with_axes(bounds: &Aabb) -> Points {
    corners_of(&bounds.grown(DVec3::splat(0.25 * bounds.radius())))
}

/// A box's corners as the last eight points; the first nine repeat a corner. An empty box counts as [-1, 1] on each
/// axis.
fn corners_of(bounds: &Aabb) -> Points {
    let corners = bounds.or_unit().corners();
    std::array::from_fn(|i| corners[i.saturating_sub(9) % 8])
}
