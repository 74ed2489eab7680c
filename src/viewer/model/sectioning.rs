//! The section in the window: where it can be laid, and how it is turned off and on. The view holds it.

use super::state::State;
use crate::{
    camera::SectionChoice,
    geometry::{Cuboid, Section},
    scene::Shape,
};
use glam::DVec3;

impl State {
    /// Whether there can be a section: not in the gallery, whose scenes stay as they are.
    pub fn takes_sections(&self) -> bool {
        self.showing.is_none()
    }

    /// A section across an axis of the world, through the middle of what is visible, that cuts away the eye's side.
    pub fn section_across(&self, axis: DVec3) -> Option<Section> {
        let bounds = self.scene.visible_bounds();
        if bounds.is_empty() {
            return None;
        }
        let middle = bounds.center();
        let is_before = (self.view.camera.eye() - middle).dot(axis) > 0.0;
        // Adding 0 turns -0 into 0.
        let normal = if is_before { -axis } else { axis } + DVec3::ZERO;
        Section::through(middle, normal).ok()
    }

    /// The picked face, where it is flat.
    pub fn picked_face(&self) -> Option<SectionChoice> {
        let pick = self.picked()?;
        let face = match &self.scene.objects().get(pick.id - 1)?.shape {
            Shape::Sphere => return None,
            Shape::Square => None,
            Shape::Cube => {
                let is_it = |normal: &DVec3| normal.dot(pick.normal_object) > 0.5;
                let face = Cuboid::NORMALS.iter().position(is_it)?;
                Some(u32::try_from(face).ok()?)
            }
            Shape::Mesh { .. } => Some(pick.triangle?),
        };
        Some(SectionChoice::Face { id: pick.id, face })
    }

    /// A section along the picked face. It keeps the face and what lies behind it. Looks at all triangles of a mesh.
    pub fn section_along_pick(&self) -> Option<Section> {
        self.scene.section(self.picked_face()?).ok().flatten()
    }

    /// Cuts by a section, or by none.
    pub(super) fn set_section(&mut self, section: Option<Section>) {
        if !self.takes_sections() {
            return;
        }
        let before = std::mem::replace(&mut self.view.section, section);
        if section.is_none() {
            self.section_off = before.or(self.section_off);
        }
    }

    /// Turns the section off, or on again: where it was, or else across the axis closest to the direction of view.
    pub(super) fn toggle_section(&mut self) {
        if self.view.section.is_some() {
            return self.set_section(None);
        }
        let forward = self.view.camera.forward().abs();
        let axis = DVec3::AXES[forward.max_position()];
        let off = self.section_off;
        self.set_section(off.or_else(|| self.section_across(axis)));
    }
}
