//! Determines what an adapter can do: the abilities that drawing requires, and the one that it can do without.

use super::{
    formats::{COLOUR, DEPTH, IDS, MARKS},
    gpu_error::GpuError,
};
use wgpu::{DownlevelFlags, Features, TextureFormat, TextureUsages};

/// How ids number triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Numbers {
    /// By the index that the adapter gives each primitive.
    #[default]
    Primitives,
    /// By vertex index: each triangle gets three vertices of its own, so that meshes take about four times the memory.
    Corners,
}

/// Restricts an adapter to less than it can do, for tests. The default restricts nothing.
#[derive(Clone, Debug, Default)]
pub struct Restraint {
    /// Whether triangles are numbered by corners even where the adapter has an index.
    pub by_corners: bool,
    /// These limits, in place of all that the adapter has.
    pub limits: Option<wgpu::Limits>,
}

impl Restraint {
    /// How triangles are numbered on an adapter.
    pub(super) fn numbers_of(&self, adapter: &wgpu::Adapter) -> Numbers {
        if adapter.features().contains(Features::PRIMITIVE_INDEX) && !self.by_corners {
            Numbers::Primitives
        } else {
            Numbers::Corners
        }
    }
}

/// Refuses an adapter that lacks an ability that drawing requires.
pub(super) fn check(adapter: &wgpu::Adapter) -> Result<(), GpuError> {
    let flags = adapter.get_downlevel_capabilities().flags;
    let usages = |format| adapter.get_texture_format_features(format).allowed_usages;
    let features = adapter.features();
    check_each(adapter.get_info().name, flags, features, usages)
}

/// [`check`] for an adapter with these flags and features, whose textures of a format may have these usages.
fn check_each(
    adapter: String,
    flags: DownlevelFlags,
    features: Features,
    usages: impl Fn(TextureFormat) -> TextureUsages,
) -> Result<(), GpuError> {
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
        (
            DownlevelFlags::MULTISAMPLED_SHADING,
            "smooth edges (shading of each sample)",
        ),
    ];
    let edges = (
        features.contains(Features::POLYGON_MODE_LINE),
        "triangles drawn as their edges",
    );
    let formats_needed = [
        (COLOUR, "8-bit sRGB colours to draw into"),
        (IDS, "pairs of 32-bit integers to draw into"),
        (DEPTH, "32-bit floating-point depth"),
        (MARKS, "8-bit grey to draw into"),
    ];
    let flags_needed = flags_needed.map(|(flag, what)| (flags.contains(flag), what));
    let formats_needed = formats_needed.map(|(format, what)| {
        let drawn_into = usages(format).contains(TextureUsages::RENDER_ATTACHMENT);
        (drawn_into, what)
    });
    let all = flags_needed.into_iter().chain([edges]);
    let all = all.chain(formats_needed);
    let lacking = all.filter_map(|(has, what)| (!has).then_some(what));
    let lacking: Vec<_> = lacking.collect();
    if lacking.is_empty() {
        return Ok(());
    }
    let what = lacking.join(", ");
    Err(GpuError::Lacks { adapter, what })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAGS: [(DownlevelFlags, &str); 5] = [
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
        (
            DownlevelFlags::MULTISAMPLED_SHADING,
            "smooth edges (shading of each sample)",
        ),
    ];
    const EDGES: &str = "triangles drawn as their edges";
    const FORMATS: [(TextureFormat, &str); 4] = [
        (
            TextureFormat::Rgba8UnormSrgb,
            "8-bit sRGB colours to draw into",
        ),
        (
            TextureFormat::Rg32Uint,
            "pairs of 32-bit integers to draw into",
        ),
        (TextureFormat::Depth32Float, "32-bit floating-point depth"),
        (TextureFormat::R8Unorm, "8-bit grey to draw into"),
    ];

    /// What the error says of an adapter without these flags, which draws edges or does not, and whose textures of
    /// these formats cannot be drawn into.
    fn said(
        without: DownlevelFlags,
        draws_edges: bool,
        undrawn: &[TextureFormat],
    ) -> Option<String> {
        let flags = DownlevelFlags::all() - without;
        let usages = |format| {
            if undrawn.contains(&format) {
                TextureUsages::all() - TextureUsages::RENDER_ATTACHMENT
            } else {
                TextureUsages::RENDER_ATTACHMENT
            }
        };
        let mut features = Features::empty();
        features.set(Features::POLYGON_MODE_LINE, draws_edges);
        let refused = check_each("Old card".to_owned(), flags, features, usages).err();
        refused.map(|error| error.to_string())
    }

    #[test]
    fn an_adapter_is_refused_by_the_name_of_each_ability_that_it_lacks() {
        let line = |what: &str| {
            let advice = "use another driver; `sightline doctor` lists what there is";
            Some(format!("Old card lacks {what}: {advice}"))
        };
        for (flag, what) in FLAGS {
            assert_eq!(said(flag, true, &[]), line(what));
        }
        assert_eq!(said(DownlevelFlags::empty(), false, &[]), line(EDGES));
        for (format, what) in FORMATS {
            assert_eq!(said(DownlevelFlags::empty(), true, &[format]), line(what));
        }
        let every_word: Vec<_> = (FLAGS.map(|(_, what)| what).into_iter())
            .chain([EDGES])
            .chain(FORMATS.map(|(_, what)| what))
            .collect();
        let formats = FORMATS.map(|(format, _)| format);
        let all = DownlevelFlags::all();
        assert_eq!(said(all, false, &formats), line(&every_word.join(", ")));
    }

    /// What makes drawing better or faster is not required.
    #[test]
    fn an_adapter_with_what_drawing_requires_is_taken() {
        let required = FLAGS.map(|(flag, _)| flag).into_iter().collect();
        let others = DownlevelFlags::all() - required;
        assert_eq!(said(others, true, &[]), None);
        assert_eq!(said(others, true, &[TextureFormat::Rgba32Float]), None);
    }
}
