//! The stages of the pipeline, and which of them the window shows.

/// How far along the pipeline something is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// Before any matrix: one object in its own space.
    Object,
    /// After M: the scene as it stands, with the camera in it.
    #[default]
    World,
    /// After V M: the eye at the origin, x right, y up, z forward. Left-handed.
    View,
    /// After P V M and the division by w: the frustum as the box x, y in [-1, 1], z in [0, 1].
    Ndc,
}

impl Stage {
    /// All of them, in order, with their names.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Object, "object"),
        (Self::World, "world"),
        (Self::View, "view"),
        (Self::Ndc, "NDC"),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// What the window shows of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Views {
    /// What the scene's camera sees.
    #[default]
    Picture,
    /// All stages side by side.
    Four,
    /// One of them, large.
    One(Stage),
}
