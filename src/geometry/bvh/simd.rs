//! The only module of the core with `unsafe`: eight `f32` at once, a stack that is not cleared first, and large pages.
//!
//! These eight lanes make the tree about three times as fast. Clearing the stack for each ray would slow that down. In
//! pages of 4 kB, a tree over a million triangles is a tenth slower. Three rules keep the code sound:
//!
//! * A value of [`Avx2`] proves that the processor has AVX2 and FMA, and one of `Avx2<true>` that it has what
//!   [`Avx512`] needs: only [`Avx2::detect`] and [`Avx512::detect`] make them, so their methods are safe to call. SSE2 is
//!   part of x86-64.
//! * [`Stack`] reads only below `len`, where it has written.
//! * The advice of [`with_large_pages`] changes no content.
//!
//! No function here decides about a pick: which one runs changes the speed, never the answer.
#![allow(
    unsafe_code,
    reason = "vector instructions, an uncleared stack and large pages; see above"
)]
#![allow(clippy::wildcard_imports, reason = "one name an instruction")]

use std::mem::MaybeUninit;

/// Which instructions build a tree and walk it. All give the same hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Simd {
    /// As AVX2, with twice the registers and one more instruction: x86-64 of servers, and of desktops since about 2022.
    Avx512,
    /// Eight lanes at once, with fused multiply-add: x86-64 since about 2013.
    Avx2,
    /// Twice four lanes: every x86-64.
    Sse2,
    /// Plain Rust: everything else.
    Portable,
}

impl Simd {
    /// What this processor can do, fastest first; plain Rust is the last.
    pub fn available() -> impl Iterator<Item = Self> {
        let all = [Self::Avx512, Self::Avx2, Self::Sse2, Self::Portable];
        all.into_iter()
            .filter(|simd| Instructions::of(*simd).is_some())
    }

    /// The fastest that this processor can do.
    pub fn fastest() -> Self {
        Self::available().next().unwrap_or(Self::Portable)
    }
}

/// Instructions that this processor has been detected to have. A value is the proof: nobody need detect again.
#[derive(Clone, Copy, Debug)]
pub(super) enum Instructions {
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    #[cfg(target_arch = "x86_64")]
    Sse2,
    Portable,
}

impl Instructions {
    /// The instructions of this name; `None` where this processor lacks them.
    pub fn of(simd: Simd) -> Option<Self> {
        match simd {
            #[cfg(target_arch = "x86_64")]
            Simd::Avx512 => Avx512::detect().map(Self::Avx512),
            #[cfg(target_arch = "x86_64")]
            Simd::Avx2 => Avx2::detect().map(Self::Avx2),
            #[cfg(target_arch = "x86_64")]
            Simd::Sse2 => Some(Self::Sse2),
            #[cfg(not(target_arch = "x86_64"))]
            Simd::Avx512 | Simd::Avx2 | Simd::Sse2 => None,
            Simd::Portable => Some(Self::Portable),
        }
    }

    /// Does `work` with these instructions.
    #[inline]
    pub fn run<W: Work>(self, work: W) -> W::Output {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(avx512) => avx512.run(work),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(avx2) => avx2.run(work),
            #[cfg(target_arch = "x86_64")]
            Self::Sse2 => work.run(x86::Sse2),
            Self::Portable => Portable.apart(work),
        }
    }
}

/// Work that is compiled for each set of instructions.
///
/// `run` and all that it calls with its lanes must be `#[inline(always)]`: only then are they compiled for these
/// instructions. This rules out closures.
pub(super) trait Work {
    type Output;
    fn run<L: Lanes>(self, lanes: L) -> Self::Output;
}

/// Arithmetic on eight `f32` at once. Comparisons give a mask whose bit `i` is lane `i`; with NaN they are false.
pub(super) trait Lanes: Copy {
    /// Eight numbers.
    type F: Copy;
    fn splat(self, x: f32) -> Self::F;
    fn load(self, from: &[f32; 8]) -> Self::F;
    fn store(self, from: Self::F) -> Eight;
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    /// `a * b + c`, rounded once or twice.
    fn mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// `c - a * b`, rounded once or twice.
    fn sub_mul(self, c: Self::F, a: Self::F, b: Self::F) -> Self::F;
    /// The lesser of each pair; NaN where both are, and possibly where one is.
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    /// The greater of each pair; NaN where both are, and possibly where one is.
    fn max(self, a: Self::F, b: Self::F) -> Self::F;
    fn abs(self, a: Self::F) -> Self::F;
    /// The largest absolute value; NaN where all are, and possibly where one is.
    #[inline(always)]
    fn largest_size(self, of: [Self::F; 6]) -> Self::F {
        largest_size(self, of)
    }
    /// Where `a <= b`.
    fn le(self, a: Self::F, b: Self::F) -> u32;
    /// The last four lanes first.
    fn halves_swapped(self, a: Self::F) -> Self::F;
    /// Prefetches the cache line of an item; an index past the end does no harm.
    fn prefetch<T>(self, items: &[T], index: usize);
    /// Does `work` with the same instructions or fewer, but out of line: for rare work that would crowd a loop.
    fn apart<W: Work>(self, work: W) -> W::Output;
}

/// [`Lanes::largest_size`] by other operations.
#[inline(always)]
fn largest_size<L: Lanes>(lanes: L, [a, b, c, d, e, f]: [L::F; 6]) -> L::F {
    let [a, b] = [lanes.abs(a), lanes.abs(b)];
    let [c, d] = [lanes.abs(c), lanes.abs(d)];
    let [e, f] = [lanes.abs(e), lanes.abs(f)];
    let (ab, cd, ef) = (lanes.max(a, b), lanes.max(c, d), lanes.max(e, f));
    lanes.max(lanes.max(ab, cd), ef)
}

/// Eight numbers in memory, aligned so that they never span two pages: spanning two makes a walk take a third longer.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(super) struct Eight(pub [f32; 8]);

/// [`Lanes`] in plain Rust.
#[derive(Clone, Copy)]
pub(super) struct Portable;

/// `f` of each lane.
#[inline(always)]
fn each(f: impl FnMut(usize) -> f32) -> [f32; 8] {
    std::array::from_fn(f)
}

#[rustfmt::skip] // A line an operation.
impl Lanes for Portable {
    type F = [f32; 8];
    #[inline(always)] fn splat(self, x: f32) -> Self::F { [x; 8] }
    #[inline(always)] fn load(self, from: &[f32; 8]) -> Self::F { *from }
    #[inline(always)] fn store(self, from: Self::F) -> Eight { Eight(from) }
    #[inline(always)] fn add(self, a: Self::F, b: Self::F) -> Self::F { each(|i| a[i] + b[i]) }
    #[inline(always)] fn sub(self, a: Self::F, b: Self::F) -> Self::F { each(|i| a[i] - b[i]) }
    #[inline(always)] fn mul(self, a: Self::F, b: Self::F) -> Self::F { each(|i| a[i] * b[i]) }
    #[inline(always)] fn mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F { each(|i| a[i] * b[i] + c[i]) }
    #[inline(always)] fn sub_mul(self, c: Self::F, a: Self::F, b: Self::F) -> Self::F { each(|i| c[i] - a[i] * b[i]) }
    #[inline(always)] fn min(self, a: Self::F, b: Self::F) -> Self::F { each(|i| if a[i] < b[i] { a[i] } else { b[i] }) }
    #[inline(always)] fn max(self, a: Self::F, b: Self::F) -> Self::F { each(|i| if a[i] > b[i] { a[i] } else { b[i] }) }
    #[inline(always)] fn abs(self, a: Self::F) -> Self::F { each(|i| a[i].abs()) }
    #[inline(always)] fn le(self, a: Self::F, b: Self::F) -> u32 { (0..8).fold(0, |mask, i| mask | u32::from(a[i] <= b[i]) << i) }
    #[inline(always)] fn halves_swapped(self, a: Self::F) -> Self::F { each(|i| a[i ^ 4]) }
    #[inline(always)] fn prefetch<T>(self, _: &[T], _: usize) {}
    #[inline(never)] fn apart<W: Work>(self, work: W) -> W::Output { work.run(self) }
}

#[cfg(target_arch = "x86_64")]
use x86::{Avx2, Avx512};

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Eight, Lanes, Work, largest_size};
    use std::arch::x86_64::*;

    /// Proof that the processor has AVX2 and FMA, and with `MORE` all that [`Avx512`] proves.
    #[derive(Clone, Copy, Debug)]
    pub(in crate::geometry::bvh) struct Avx2<const MORE: bool = false>(());

    impl Avx2 {
        #[inline(always)]
        pub fn detect() -> Option<Self> {
            let has = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            has.then_some(Self(()))
        }

        /// Runs `work` compiled for AVX2 and FMA. Rust never fuses `a * b + c` by itself, so scalar code within gives
        /// the same bits as elsewhere.
        #[inline(always)]
        pub fn run<W: Work>(self, work: W) -> W::Output {
            #[target_feature(enable = "avx2,fma")]
            fn compiled_for_avx2<W: Work>(lanes: Avx2, work: W) -> W::Output {
                work.run(lanes)
            }
            // SAFETY: `self` proves that the processor has both.
            unsafe { compiled_for_avx2(self, work) }
        }
    }

    /// Proof that the processor has what AVX-512 adds for eight lanes. The instructions are those of [`Avx2`] but for
    /// one, with 32 registers in place of 16: a walk need not store and reload half of its values.
    #[derive(Clone, Copy, Debug)]
    pub(in crate::geometry::bvh) struct Avx512(Avx2<true>);

    impl Avx512 {
        #[inline(always)]
        pub fn detect() -> Option<Self> {
            let has = is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512dq");
            Avx2::detect().filter(|_| has).map(|_| Self(Avx2(())))
        }

        /// Runs `work` compiled for these instructions.
        #[inline(always)]
        pub fn run<W: Work>(self, work: W) -> W::Output {
            #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq")]
            fn compiled_for_avx512<W: Work>(lanes: Avx2<true>, work: W) -> W::Output {
                work.run(lanes)
            }
            // SAFETY: `self` proves that the processor has all of them.
            unsafe { compiled_for_avx512(self.0, work) }
        }
    }

    // SAFETY of all: `self` proves that the processor has the instructions; loads and stores are unaligned and of
    // eight floats, which the arrays have; a prefetch reads nothing.
    #[rustfmt::skip] // A line an operation.
    impl<const MORE: bool> Lanes for Avx2<MORE> {
        type F = __m256;
        #[inline(always)] fn splat(self, x: f32) -> __m256 { unsafe { _mm256_set1_ps(x) } }
        #[inline(always)] fn load(self, from: &[f32; 8]) -> __m256 { unsafe { _mm256_loadu_ps(from.as_ptr()) } }
        #[inline(always)] fn store(self, from: __m256) -> Eight { let mut to = Eight([0.0; 8]); unsafe { _mm256_storeu_ps(to.0.as_mut_ptr(), from) }; to }
        #[inline(always)] fn add(self, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_add_ps(a, b) } }
        #[inline(always)] fn sub(self, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_sub_ps(a, b) } }
        #[inline(always)] fn mul(self, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_mul_ps(a, b) } }
        #[inline(always)] fn mul_add(self, a: __m256, b: __m256, c: __m256) -> __m256 { unsafe { _mm256_fmadd_ps(a, b, c) } }
        #[inline(always)] fn sub_mul(self, c: __m256, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_fnmadd_ps(a, b, c) } }
        #[inline(always)] fn min(self, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_min_ps(a, b) } }
        #[inline(always)] fn max(self, a: __m256, b: __m256) -> __m256 { unsafe { _mm256_max_ps(a, b) } }
        #[inline(always)] fn abs(self, a: __m256) -> __m256 { unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), a) } }
        #[inline(always)] fn largest_size(self, of: [__m256; 6]) -> __m256 { if MORE { unsafe { largest_size_by_avx512(of) } } else { largest_size(self, of) } }
        #[inline(always)] fn le(self, a: __m256, b: __m256) -> u32 { unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)).cast_unsigned() } }
        #[inline(always)] fn halves_swapped(self, a: __m256) -> __m256 { unsafe { _mm256_permute2f128_ps::<1>(a, a) } }
        #[inline(always)] fn prefetch<T>(self, items: &[T], index: usize) { unsafe { _mm_prefetch::<_MM_HINT_T0>(items.as_ptr().wrapping_add(index).cast()) } }
        #[inline(always)] fn apart<W: Work>(self, work: W) -> W::Output { unsafe { apart_by_avx2(self, work) } }
    }

    /// [`Lanes::largest_size`] with one instruction a pair.
    #[inline]
    #[target_feature(enable = "avx2,avx512f,avx512vl,avx512dq")]
    fn largest_size_by_avx512([a, b, c, d, e, f]: [__m256; 6]) -> __m256 {
        /// The greater of two absolute values.
        const SIZE: i32 = 0b1011;
        let (ab, cd) = (_mm256_range_ps::<SIZE>(a, b), _mm256_range_ps::<SIZE>(c, d));
        _mm256_range_ps::<SIZE>(
            _mm256_range_ps::<SIZE>(ab, cd),
            _mm256_range_ps::<SIZE>(e, f),
        )
    }

    #[inline(never)]
    #[target_feature(enable = "avx2,fma")]
    fn apart_by_avx2<W: Work, const MORE: bool>(lanes: Avx2<MORE>, work: W) -> W::Output {
        work.run(lanes)
    }

    /// [`Lanes`] as two halves of four, in SSE2, which every x86-64 has.
    #[derive(Clone, Copy)]
    pub(super) struct Sse2;

    // SAFETY of all: SSE2 is part of x86-64; loads and stores are unaligned and of four floats, and the arrays have
    // eight; a prefetch reads nothing.
    #[rustfmt::skip] // A line an operation.
    impl Lanes for Sse2 {
        type F = [__m128; 2];
        #[inline(always)] fn splat(self, x: f32) -> Self::F { unsafe { [_mm_set1_ps(x); 2] } }
        #[inline(always)] fn load(self, from: &[f32; 8]) -> Self::F { unsafe { [_mm_loadu_ps(from.as_ptr()), _mm_loadu_ps(from[4..].as_ptr())] } }
        #[inline(always)] fn store(self, from: Self::F) -> Eight { let mut to = Eight([0.0; 8]); unsafe { _mm_storeu_ps(to.0.as_mut_ptr(), from[0]); _mm_storeu_ps(to.0[4..].as_mut_ptr(), from[1]) }; to }
        #[inline(always)] fn add(self, a: Self::F, b: Self::F) -> Self::F { unsafe { [_mm_add_ps(a[0], b[0]), _mm_add_ps(a[1], b[1])] } }
        #[inline(always)] fn sub(self, a: Self::F, b: Self::F) -> Self::F { unsafe { [_mm_sub_ps(a[0], b[0]), _mm_sub_ps(a[1], b[1])] } }
        #[inline(always)] fn mul(self, a: Self::F, b: Self::F) -> Self::F { unsafe { [_mm_mul_ps(a[0], b[0]), _mm_mul_ps(a[1], b[1])] } }
        #[inline(always)] fn mul_add(self, a: Self::F, b: Self::F, c: Self::F) -> Self::F { self.add(self.mul(a, b), c) }
        #[inline(always)] fn sub_mul(self, c: Self::F, a: Self::F, b: Self::F) -> Self::F { self.sub(c, self.mul(a, b)) }
        #[inline(always)] fn min(self, a: Self::F, b: Self::F) -> Self::F { unsafe { [_mm_min_ps(a[0], b[0]), _mm_min_ps(a[1], b[1])] } }
        #[inline(always)] fn max(self, a: Self::F, b: Self::F) -> Self::F { unsafe { [_mm_max_ps(a[0], b[0]), _mm_max_ps(a[1], b[1])] } }
        #[inline(always)] fn abs(self, a: Self::F) -> Self::F { unsafe { [_mm_andnot_ps(_mm_set1_ps(-0.0), a[0]), _mm_andnot_ps(_mm_set1_ps(-0.0), a[1])] } }
        #[inline(always)] fn le(self, a: Self::F, b: Self::F) -> u32 { let [low, high] = unsafe { [_mm_movemask_ps(_mm_cmple_ps(a[0], b[0])), _mm_movemask_ps(_mm_cmple_ps(a[1], b[1]))] }; (low | high << 4).cast_unsigned() }
        #[inline(always)] fn halves_swapped(self, [low, high]: Self::F) -> Self::F { [high, low] }
        #[inline(always)] fn prefetch<T>(self, items: &[T], index: usize) { unsafe { _mm_prefetch::<_MM_HINT_T0>(items.as_ptr().wrapping_add(index).cast()) } }
        #[inline(never)] fn apart<W: Work>(self, work: W) -> W::Output { work.run(self) }
    }
}

/// Room for a [`Stack`], enough for the deepest tree (see the assertion in [`super::split`]).
pub(super) struct StackRoom([MaybeUninit<u64>; Self::CAPACITY]);

impl StackRoom {
    /// Items that fit.
    pub const CAPACITY: usize = 336;

    #[inline(always)]
    pub fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; Self::CAPACITY])
    }
}

/// The places that a walk has yet to visit. The length is kept apart from the room so that it stays in a register.
pub(super) struct Stack<'a> {
    room: &'a mut StackRoom,
    len: usize,
}

impl<'a> Stack<'a> {
    #[inline(always)]
    pub fn new(room: &'a mut StackRoom) -> Self {
        Self { room, len: 0 }
    }

    /// Puts an item on top. Panics when it is full.
    #[inline(always)]
    pub fn push(&mut self, item: u64) {
        self.room.0[self.len] = MaybeUninit::new(item);
        self.len += 1;
    }

    /// Takes the topmost item.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<u64> {
        self.len = self.len.checked_sub(1)?;
        // SAFETY: all items below the old `len` have been written, and `push` kept `len` within the array.
        Some(unsafe { self.room.0.get_unchecked(self.len).assume_init() })
    }

    #[inline(always)]
    pub fn len(&self) -> usize {
        self.len
    }

    /// The items from `start` on, lowest first.
    #[inline(always)]
    pub fn above(&mut self, start: usize) -> &mut [u64] {
        let items = &mut self.room.0[start..self.len];
        // SAFETY: all items below `len` have been written.
        unsafe { items.assume_init_mut() }
    }
}

/// A list with room for `capacity` items, in large pages where the system has them: a walk then waits less often for
/// address translation.
pub(super) fn with_large_pages<T>(capacity: usize) -> Vec<T> {
    let list: Vec<T> = Vec::with_capacity(capacity);
    #[cfg(target_os = "linux")]
    {
        use rustix::{
            mm::{Advice, madvise},
            param::page_size,
        };
        let start = list.as_ptr().addr().next_multiple_of(page_size());
        let end = list.as_ptr().addr() + capacity * size_of::<T>();
        if start < end {
            let from = list.as_ptr().with_addr(start).cast_mut().cast();
            // SAFETY: the pages begin within the list, and this advice changes nothing that a program can see. It may
            // be refused; then pages are small.
            let _ = unsafe { madvise(from, end - start, Advice::LinuxHugepage) };
        }
    }
    list
}
