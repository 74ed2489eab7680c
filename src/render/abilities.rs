//! Determines what an adapter can do: the abilities that drawing requires, and those that it can do without.

use super::{
    SMOOTH_SAMPLES,
    formats::{COLOUR, DEPTH, IDS, MARKS},
};
use wgpu::{DownlevelFlags, Features, TextureUsages};

/// How ids number triangles, from best to worst.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Numbers {
    /// By the index that the adapter gives each primitive.
    #[default]
    Primitives,
    /// By vertex index: each triangle gets three vertices of its own, so that meshes take about four times the memory.
    Corners,
    /// Not at all: ids name objects alone, as if each had one triangle.
    Objects,
}

/// Restricts an adapter to less than it can do, for tests. The default restricts nothing.
#[derive(Clone, Debug)]
pub struct Restraint {
    /// The best numbering that may be used.
    pub numbers: Numbers,
    /// The most samples per pixel: 1, or [`SMOOTH_SAMPLES`].
    pub samples: u32,
    /// These limits, in place of all that the adapter has.
    pub limits: Option<wgpu::Limits>,
}

impl Default for Restraint {
    fn default() -> Self {
        Self {
            numbers: Numbers::default(),
            samples: SMOOTH_SAMPLES,
            limits: None,
        }
    }
}

impl Restraint {
    /// The best numbering that the adapter claims and this restraint allows.
    pub(super) fn numbers_of(&self, adapter: &wgpu::Adapter) -> Numbers {
        let has_index = adapter.features().contains(Features::PRIMITIVE_INDEX);
        let best = if has_index {
            Numbers::Primitives
        } else {
            Numbers::Corners
        };
        best.max(self.numbers)
    }

    /// Samples per pixel of a picture with smooth edges.
    pub(super) fn samples_of(&self, adapter: &wgpu::Adapter) -> u32 {
        let flags = adapter.get_downlevel_capabilities().flags;
        if flags.contains(DownlevelFlags::MULTISAMPLED_SHADING) {
            self.samples
        } else {
            1
        }
    }
}

/// The abilities that drawing requires and an adapter lacks.
pub(super) fn lacks(adapter: &wgpu::Adapter) -> Vec<&'static str> {
    let flags = adapter.get_downlevel_capabilities().flags;
    let flags_needed = [
        (
            DownlevelFlags::VERTEX_STORAGE,
            "tables that vertex shaders read (storage buffers)",
        ),
        (
            DownlevelFlags::FRAGMENT_STORAGE,
            "tables that fragment shaders read (storage buffers)",
        ),
        (
            DownlevelFlags::VIEW_FORMATS,
            "two formats for one texture (view formats)",
        ),
        (
            DownlevelFlags::FULL_DRAW_INDEX_UINT32,
            "meshes of many vertices (32-bit indices)",
        ),
    ];
    let formats_needed = [
        (COLOUR, "8-bit sRGB colours to draw into"),
        (IDS, "pairs of 32-bit integers to draw into"),
        (DEPTH, "32-bit floating-point depth"),
        (MARKS, "8-bit grey to draw into"),
    ];
    let flags_needed = flags_needed.map(|(flag, what)| (flags.contains(flag), what));
    let formats_needed = formats_needed.map(|(format, what)| {
        let usages = adapter.get_texture_format_features(format).allowed_usages;
        (usages.contains(TextureUsages::RENDER_ATTACHMENT), what)
    });
    let all = flags_needed.into_iter().chain(formats_needed);
    all.filter_map(|(has, what)| (!has).then_some(what))
        .collect()
}
