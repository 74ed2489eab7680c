//! What a user can do to the scene and the view: the window's own event type. Tests replay it.

use super::{
    matrices::Row, measuring::MeasureAction, overlay::Overlay, sought::Sought, stages::Stage,
    views::Views,
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
    /// The cursor moved by this while turning the scene's camera, wherever it is: also in one of the four views.
    Steer(DVec2),
    /// A shift begins: what lies under the cursor will follow it.
    BeginPan(DVec2),
    /// The cursor moved by this while shifting.
    Pan(DVec2),
    /// Zoom at a position, by a factor above 1 to come nearer.
    Zoom(DVec2, f64),
    /// A click, and when in seconds.
    Click(DVec2, f64),
    /// A double click: what lies there becomes pivot and centre; on nothing, frame all. One of the four views becomes
    /// large, or all four are there again.
    Recentre(DVec2),
    /// The cursor rests there, or left.
    Hover(Option<DVec2>),
    /// The cursor rests on the row of this object, by index, in a list of them. Asked for in each pass that it does: the
    /// next puts the light out.
    Light(Option<usize>),
    /// Show all that is visible.
    FrameAll,
    /// Show the selected object, or all when there is none.
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
    /// Lay a section through the next three picks, or no longer.
    SectionByPoints(bool),
    /// Pick this surface of those on the last click's ray, from the front.
    StepTo(usize),
    /// Pick the next surface on the last click's ray, or the one before.
    Step {
        /// The next, further away.
        forward: bool,
    },
    /// Show what a file has a number for and mark it; pick it there, whatever lies before it.
    GoTo(Sought),
    /// Take that mark away.
    Unmark,
    /// Give an object this model matrix; nothing when it has no inverse.
    Place(usize, DAffine3),
    /// Take over a camera, all that it says of it.
    Camera(CameraChoice),
    /// Select an object, or nothing.
    Select(Option<usize>),
    /// Show or hide an object.
    SetVisible(usize, bool),
    /// Hide the selected object.
    HideSelection,
    /// Hide all but the selected object.
    Isolate,
    /// Show every object.
    ShowAll,
    /// Show or hide the grid with its axes.
    ToggleGrid,
    /// Show something over the scene, or no more.
    Toggle(Overlay),
    /// Show the boxes of trees a level deeper, or less deep; none beyond the first and the last level.
    TreeLevel {
        /// Away from the root.
        deeper: bool,
    },
    /// Show what the camera sees, the four views, or one of them large.
    Views(Views),
    /// The mouse is in this one of the four views, until it leaves: what it does now it does there.
    Enter(Option<Stage>),
    /// The cursor rests on a row of a matrix. Asked for in each pass that it does: the next puts the light out.
    LightRow(Row),
    /// In the gallery: pick by this method, or by this program's own.
    PickBy(Option<Swap>),
    /// In the gallery: pick by the next method, or the one before.
    NextMethod {
        /// The next.
        forward: bool,
    },
    /// Do something to the list of measures.
    Measure(MeasureAction),
    /// Take back the last change of scene or view.
    Undo,
    /// Make again what was taken back last.
    Redo,
    /// The gesture is over: of what is slid or dragged, what comes next is undone by itself.
    Release,
    /// Back to what was open before the gallery, as it was; nothing where nothing was.
    LeaveGallery,
    /// Leave the present camera standing in the world, as lines, or take it away; nothing in the four views.
    ToggleFreeze,
}

impl Action {
    /// Whether the view leaps: a step back leads to where it stood.
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
                | Self::UpAxis(_)
                | Self::Camera(_)
                | Self::Section(_)
                | Self::ToggleSection
                | Self::Recentre(_)
                | Self::GoTo(_)
        )
    }

    /// Whether a slider or a drag may go on with it, or beside it.
    pub(super) fn may_be_of_a_gesture(&self) -> bool {
        matches!(
            self,
            Self::Lens(_)
                | Self::Section(_)
                | Self::Place(..)
                | Self::Hover(_)
                | Self::Light(_)
                | Self::LightRow(_)
                | Self::Enter(_)
                | Self::Resize(_)
        )
    }

    /// Whether within one of the four views it is about that view alone.
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
                | Self::Recentre(_)
                | Self::Hover(_)
                | Self::LookFrom(_)
                | Self::ResetView
        )
    }
}

/// The lens as the panel holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LensControls {
    /// Vertical field of view in degrees.
    pub fov_deg: f64,
    /// Orthographic in place of perspective.
    pub orthographic: bool,
    /// Near plane, or fitted to the scene.
    pub near: Option<f64>,
    /// Far plane, or fitted to the scene.
    pub far: Option<f64>,
    /// What the depth buffer stores.
    pub depth: DepthMapping,
}

impl LensControls {
    /// Orthographic in place of perspective, or back.
    pub(super) fn other_projection(self) -> Self {
        Self {
            orthographic: !self.orthographic,
            ..self
        }
    }

    /// What somebody says of a camera's lens.
    #[must_use]
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
