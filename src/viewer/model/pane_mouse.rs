//! What the mouse does in one of the four views, and which point of the scene it means there.

use super::{
    action::Action,
    hits::RayHits,
    last_click::Cleared,
    stages::Stage,
    state::{Cursor, State},
};
use crate::{
    camera::{Projected, pixel_centre},
    pick::{self, Pick, PickLine, SceneHit},
};
use glam::{DVec2, DVec3};

/// A point is picked by the ray through its pixel's centre if that hits within this many pixel widths of the point's
/// depth, else by a ray through the point itself.
const SAME_DEPTH_PX: f64 = 8.0;

/// The point that is shown at every stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed {
    /// The index of its object.
    pub object: usize,
    /// Where it is in the object's space.
    pub point_object: DVec3,
    /// Whether it was clicked; otherwise it is under the cursor.
    pub is_picked: bool,
}

impl State {
    /// The point that is followed: the pick's, or else the cursor's.
    pub fn followed(&self) -> Option<Followed> {
        let of_pick = self.picked().map(|hit| (hit.id - 1, hit.point_object));
        let picked = of_pick.or_else(|| self.panes.as_ref()?.point);
        let (object, point_object) = picked.or_else(|| self.cursor?.hit)?;
        Some(Followed {
            object,
            point_object,
            is_picked: picked.is_some(),
        })
    }

    /// Where the followed point is in the world.
    pub fn followed_world(&self) -> Option<DVec3> {
        let followed = self.followed()?;
        let placement = &self.scene.objects().get(followed.object)?.placement;
        Some(placement.point_to_world(followed.point_object))
    }

    /// Where in the picture a point between near and far is; `None` outside.
    fn in_picture(&self, point_world: DVec3) -> Option<Projected> {
        let (view, lens) = (&self.view, self.view.camera.lens());
        let at = view.project(point_world)?;
        let is_between = (lens.near..lens.far).contains(&at.depth);
        (view.viewport.contains(at.px) && is_between).then_some(at)
    }

    /// Picks a point of an object through the scene's camera: casts the ray of its pixel and takes the hit at the
    /// point. Where there is no such hit, the object is selected and the point followed all the same.
    fn pick_point(&mut self, object: usize, point_object: DVec3) -> Option<PickLine> {
        let placement = &self.scene.objects()[object].placement;
        let world = placement.point_to_world(point_object);
        let (view, lens) = (self.view, self.view.camera.lens());
        if let Some(seen) = self.in_picture(world) {
            let px_wide =
                view.half_extent().y * lens.w(seen.depth) * 2.0 / f64::from(view.viewport.height());
            for px in [pixel_centre(seen.px), seen.px] {
                let hits = RayHits::cast(&self.scene, view, px, 0);
                let off = |pick: &Pick| (pick.depth - seen.depth).abs();
                let there = (hits.picks.iter().enumerate())
                    .filter(|(_, pick)| {
                        pick.id == object + 1 && off(pick) <= SAME_DEPTH_PX * px_wide
                    })
                    .min_by(|(_, a), (_, b)| off(a).total_cmp(&off(b)));
                if let Some((at, _)) = there {
                    let at = Some(at);
                    return Some(self.take_hits(RayHits { at, ..hits }));
                }
            }
        }
        self.select(Some(object));
        if let Some(panes) = &mut self.panes {
            panes.point = Some((object, point_object));
        }
        None
    }

    /// Before a click on nothing clears: keeps what it will clear, in case it begins a double click.
    fn keep_cleared(&mut self) {
        let cleared = Cleared {
            chosen: self.chosen.clone(),
            points: self.measuring.points.clone(),
            point: self.panes.as_ref().and_then(|panes| panes.point),
        };
        if let Some(click) = &mut self.last_click {
            click.cleared.get_or_insert(cleared);
        }
    }

    /// After a double click: restores what its first click cleared.
    fn restore_cleared(&mut self) {
        let Some(cleared) = self.last_click.take().and_then(|click| click.cleared) else {
            return;
        };
        self.chosen = cleared.chosen;
        self.measuring.points = cleared.points;
        if let Some(panes) = &mut self.panes {
            panes.point = cleared.point;
        }
    }

    /// Does an action of the mouse in a stage's view.
    pub(super) fn act_in(&mut self, stage: Stage, action: Action) -> Option<PickLine> {
        // What follows the mouse waits for no tree.
        let quick_hit = |px| Some(self.pane_hit(stage, pixel_centre(px))?.1);
        let hit = match action {
            _ if !self.rays_are_quick() => None,
            Action::BeginTurn(px) | Action::BeginPan(px) | Action::Zoom(px, _) => quick_hit(px),
            _ => None,
        };
        let hit = hit.and_then(|at| self.drawn_at(stage, at));
        match action {
            Action::Click(px, time_s) => {
                let point = self.pane_point(stage, px);
                let view = self.pane_view(stage)?;
                let again = self.clicks_again(&(Some(stage), pixel_centre(px), view), time_s);
                match point {
                    Some(_) if again && self.pick_ray().is_some() => return self.step(true),
                    Some((object, point)) => return self.pick_point(object, point),
                    None => {
                        self.keep_cleared();
                        self.select(None);
                    }
                }
            }
            Action::ClickAlso(px) => {
                if let Some((object, _)) = self.pane_point(stage, px) {
                    self.toggle_selected(object);
                }
            }
            Action::Recentre(_) => {
                self.show_views(self.views_with_other_size(stage));
                self.restore_cleared();
            }
            Action::Hover(px) => {
                let px = px.filter(|_| self.rays_are_quick());
                let hit = px.and_then(|px| self.pane_point(stage, px));
                self.cursor = hit.and_then(|(object, point)| {
                    let world = self.scene.objects()[object].placement.point_to_world(point);
                    Some(Cursor {
                        px: self.view.project(world)?.px,
                        hit,
                    })
                });
            }
            Action::ResetView => self.frame_pane(stage),
            _ => {
                let panes = self.panes.as_mut()?;
                panes.observers[stage as usize].act(action, hit);
            }
        }
        None
    }

    /// What a ray hits at a position of a stage's view, and the point that it hits in the scene that the stage shows.
    fn pane_hit(&self, stage: Stage, px: DVec2) -> Option<(SceneHit, DVec3)> {
        let (scene, view) = (self.pane_scene(stage)?, self.pane_view(stage)?);
        let ray = match stage {
            // A line here is a line in the world.
            Stage::Ndc => {
                let ndc = self.ndc();
                ndc.ray(&view.ray(px), ndc.back(&scene.visible_bounds()))?
            }
            _ => view.ray(px),
        };
        let hit = pick::closest(scene, ray, view.sides)?;
        Some((hit, ray.at(hit.hit.t)))
    }

    /// Where a stage draws a point of the scene that it shows.
    fn drawn_at(&self, stage: Stage, point: DVec3) -> Option<DVec3> {
        match stage {
            Stage::Ndc => self.ndc().drawn(point),
            _ => Some(self.drawn_to_scene(stage).inverse().transform_point3(point)),
        }
    }

    /// The object at a position of a stage's view, and the point there in its space.
    fn pane_point(&self, stage: Stage, px: DVec2) -> Option<(usize, DVec3)> {
        let (hit, point) = self.pane_hit(stage, pixel_centre(px))?;
        if stage == Stage::Object {
            return Some((self.pane_object()?, point));
        }
        let placement = &self.scene.objects().get(hit.object)?.placement;
        Some((hit.object, placement.point_to_object(point)))
    }
}
