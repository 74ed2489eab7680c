//! Colours that some programs write from 0 to 255, in place of 0 to 1.

use super::block::Block;

/// The largest number of a byte.
const BYTE: f64 = 255.0;

/// Whether the channels of all colours of a file are clearly from 0 to 255: all are within, and some are above what a
/// light may have. (`Kd 17 12 4` is a lamp, and not nearly black.) A 1 among them speaks for a lamp, and a share
/// between 0 and 1 more so: in a file of bytes it is rare, because it is nearly black there.
#[expect(clippy::float_cmp, reason = "a 1 as it is written")]
pub(super) fn are_bytes(channels: impl Iterator<Item = f64>) -> bool {
    /// A lamp among colours from 0 to 1 is hardly ever brighter; nor are colours that are all above 1.
    const BRIGHTEST: [f64; 2] = [64.0, 16.0];
    /// How many channels above 1 there are for each share between 0 and 1.
    const RARE: usize = 3;
    let (mut largest, mut has_one, mut shares, mut above) = (0.0_f64, false, 0_usize, 0_usize);
    for channel in channels {
        // Half a step more may be rounding.
        if !(0.0..=BYTE + 0.5).contains(&channel) {
            return false;
        }
        largest = largest.max(channel);
        has_one |= channel == 1.0;
        shares += usize::from(channel > 0.0 && channel < 1.0);
        above += usize::from(channel > 1.0);
    }
    let has_small = has_one || shares > 0;
    largest > BRIGHTEST[usize::from(!has_small)] && above > RARE * shares
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

/// What is said about colours that are not from 0 to 1.
#[derive(Clone, Copy)]
pub(super) enum Beyond {
    /// They were from 0 to 255, and are scaled.
    Bytes,
    /// Some are above 1, and count as 1.
    One,
}

/// Scales the colours of vertices if they are from 0 to 255. Those that a file lacks, which are NaN, become white.
pub(super) fn scale_bytes(blocks: &mut [Block]) -> Option<Beyond> {
    let channels = blocks.iter().flat_map(|block| &block.vertices.colours);
    let channels = channels.flatten().copied().filter(|c| !c.is_nan());
    let is_of_bytes = are_bytes(channels.clone());
    let has_more = channels.clone().any(is_above_one);
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
    if is_of_bytes {
        return Some(Beyond::Bytes);
    }
    has_more.then_some(Beyond::One)
}

/// Whether a channel is above 1 by more than a picture shows.
pub(super) fn is_above_one(channel: f64) -> bool {
    channel > 1.0 + 0.5 / BYTE
}
