//! What a build takes: time, and memory by counting every allocation.
#![allow(unsafe_code, reason = "an allocator")]

use std::{
    alloc::{GlobalAlloc, Layout, System},
    sync::atomic::{AtomicIsize, Ordering},
    time::Instant,
};

/// Bytes that are held, and the most that were.
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

    /// Counts more, or fewer.
    pub fn add(&self, bytes: isize) {
        let now = self.now.fetch_add(bytes, Ordering::Relaxed) + bytes;
        self.peak.fetch_max(now, Ordering::Relaxed);
    }

    pub fn held_and_peak(&self) -> [isize; 2] {
        [&self.now, &self.peak].map(|count| count.load(Ordering::Relaxed))
    }
}

/// What a build takes.
#[derive(Clone, Copy)]
pub struct Cost {
    pub seconds: f64,
    /// Bytes held, and the most held while at work; `None` where nobody counts them.
    pub memory: Option<[isize; 2]>,
}

/// Does `work` and says what it cost.
pub fn cost_of<T>(work: impl FnOnce() -> T) -> (T, Cost) {
    let before = COUNTING.0.now.load(Ordering::Relaxed);
    COUNTING.0.peak.store(before, Ordering::Relaxed);
    let start = Instant::now();
    let made = work();
    let seconds = start.elapsed().as_secs_f64();
    let memory = COUNTING.0.held_and_peak().map(|bytes| bytes - before);
    (
        made,
        Cost {
            seconds,
            memory: Some(memory),
        },
    )
}

struct Counting(Count);

#[global_allocator]
static COUNTING: Counting = Counting(Count::new());

// SAFETY: the system's allocator does the work; sizes are only counted.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        self.0.add(layout.size().cast_signed());
        // SAFETY: as the caller has it.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        self.0.add(-layout.size().cast_signed());
        // SAFETY: as the caller has it.
        unsafe { System.dealloc(block, layout) }
    }
}
