//! The selected object in a ray-cast picture: tinted and outlined where it shows.

use crate::{
    colour::Srgb,
    image::{Id, Image, Rgb},
    look::{self, Background},
};

/// Tints the pixels that show `object` (an index) and draws the outline about them. `ids` and `colours` are
/// [`raycast`](super::raycast())'s, on this background.
///
/// # Panics
/// When the images differ in size.
pub fn mark(object: usize, ids: &Image<Id>, colours: &mut Image<Rgb>, background: Background) {
    assert_eq!(ids.size(), colours.size(), "the images are of one view");
    let outline = Srgb::from_linear(background.over(look::SELECTION)).0;
    for (((x, y), id), colour) in ids.positions().zip(ids.pixels()).zip(colours.pixels_mut()) {
        if on_outline(object, ids, x, y) {
            *colour = outline;
        } else if shows(object, *id) {
            let tinted = look::tinted(Srgb(*colour).to_linear());
            *colour = Srgb::from_linear(tinted).0;
        }
    }
}

fn shows(object: usize, id: Id) -> bool {
    id.object as usize == object + 1
}

/// Whether the border of what shows the object passes within [`look::OUTLINE_PX`] of a pixel. The picture's own rim is
/// no border.
fn on_outline(object: usize, ids: &Image<Id>, x: u32, y: u32) -> bool {
    let reach = look::OUTLINE_PX;
    let size = ids.size();
    let rows = y.saturating_sub(reach)..=(y + reach).min(size.height() - 1);
    let mut near = rows.flat_map(|j| {
        let columns = x.saturating_sub(reach)..=(x + reach).min(size.width() - 1);
        columns.map(move |i| (i, j))
    });
    let here = shows(object, ids.at(x, y));
    near.any(|(i, j)| {
        let within = i.abs_diff(x).pow(2) + j.abs_diff(y).pow(2) <= reach.pow(2);
        within && shows(object, ids.at(i, j)) != here
    })
}
