//! What a user can do to the scene and the view: the window's own event type. Tests replay it.

use super::{
    matrices::Row,
    measuring::MeasureAction,
    overlay::Overlay,
    stages::{Stage, Views},
    timeline::Gesture,
    worked_numbers::WorkedNumber,
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
    /// The height of an orthographic picture, in world units; does nothing in perspective.
    PictureHeight(f64),
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
    /// The cursor rests on a number of the worked pick, or on what it is in the picture. Sent in each pass, too.
    LightNumber(WorkedNumber),
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

/// What an action means for the slide or drag before it.
#[derive(Clone, Copy, Default)]
pub(in crate::viewer) enum InGesture {
    /// It ends it.
    #[default]
    Ends,
    /// It may come in the middle of one.
    Between,
    /// It is a part of this one: with those before it, one step of undo.
    Of(Gesture),
}

/// The rules that an action obeys.
#[derive(Clone, Copy, Default)]
pub(in crate::viewer) struct Rules {
    /// It makes the view leap, so undo restores the view.
    pub leaps: bool,
    /// Whether a slide or drag may go on after it.
    pub gesture: InGesture,
    /// While the mouse is in one of the four views it is for that view, and not for the camera's picture.
    pub in_view: bool,
    /// It edits the scene, or takes an edit back. While files load, edits wait, unless a changed file is followed.
    pub edits: bool,
}

impl Action {
    /// The rules that it obeys.
    pub(in crate::viewer) fn rules(&self) -> Rules {
        let none = Rules::default();
        let leaps = Rules {
            leaps: true,
            ..none
        };
        let between = Rules {
            gesture: InGesture::Between,
            ..none
        };
        let in_view = Rules {
            in_view: true,
            ..none
        };
        let edits = Rules {
            edits: true,
            ..none
        };
        match self {
            Self::Resize(_) | Self::Hover(_) => Rules {
                gesture: InGesture::Between,
                ..in_view
            },
            Self::BeginTurn(_)
            | Self::Turn(_)
            | Self::BeginPan(_)
            | Self::Pan(_)
            | Self::Zoom(..)
            | Self::Click(..)
            | Self::ClickAlso(_) => in_view,
            Self::Recentre(_) | Self::LookFrom(_) | Self::ResetView => Rules {
                leaps: true,
                ..in_view
            },
            Self::FrameAll
            | Self::FrameSelection
            | Self::ToggleFreeze
            | Self::ToggleProjection
            | Self::ToggleSides
            | Self::UpAxis(_) => leaps,
            Self::Camera(choice) => Rules {
                edits: choice.section.is_some(),
                ..leaps
            },
            Self::Lens(_) | Self::PictureHeight(_) => Rules {
                gesture: InGesture::Of(Gesture::Lens),
                ..leaps
            },
            Self::Pose(_) => Rules {
                gesture: InGesture::Of(Gesture::Pose),
                ..leaps
            },
            Self::Section(_) => Rules {
                leaps: true,
                gesture: InGesture::Of(Gesture::Section),
                ..edits
            },
            Self::ToggleSection => Rules {
                leaps: true,
                ..edits
            },
            Self::Place(object, _) => Rules {
                gesture: InGesture::Of(Gesture::Place(*object)),
                ..edits
            },
            Self::SetVisible(..)
            | Self::HideSelection
            | Self::Isolate
            | Self::ShowAll
            | Self::Undo
            | Self::Redo => edits,
            Self::Measure(action) => Rules {
                edits: *action != MeasureAction::Toggle,
                ..none
            },
            Self::Light(_) | Self::LightRow(_) | Self::LightNumber(_) | Self::Enter(_) => between,
            Self::Steer(_)
            | Self::StepTo(_)
            | Self::Step { .. }
            | Self::Select(_)
            | Self::ToggleSelected(_)
            | Self::Toggle(_)
            | Self::TreeLevel { .. }
            | Self::Views(_)
            | Self::PickBy(_)
            | Self::NextMethod { .. }
            | Self::Release => none,
        }
    }
}

/// The lens as the panel sets it. Undo brings all of it back. The aspect ratio is the viewport's.
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
    /// The same with near and far fitted to the scene.
    pub(super) fn fitted(self) -> Self {
        Self {
            near: None,
            far: None,
            ..self
        }
    }

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
