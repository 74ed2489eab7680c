//! The keywords that begin a line of an OBJ file.

/// What a line is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Keyword {
    Vertex,
    Normal,
    Face,
    Object,
    Group,
    Material,
    Library,
    Smoothing,
    /// `ZBrush`'s colours of vertices, in a comment.
    Painted,
    Point,
    Line,
    FreeForm,
    /// Anything else is ignored.
    Other,
}

impl Keyword {
    /// The keyword of a line's first word, in upper or lower case.
    pub fn of(word: &[u8]) -> Self {
        match word {
            b"v" => Self::Vertex,
            b"vn" => Self::Normal,
            // `fo` is how the first version of the format wrote it.
            b"f" | b"fo" => Self::Face,
            b"o" => Self::Object,
            b"g" => Self::Group,
            b"usemtl" => Self::Material,
            b"mtllib" => Self::Library,
            b"s" => Self::Smoothing,
            b"#mrgb" => Self::Painted,
            b"p" => Self::Point,
            b"l" => Self::Line,
            b"curv" | b"curv2" | b"surf" => Self::FreeForm,
            _ if word.iter().any(u8::is_ascii_uppercase) => Self::of(&word.to_ascii_lowercase()),
            _ => Self::Other,
        }
    }
}
