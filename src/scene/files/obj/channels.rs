//! Colours that some programs write from 0 to 255, in place of 0 to 1.

use super::block::Block;

/// The largest number of a byte.
const BYTE: f64 = 255.0;

/// Whether the channels of all colours of a file are clearly from 0 to 255: some are above 1.5, all are within, and
/// none is a share between 0 and 1. (`Kd 2.5 0.3 0.1` is a bright light, and not nearly black.) A 1 is such a share,
/// too, unless others are far above it.
#[expect(clippy::float_cmp, reason = "a 1 as it is written")]
pub(super) fn are_bytes(channels: impl Iterator<Item = f64>) -> bool {
    /// A light is hardly ever brighter.
    const BRIGHTEST: f64 = 16.0;
    let (mut largest, mut has_one) = (0.0_f64, false);
    for channel in channels {
        if !(0.0..=BYTE).contains(&channel) || channel > 0.0 && channel < 1.0 {
            return false;
        }
        largest = largest.max(channel);
        has_one |= channel == 1.0;
    }
    largest > if has_one { BRIGHTEST } else { 1.5 }
}

/// Gives vertices the colours of the file's `#MRGB` lines, if no vertex has one on its own line. `ZBrush` writes such
/// lines after an object's vertices, with a mask and a colour for each: lines that follow each other belong to the last
/// vertices before them. Vertices without a colour are white.
pub(super) fn spread_painted(blocks: &mut [Block]) {
    let is_coloured = |block: &Block| !block.vertices.colours.is_empty();
    let (mut count, mut painted) = (0, Vec::new());
    for block in &mut *blocks {
        let own = std::mem::take(&mut block.painted).into_iter();
        painted.extend(own.map(|(before, colour)| (count + before, colour)));
        count += block.vertices.positions.len();
    }
    if painted.is_empty() || blocks.iter().any(is_coloured) {
        return;
    }
    let mut colours = vec![WHITE; count];
    let mut last = 0;
    for lines in painted.chunk_by(|(a, _), (b, _)| a == b) {
        let (end, _) = lines[0];
        let start = end.saturating_sub(lines.len()).max(last);
        for (colour, (_, painted)) in colours[start..end].iter_mut().zip(lines) {
            *colour = *painted;
        }
        last = end;
    }
    let mut rest = colours.into_iter();
    for block in blocks {
        let own = rest.by_ref().take(block.vertices.positions.len());
        block.vertices.colours = own.collect();
    }
}

const WHITE: [f64; 3] = [1.0; 3];

/// Scales the colours of vertices if they are from 0 to 255, and says whether they were. Those that a file lacks, which
/// are NaN, become white.
pub(super) fn scale_bytes(blocks: &mut [Block]) -> bool {
    let channels = blocks.iter().flat_map(|block| &block.vertices.colours);
    let is_of_bytes = are_bytes(channels.flatten().copied().filter(|c| !c.is_nan()));
    for colour in blocks
        .iter_mut()
        .flat_map(|block| &mut block.vertices.colours)
    {
        if colour.iter().any(|channel| channel.is_nan()) {
            *colour = WHITE;
        } else if is_of_bytes {
            *colour = colour.map(|channel| channel / BYTE);
        }
    }
    is_of_bytes
}
