//! What a user can do to the scene and the view: the window's own event type. Tests replay it.

use super::{
    matrices::Row, measuring::MeasureAction, overlay::Overlay, stages::Stage, views::Views,
};
use crate::{
    camera::{CameraChoice, DepthMapping, UpAxis, Viewport},
    geometry::Section,
    study::swap::Swap,
};
use glam::{DAffine3, DVec2, DVec3};

/// Something a user does. Positions are physical pixels of the scene's rectangle, from its top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// The scene's rectangle has this size now.
    Resize(Viewport),
    /// A turn begins: what lies under the cursor becomes the pivot.
    BeginTurn(DVec2),
    /// The cursor moved by this while turning.
    Turn(DVec2),
    /// The cursor moved by this while turning the scene's camera. The cursor may be in any of the four views.
    Steer(DVec2),
    /// A pan begins: the point under the cursor will stay under it.
    BeginPan(DVec2),
    /// The cursor moved by this while panning.
    Pan(DVec2),
    /// Zoom at a position, by a factor above 1 to come nearer.
    Zoom(DVec2, f64),
    /// A click, and its time in seconds.
    Click(DVec2, f64),
    /// A double click: the point there becomes pivot and centre; on nothing, frame all. In one of the four views:
    /// enlarge that view, or show all four again.
    Recentre(DVec2),
    /// The cursor is at this position; `None` once it has left the picture.
    Hover(Option<DVec2>),
    /// The cursor rests on the list's row of this object, by index. Sent in each pass while it does: every pass begins
    /// by clearing the highlight.
    Light(Option<usize>),
    /// Show all that is visible.
    FrameAll,
    /// Show all that is selected, or all when nothing is.
    FrameSelection,
    /// Look from this direction of (right, up, towards the viewer).
    LookFrom(DVec3),
    /// Back to the view that the scene opened with.
    ResetView,
    /// Eye, target and up, as typed.
    Pose([DVec3; 3]),
    /// Field of view, projection, near, far, depth mapping.
    Lens(LensControls),
    /// Orthographic in place of perspective, or back.
    ToggleProjection,
    /// Which world axis points up.
    UpAxis(UpAxis),
    /// Show both sides of surfaces or only fronts.
    ToggleSides,
    /// Cut the world by a section, or by none.
    Section(Option<Section>),
    /// Turn the section off, or on again.
    ToggleSection,
    /// Pick this surface on the last click's ray, counted from the front.
    StepTo(usize),
    /// Pick the next surface on the last click's ray, or the one before.
    Step {
        /// The next, further away.
        forward: bool,
    },
    /// Give an object this model matrix; does nothing when the matrix has no inverse.
    Place(usize, DAffine3),
    /// Take over a camera, with all that the choice sets.
    Camera(CameraChoice),
    /// Select an object, or nothing.
    Select(Option<usize>),
    /// Add an object to what is selected, or take it out.
    ToggleSelected(usize),
    /// The same of the object at this position.
    ClickAlso(DVec2),
    /// Show or hide an object.
    SetVisible(usize, bool),
    /// Hide all that is selected.
    HideSelection,
    /// Hide all but what is selected.
    Isolate,
    /// Show every object.
    ShowAll,
    /// Show or hide the grid with its axes.
    ToggleGrid,
    /// Show or hide an overlay.
    Toggle(Overlay),
    /// Show the boxes of the meshes' trees one level deeper, or one level higher. Past the first or the last level,
    /// show none.
    TreeLevel {
        /// Away from the root.
        deeper: bool,
    },
    /// Show what the camera sees, the four views, or one of them large.
    Views(Views),
    /// The mouse actions that follow are in this one of the four views; `None` ends that.
    Enter(Option<Stage>),
    /// The cursor rests on a row of a matrix. Sent in each pass while it does, as [`Self::Light`] is.
    LightRow(Row),
    /// In the gallery: pick by this method; `None` is Sightline's own.
    PickBy(Option<Swap>),
    /// In the gallery: pick by the next method, or the one before.
    NextMethod {
        /// The next.
        forward: bool,
    },
    /// Do something to the list of measures.
    Measure(MeasureAction),
    /// Undo the last change of scene or view.
    Undo,
    /// Redo what was undone last.
    Redo,
    /// A slide or drag is over: the next one is an undo step of its own.
    Release,
    /// Leave the present camera standing in the world, as lines, or take it away. Does nothing in the four views.
    ToggleFreeze,
}

impl Action {
    /// Whether it makes the view jump, so that undo restores the view.
    pub(super) fn jumps(&self) -> bool {
        matches!(
            self,
            Self::FrameAll
                | Self::FrameSelection
                | Self::LookFrom(_)
                | Self::ResetView
                | Self::Pose(_)
                | Self::Lens(_)
                | Self::ToggleProjection
                | Self::ToggleSides
                | Self::UpAxis(_)
                | Self::Camera(_)
                | Self::Section(_)
                | Self::ToggleSection
                | Self::Recentre(_)
        )
    }

    /// Whether a slide or drag may go on after it. Any other action ends the gesture.
    pub(super) fn may_be_of_a_gesture(&self) -> bool {
        matches!(
            self,
            Self::Lens(_)
                | Self::Pose(_)
                | Self::Section(_)
                | Self::Place(..)
                | Self::Hover(_)
                | Self::Light(_)
                | Self::LightRow(_)
                | Self::Enter(_)
                | Self::Resize(_)
        )
    }

    /// Whether it edits the scene, or takes an edit back.
    pub fn edits(&self) -> bool {
        match self {
            Self::Place(..)
            | Self::SetVisible(..)
            | Self::HideSelection
            | Self::Isolate
            | Self::ShowAll
            | Self::Section(_)
            | Self::ToggleSection
            | Self::Undo
            | Self::Redo => true,
            Self::Measure(to_list) => *to_list != MeasureAction::Toggle,
            Self::Camera(choice) => choice.section.is_some(),
            _ => false,
        }
    }

    /// Whether it is for one of the four views while the mouse is in that view, and not for the camera's picture.
    pub(super) fn is_of_a_pane(&self) -> bool {
        matches!(
            self,
            Self::Resize(_)
                | Self::BeginTurn(_)
                | Self::Turn(_)
                | Self::BeginPan(_)
                | Self::Pan(_)
                | Self::Zoom(..)
                | Self::Click(..)
                | Self::ClickAlso(_)
                | Self::Recentre(_)
                | Self::Hover(_)
                | Self::LookFrom(_)
                | Self::ResetView
        )
    }
}

/// The lens as the panel sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LensControls {
    /// Vertical field of view in degrees.
    pub fov_deg: f64,
    /// Orthographic in place of perspective.
    pub orthographic: bool,
    /// Near plane; `None` fits it to the scene.
    pub near: Option<f64>,
    /// Far plane; `None` fits it to the scene.
    pub far: Option<f64>,
    /// What the depth buffer stores.
    pub depth: DepthMapping,
}

impl LensControls {
    /// The lens of a camera choice, with defaults for what it leaves open.
    pub fn of(choice: &CameraChoice) -> Self {
        Self {
            fov_deg: choice.fov.unwrap_or(CameraChoice::FOV),
            orthographic: choice.ortho.is_some(),
            near: choice.near,
            far: choice.far,
            depth: choice.depth.unwrap_or_default(),
        }
    }
}
