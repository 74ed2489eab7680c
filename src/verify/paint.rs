//! Paints the picture that shows where drawn and picked differ.

use super::{Class, Disagreement};
use crate::{
    camera::Viewport,
    colour::Srgb,
    image::{Image, Rgb},
    look,
};

/// Each class's colour, and its name.
pub const COLOURS: [(Class, Srgb, &str); 6] = [
    (Class::Edge, look::EDGE, "blue"),
    (Class::Depth, look::DEPTH, "yellow"),
    (Class::Section, look::AT_SECTION, "brown"),
    (Class::F32Limit, look::F32_LIMIT, "green"),
    (Class::BeyondF32, look::BEYOND_F32, "pink"),
    (Class::Unexplained, look::WRONG, "vermilion"),
];

/// The tint of pixels whose surfaces lie in one place, and its name.
pub const IN_ONE_PLACE: (Srgb, &str) = (look::IN_ONE_PLACE, "dark blue");

/// The picture in grey, with pixels `in_one_place` tinted and [`marks`] over them.
pub fn paint(
    colours: &Image<Rgb>,
    in_one_place: &[[u32; 2]],
    disagreements: &[Disagreement],
) -> Image<Rgb> {
    let mut picture = colours.clone();
    for pixel in picture.pixels_mut() {
        *pixel = grey(*pixel);
    }
    let size = picture.size();
    let width = size.width() as usize;
    let pixels = picture.pixels_mut();
    let (Srgb(tint), _) = IN_ONE_PLACE;
    for [x, y] in in_one_place {
        let pixel = &mut pixels[*y as usize * width + *x as usize];
        for (channel, tint) in pixel.iter_mut().zip(tint) {
            *channel = channel.midpoint(tint);
        }
    }
    for ([x, y], Srgb(colour)) in marks(size, disagreements) {
        pixels[y as usize * width + x as usize] = colour;
    }
    picture
}

/// What to paint, in order: first a darker ring, one pixel wide, about each pixel that differs, then each such pixel in
/// its class's colour; the gravest last.
pub fn marks(
    size: Viewport,
    disagreements: &[Disagreement],
) -> impl Iterator<Item = ([u32; 2], Srgb)> {
    let mut sorted: Vec<Disagreement> = disagreements.to_vec();
    sorted.sort_by_key(|at| at.class);
    let rings = sorted.clone().into_iter().flat_map(move |at| {
        let [x, y] = at.pixel;
        let rows = y.saturating_sub(1)..=(y + 1).min(size.height() - 1);
        let around = rows.flat_map(move |j| {
            let columns = x.saturating_sub(1)..=(x + 1).min(size.width() - 1);
            columns.map(move |i| [i, j])
        });
        let ring = Srgb(colour(at.class).0.map(|c| c / 2));
        around.map(move |pixel| (pixel, ring))
    });
    rings.chain((sorted.into_iter()).map(|at| (at.pixel, colour(at.class))))
}

/// What a class is painted in.
fn colour(class: Class) -> Srgb {
    let of_class = COLOURS.iter().find(|(other, ..)| *other == class);
    of_class.map_or(Srgb::WHITE, |(_, colour, _)| *colour)
}

/// A paler grey, by luma.
fn grey(pixel: Rgb) -> Rgb {
    // Luma of Rec. 709, of the encoded values: good enough to tell shapes.
    let [r, g, b] = pixel.map(u32::from);
    let luma = (2126 * r + 7152 * g + 722 * b) / 10_000;
    [u8::try_from(64 + luma / 2).unwrap_or(u8::MAX); 3]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::Id;

    #[test]
    fn marks_stay_in_the_picture() {
        let size = Viewport::new(4, 3).expect("a viewport");
        let at = |pixel| Disagreement {
            pixel,
            drawn: Id::default(),
            picked: Id::default(),
            class: Class::Edge,
            strain: 1.0,
            outline_px: 0.0,
            outline_error_px: 0.0,
            depth: [1.0; 2],
        };
        for corner in [[0, 0], [3, 0], [0, 2], [3, 2]] {
            let marks: Vec<_> = marks(size, &[at(corner)]).collect();
            assert_eq!(
                marks.len(),
                4 + 1,
                "a ring of four pixels and the pixel itself"
            );
            assert!(
                marks.iter().all(|([x, y], _)| *x < 4 && *y < 3),
                "{marks:?}"
            );
        }
    }
}
