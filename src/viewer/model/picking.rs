//! Clicks, the cursor, and the surfaces on a click's ray; in the gallery, clicks picked by a method of the study.

use super::{
    chosen::Chosen,
    hits::{PickView, RayHits},
    in_gallery::Compared,
    last_click::{LastClick, Place},
    measuring::MeasuredPoint,
    on_screen::Seen,
    state::{Cursor, State},
};
use crate::{
    camera::{View, pixel_centre},
    pick::{self, Pick, PickLine, SceneHit},
    scene::obj::InFile,
    study::swap::Swap,
};
use glam::DVec2;

impl State {
    /// Selects what lies at a pixel: the nearest surface, or, for another click on the same pixel of the same picture,
    /// the next one behind. The second click of a double click selects the nearest again.
    pub(super) fn click(&mut self, px: DVec2, time_s: f64) -> PickLine {
        let px = pixel_centre(px);
        let view = self.clicked_view();
        let again = self.clicks_again(&(None, px, view), time_s);
        let last = self.hits().and_then(|hits| hits.at).filter(|_| again);
        let at = last.map_or(0, |at| at + 1);
        self.take_hits(RayHits::cast(&self.scene, view, px, at))
    }

    /// Selects what lies at the middle of an object in the view as it is, on screen or not. Does nothing where no object
    /// has this name, or where it is not in view.
    pub(in crate::viewer) fn pick_middle_of(&mut self, name: &str) {
        let objects = self.scene.objects();
        let Some(object) = objects.iter().position(|object| object.name == name) else {
            return;
        };
        let seen = self.view.project(self.scene.bounds_of(object).center());
        if let Some(seen) = seen.filter(|seen| self.view.viewport.contains(seen.px)) {
            self.take_hits(RayHits::cast(
                &self.scene,
                self.view,
                pixel_centre(seen.px),
                0,
            ));
        }
    }

    /// Notes a click. Returns whether it is on the same pixel of the same view as the click before, and not the second
    /// of a double click.
    pub(super) fn clicks_again(&mut self, place: &Place, time_s: f64) -> bool {
        let (click, is_again) = LastClick::after(self.last_click.take(), place, time_s);
        self.last_click = Some(click);
        is_again
    }

    /// Adds the object at a pixel to what is selected, or takes it out. In the gallery, only while Sightline's own
    /// method picks.
    pub(super) fn click_also(&mut self, px: DVec2) {
        let view = self.clicked_view();
        let ray = view.ray(pixel_centre(px));
        let hit = pick::closest(&self.scene, ray, view.sides);
        if let (Some(hit), None) = (hit, self.method()) {
            self.toggle_selected(hit.object);
        }
    }

    /// The ray that made the pick, with its view, for copies that repeat it. A click on nothing counts while its view
    /// is on screen.
    pub fn pick_ray(&self) -> Option<&RayHits> {
        let ray = self.hits()?;
        let counts = match self.selection() {
            Some(_) => ray.at.is_some(),
            None => ray.picks.is_empty() && ray.view == self.view,
        };
        counts.then_some(ray)
    }

    /// How the view on screen shows the pick; `None` where no surface is picked.
    pub fn pick_view(&self) -> Option<PickView> {
        self.pick_ray()?.seen_in(&self.view)
    }

    /// Whether another surface is in front of the picked point in the view on screen; `false` while rays are slow.
    pub fn pick_is_hidden(&self) -> bool {
        /// A surface whose depth is this near to the point's is the point's own: it lies in its pixel's middle.
        const SAME: f64 = 1e-6;
        // In its own view the nearest surface on its ray is hidden by none.
        let is_nearest = |ray: &&RayHits| ray.at == Some(0) && ray.view == self.view;
        let asked = self.hits().filter(|ray| !is_nearest(ray));
        let pick = asked.and_then(RayHits::pick);
        let seen = pick.and_then(|pick| self.view.project(pick.point_world));
        seen.is_some_and(|seen| {
            let hit = self.quick_hit(&self.view.ray(seen.px));
            hit.is_some_and(|hit| seen.depth - hit.hit.t > SAME * seen.depth.abs())
        })
    }

    pub(super) fn cursor_at(&self, px: DVec2) -> Cursor {
        let px = pixel_centre(px);
        let ray = self.view.ray(px);
        let is_seen = self.seen != Seen::Nothing;
        let hit = is_seen.then(|| self.quick_hit(&ray));
        let point = |hit: SceneHit| {
            let placement = &self.scene.objects()[hit.object].placement;
            (hit.object, placement.ray_to_object(&ray).at(hit.hit.t))
        };
        Cursor {
            px,
            hit: hit.flatten().map(point),
        }
    }

    /// Makes one of a ray's surfaces the pick.
    pub(super) fn take_hits(&mut self, hits: RayHits) -> PickLine {
        let line = hits.line();
        // While clicks snap, the point that is measured is known later.
        if let Some(hit) = line.hit.as_ref().filter(|_| !self.measuring.is_on) {
            let last = self.measuring.points.last();
            if last.map(|last| last.point_world) != Some(hit.point_world) {
                self.measuring.take(MeasuredPoint {
                    object: hit.object.clone(),
                    point_world: hit.point_world,
                    snap: None,
                    object_area: None,
                });
            }
        }
        self.chosen = Chosen {
            hits: Some(hits),
            ..Chosen::object(line.hit.as_ref().map(|hit| hit.id - 1))
        };
        line
    }

    /// Picks another surface on the last click's ray, counted from the front.
    pub(super) fn step_to(&mut self, at: usize) -> Option<PickLine> {
        let hits = (self.chosen.hits).take_if(|hits| at < hits.picks.len())?;
        let at = Some(at);
        Some(self.take_hits(RayHits { at, ..hits }))
    }

    /// Picks the next surface on the last click's ray, or the one before, in a ring.
    pub(super) fn step(&mut self, forward: bool) -> Option<PickLine> {
        let hits = self.hits().filter(|hits| !hits.picks.is_empty())?;
        let last = hits.picks.len() - 1;
        let (from, by) = if forward { (last, 1) } else { (0, last) };
        self.step_to((hits.at.unwrap_or(from) + by) % (last + 1))
    }

    /// A view with near and far fitted to the scene as it is now.
    fn refitted(&self, view: View) -> View {
        let (mut lens, controls) = (*view.camera.lens(), self.controls);
        (lens.near, lens.far) = self.planes(&view, &controls);
        let camera = view.camera.with_lens(lens).unwrap_or(view.camera);
        View { camera, ..view }
    }

    /// Adds to the pick what the file says about it.
    pub(in crate::viewer) fn learn(&mut self, in_file: &InFile) {
        if let Some(hits) = &mut self.chosen.hits
            && let Some(at) = hits.at
        {
            hits.picks[at].in_file = in_file.clone();
        }
    }

    /// The scene changed: casts the last click's ray again and picks what it hits of the selected object now. A pick
    /// made in `before`, the view on screen until now, moves to the present view.
    pub(super) fn repick(&mut self, before: &View) {
        let Some(old) = self.chosen.hits.take() else {
            return;
        };
        let view = if old.view == *before {
            self.view
        } else {
            self.refitted(old.view)
        };
        let mut hits = RayHits::cast(&self.scene, view, old.px, 0);
        // The object's first hit that is front or back as the old one was, else its first hit.
        let of_selected = |pick: &Pick| Some(pick.id - 1) == self.selected();
        let front = old.pick().is_none_or(|pick| pick.front);
        let alike = |pick: &Pick| of_selected(pick) && pick.front == front;
        let mut picks = hits.picks.iter();
        hits.at = (picks.position(alike)).or_else(|| hits.picks.iter().position(of_selected));
        self.chosen.hits = Some(hits);
    }

    /// Sets the method that picks, `None` for Sightline's own, and repeats the last click by it.
    pub(super) fn pick_by(&mut self, method: Option<Swap>) {
        let Some(showing) = &mut self.showing else {
            return;
        };
        showing.method = method;
        let compared = showing.compared.take().map(|compared| compared.px);
        let picked = self.hits().filter(|hits| hits.at.is_some());
        let px = compared.or_else(|| Some(picked?.px));
        match px {
            Some(px) if self.method().is_some() => self.compare(px),
            Some(px) => drop(self.click(px, 0.0)),
            None => {}
        }
        // The next click there picks the nearest surface again.
        self.last_click = None;
    }

    /// A click by the method that is set. The object that it finds is selected, right or wrong, but not as a pick of
    /// Sightline's.
    pub(super) fn compare(&mut self, px: DVec2) {
        let Some(method) = self.method() else { return };
        let compared = Compared::at(&self.scene, &self.view, &method, px);
        self.chosen = Chosen::object(compared.theirs.map(|found| found.hit.object));
        if let Some(showing) = &mut self.showing {
            showing.compared = Some(compared);
        }
    }
}
