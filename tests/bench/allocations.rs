//! The cost of a build: its time, and its memory by counting all allocations.
#![allow(unsafe_code, reason = "an allocator")]

use std::{
    alloc::{GlobalAlloc, Layout, System},
    sync::atomic::{AtomicIsize, Ordering},
    time::Instant,
};

/// Bytes that are held now, and the most that were.
#[derive(Default)]
pub struct Count {
    now: AtomicIsize,
    peak: AtomicIsize,
}

impl Count {
    const fn new() -> Self {
        Self {
            now: AtomicIsize::new(0),
            peak: AtomicIsize::new(0),
        }
    }

    /// Counts bytes that are allocated, or freed where negative.
    pub fn add(&self, bytes: isize) {
        let now = self.now.fetch_add(bytes, Ordering::Relaxed) + bytes;
        self.peak.fetch_max(now, Ordering::Relaxed);
    }

    pub fn held_and_peak(&self) -> [isize; 2] {
        [&self.now, &self.peak].map(|count| count.load(Ordering::Relaxed))
    }
}

/// The cost of a build.
#[derive(Clone, Copy)]
pub struct Cost {
    pub seconds: f64,
    /// Bytes held afterwards, and the most held during the build; `None` where they are not counted.
    pub memory: Option<[isize; 2]>,
}

/// Runs `work` and measures its cost.
pub fn cost_of<T>(work: impl FnOnce() -> T) -> (T, Cost) {
    let before = COUNT.now.load(Ordering::Relaxed);
    COUNT.peak.store(before, Ordering::Relaxed);
    let start = Instant::now();
    let made = work();
    let seconds = start.elapsed().as_secs_f64();
    let memory = Some(COUNT.held_and_peak().map(|bytes| bytes - before));
    (made, Cost { seconds, memory })
}

#[global_allocator]
static COUNT: Count = Count::new();

// SAFETY: every call goes to the system's allocator; only sizes are counted.
unsafe impl GlobalAlloc for Count {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        self.add(layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        self.add(-layout.size().cast_signed());
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(block, layout) }
    }
}
