//! Going to a face or vertex by its number in the file, and marking it.

use super::{hits::RayHits, sought::Sought, state::State};
use crate::{
    camera::Projected,
    pick::{NamedSurface, Pick, PickLine, Sight, sight},
    scene::Shape,
};
use glam::DVec3;

/// In `f64`, a ray at a vertex may miss all of its triangles. So rays are tried at these shares of the way from the
/// vertex to the middle of one triangle.
const ASIDE: [f64; 3] = [0.0, 1.0 / 16_777_216.0, 1.0 / 4096.0];

impl State {
    /// The marked face or vertex, where it stands now.
    pub fn sought(&self) -> Option<Sought> {
        let sought = self.sought?;
        let placement = &self.scene.objects().get(sought.object)?.placement;
        let point = sought.point.placed_by(placement);
        Some(Sought { point, ..sought })
    }

    /// Whether the view on screen shows the mark, decided exactly; `None` where nothing is marked, or while rays are
    /// slow.
    pub fn sight_of_sought(&self) -> Option<Sight> {
        let sought = self.sought().filter(|_| self.rays_are_quick())?;
        Some(sight(&self.scene, &self.view, &sought.point))
    }

    /// [`Self::sight_of_sought`] in words.
    pub fn says_of_sought(&self) -> Option<String> {
        Some(match self.sight_of_sought()? {
            Sight::Hidden(hit) => {
                let by = NamedSurface::of(&self.scene, &hit);
                let triangle =
                    (by.triangle).map_or_else(String::new, |n| format!(", triangle {n}"));
                format!("hidden by {}{triangle}", by.object)
            }
            Sight::Seen(_) => match self.in_picture(self.sought()?.point.world()) {
                Some(at) => format!("seen at {:.2}, {:.2}", at.px.x, at.px.y),
                None => "outside the picture".to_owned(),
            },
            Sight::NotShown => self.why_not_shown()?.to_owned(),
        })
    }

    fn why_not_shown(&self) -> Option<&'static str> {
        let Sought { object, point, .. } = self.sought()?;
        let (point_world, lens) = (point.world(), self.view.camera.lens());
        let depth = self.view.camera.to_view(point_world).z;
        let section = self.view.section;
        Some(if !self.scene.objects()[object].visible {
            "its object is hidden"
        } else if depth < lens.near {
            "in front of the near plane"
        } else if depth >= lens.far {
            "beyond the far plane"
        } else if section.is_some_and(|section| section.side(point_world) < 0.0) {
            "cut away by the section"
        } else {
            "not shown: its faces are culled or seen edge-on"
        })
    }

    /// Marks a face or vertex, and centres the view on it where it is outside the picture. Picks its triangle; where no
    /// ray hits that, its object is selected, and an earlier pick on the same object stays.
    pub(super) fn go_to(&mut self, sought: Sought) -> Option<PickLine> {
        self.sought = Some(sought);
        let Sought { object, point, .. } = self.sought()?;
        let point_world = point.world();
        if self.in_picture(point_world).is_none() {
            self.pivot_world = point_world;
            self.orbit.center_on(point_world, self.orbit.distance());
            self.moved();
        }
        let hits = self.pick_of(&sought, point_world);
        let line = hits.and_then(|hits| self.take_hits(hits));
        if self.selected() != Some(object) {
            self.select(Some(object));
        }
        if let Some(panes) = &mut self.panes {
            panes.point = Some((object, point.object()));
        }
        self.sought = Some(sought);
        line
    }

    /// Where in the picture a point between near and far is; `None` outside.
    pub(super) fn in_picture(&self, point_world: DVec3) -> Option<Projected> {
        let (view, lens) = (&self.view, self.view.camera.lens());
        let at = view.project(point_world)?;
        let is_between = (lens.near..lens.far).contains(&at.depth);
        (view.viewport.contains(at.px) && is_between).then_some(at)
    }

    /// The hits on a ray at the point, or next to it, that meets the sought triangle. That triangle is the picked one.
    fn pick_of(&self, sought: &Sought, point_world: DVec3) -> Option<RayHits> {
        let at = self.in_picture(point_world)?.px;
        let object = &self.scene.objects()[sought.object];
        let Shape::Mesh { mesh, .. } = &object.shape else {
            return None;
        };
        let corners = mesh.corners(object.shape.first_triangle() + sought.triangle);
        let middle = corners.iter().sum::<DVec3>() / 3.0;
        let middle = object.placement.point_to_world(middle);
        let middle = self.view.project(middle).map_or(at, |middle| middle.px);
        let name = (sought.object + 1, Some(sought.triangle));
        let is_it = |pick: &Pick| (pick.id, pick.triangle) == name;
        ASIDE.into_iter().find_map(|share| {
            let px = at + share * (middle - at);
            let hits = RayHits::cast(&self.scene, self.view, px, 0);
            let at = hits.picks.iter().position(is_it)?;
            Some(RayHits { at, ..hits })
        })
    }
}
