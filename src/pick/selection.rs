//! The selected object in a ray-cast picture: tinted where it shows, outlined even where it is hidden.

use super::{each_ray, nearest::nearest};
use crate::{
    camera::View,
    colour::Srgb,
    image::{Id, Image, Rgb},
    look,
    scene::Scene,
};

/// Tints the pixels that show `object` (an index) and draws its outline, also where something stands in front of it.
/// `ids` and `colours` are [`raycast`](super::raycast())'s for this scene and view.
///
/// # Panics
/// When there is no object of this index, or an image does not have the view's size.
pub fn draw_selection(
    scene: &Scene,
    view: &View,
    object: usize,
    ids: &Image<Id>,
    colours: &mut Image<Rgb>,
) {
    let sizes = [ids.size(), colours.size()];
    assert_eq!(sizes, [view.viewport; 2], "the images are the view's");
    // The object is traced as if nothing else were there.
    let alone = Scene::new(vec![scene.objects()[object].clone()]);
    let covered = each_ray(&alone, view, |beam, ray, _| {
        nearest(beam, ray, view.sides, None).is_some()
    });
    let covered = Image::new(view.viewport, covered);
    for (((x, y), id), colour) in ids.positions().zip(ids.pixels()).zip(colours.pixels_mut()) {
        if on_outline(&covered, x, y) {
            *colour = look::SELECTION.0;
        } else if id.object as usize == object + 1 {
            let tinted = look::tinted(Srgb(*colour).to_linear());
            *colour = Srgb::from_linear(tinted).0;
        }
    }
}

/// Whether the border of the covered area passes within [`look::OUTLINE_PX`] of a pixel. The picture's own rim is no
/// border.
fn on_outline(covered: &Image<bool>, x: u32, y: u32) -> bool {
    let reach = look::OUTLINE_PX;
    let size = covered.size();
    let rows = y.saturating_sub(reach)..=(y + reach).min(size.height() - 1);
    let mut near = rows.flat_map(|j| {
        let columns = x.saturating_sub(reach)..=(x + reach).min(size.width() - 1);
        columns.map(move |i| (i, j))
    });
    let here = covered.at(x, y);
    near.any(|(i, j)| {
        let within = i.abs_diff(x).pow(2) + j.abs_diff(y).pow(2) <= reach.pow(2);
        within && covered.at(i, j) != here
    })
}
