//! What a face names before it is known what comes before its piece.

/// A vertex or a normal, as a corner of a face names it: by its number in the file, or counted back from the line. What
/// is counted back is kept as its number in the piece, which becomes one in the file once the pieces before it are
/// read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Named(u32);

/// Set where a number counts from the start of the piece.
const IN_PIECE: u32 = 1 << 31;

impl Named {
    /// Numbers from this on name nothing: a file that is not too large has fewer vertices.
    pub const MOST: usize = 1 << 30;
    /// No normal.
    pub const NONE: Self = Self(u32::MAX);

    /// By a number in the file, from 1. Numbers from [`Self::MOST`] on are one.
    pub fn in_file(number: usize) -> Self {
        Self(u32::try_from(number.min(Self::MOST)).unwrap_or(0))
    }

    /// By a number in the piece, from 1; what is before the piece has numbers from 0 downwards.
    pub fn in_piece(number: isize) -> Self {
        let above = number.saturating_add_unsigned(Self::MOST);
        let bits = u32::try_from(above).unwrap_or(0).min(IN_PIECE - 2);
        Self(IN_PIECE | bits)
    }

    /// Whether it counts back.
    pub fn is_counted_back(self) -> bool {
        self.0 & IN_PIECE != 0
    }

    /// The number in the file, from 1, of what has so many before its piece. A number below 1 names nothing.
    pub fn number(self, before: usize) -> isize {
        let Self(bits) = self;
        let as_signed = |value: usize| isize::try_from(value).unwrap_or(isize::MAX);
        if bits & IN_PIECE == 0 {
            return as_signed((bits & !IN_PIECE) as usize);
        }
        as_signed(before) + as_signed((bits & !IN_PIECE) as usize) - as_signed(Self::MOST)
    }

    /// The index in the file, from 0, if `count` are there.
    pub fn index(self, before: usize, count: usize) -> Option<u32> {
        let number = usize::try_from(self.number(before)).ok()?;
        let index = number.checked_sub(1).filter(|index| *index < count)?;
        u32::try_from(index).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_in_both_ways() {
        assert_eq!(Named::in_file(7).index(100, 7), Some(6));
        assert_eq!(Named::in_file(7).index(100, 6), None);
        assert_eq!(Named::in_file(0).index(0, 6), None);
        assert_eq!(Named::in_file(usize::MAX).index(0, 6), None);
        assert_eq!(Named::in_piece(1).index(5, 6), Some(5));
        assert_eq!(Named::in_piece(-4).index(5, 6), Some(0));
        assert_eq!(Named::in_piece(-5).index(5, 6), None);
        assert_eq!(Named::in_piece(-5).number(5), 0);
        assert_eq!(Named::in_piece(isize::MIN).index(5, 6), None);
        assert_ne!(Named::in_piece(isize::MAX), Named::NONE);
    }
}
