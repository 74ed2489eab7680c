//! The range of stored numbers: coordinates, entries of matrices, positions, near, far. A larger number is refused; a
//! smaller one is stored as 0, and 0 is then the stored number.
//!
//! No product in a filter can then overflow, nor underflow by an amount that its bound does not cover.

use super::binary::power_of_two;
use glam::DVec3;

/// The largest size of a stored number, about 1.3e33. A scene of 1e30 and the eye that sees all of it fit in.
pub const LARGEST: f64 = power_of_two(110);
/// The least size of a stored number other than 0, about 7.7e-34.
pub const LEAST: f64 = 1.0 / LARGEST;

/// A number as it is stored; `None` for one that is larger than [`LARGEST`], and for NaN.
#[inline]
pub fn stored(number: f64) -> Option<f64> {
    let size = number.abs();
    let is_small = size < LEAST && number != 0.0;
    (size <= LARGEST).then_some(if is_small { 0.0 } else { number })
}

/// A vector whose numbers are [`stored`].
#[inline]
pub fn stored_vector(vector: DVec3) -> Option<DVec3> {
    let [x, y, z] = vector.to_array().map(stored);
    Some(DVec3::new(x?, y?, z?))
}

/// Whether each number of a vector is stored as it is. Without branches: it is asked for each ray.
#[inline]
pub(super) fn is_stored(vector: DVec3) -> bool {
    let size = vector.abs();
    let is_large = size.cmpge(DVec3::splat(LEAST)) | size.cmpeq(DVec3::ZERO);
    (size.cmple(DVec3::splat(LARGEST)) & is_large).all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_beyond_the_range_are_refused_or_zero() {
        for size in [LEAST, 1e-30, 1.0, 1e30, LARGEST] {
            assert_eq!([stored(size), stored(-size)], [Some(size), Some(-size)]);
        }
        for size in [0.0, 5e-324, LEAST.next_down()] {
            assert_eq!([stored(size), stored(-size)], [Some(0.0); 2]);
        }
        for beyond in [LARGEST.next_up(), f64::INFINITY, f64::NAN] {
            assert_eq!([stored(beyond), stored(-beyond)], [None; 2]);
            for axis in 0..3 {
                let mut vector = DVec3::new(1.0, 1e-40, 2.0);
                assert_eq!(stored_vector(vector), Some(DVec3::new(1.0, 0.0, 2.0)));
                vector[axis] = beyond;
                assert_eq!(stored_vector(vector), None);
                for (number, is_as_it_is) in
                    [(1e-40, false), (0.0, true), (LEAST, true), (beyond, false)]
                {
                    let mut vector = DVec3::new(-LARGEST, 1.0, -0.0);
                    vector[axis] = number;
                    assert_eq!(is_stored(vector), is_as_it_is, "{vector}");
                }
            }
        }
    }
}
