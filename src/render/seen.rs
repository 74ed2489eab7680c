//! What a view shows of a scene: the tables' rows, composed when a picture first needs them, and their draw calls. If
//! there are many batches, a thread composes their rows, and drawing takes the rows that are ready.

use super::{
    batches::{Batch, Row},
    gpu::{Gpu, GpuError},
    shader_structs,
    view_rows::{Composer, Draw, Share, ToDraw},
};
use crate::camera::View;
use bytemuck::{Pod, Zeroable};
use std::{
    mem::offset_of,
    sync::{
        Arc, Mutex, MutexGuard, PoisonError, RwLock, RwLockReadGuard,
        mpsc::{Receiver, RecvTimeoutError, channel},
    },
    thread,
    time::Duration,
};
use wgpu::BufferUsages;

/// The rows of up to this many batches are composed at once, which takes no longer than starting a thread.
pub(super) const LITTLE: usize = 1024;
/// How long the drawing of a piece waits for something to draw.
const PATIENCE: Duration = Duration::from_millis(2);

/// The tables that shaders read, each with an extra row for an object drawn by itself.
#[derive(Clone, Debug)]
pub(super) struct Tables {
    gpu: Gpu,
    /// [`shader_structs::Batch`] of each batch of triangles that is seen.
    pub triangles: wgpu::Buffer,
    /// [`shader_structs::Sphere`] of each sphere that is seen.
    pub spheres: wgpu::Buffer,
    /// The extra rows.
    alone: [u32; 2],
}

impl Tables {
    /// Tables for this many batches of triangles and spheres.
    ///
    /// # Errors
    /// When they do not fit.
    pub fn new(gpu: &Gpu, [triangles, spheres]: [u32; 2]) -> Result<Self, GpuError> {
        let rows = vec![shader_structs::Batch::zeroed(); triangles as usize + 1];
        let matrices = gpu.buffer("model matrices", BufferUsages::VERTEX, &rows)?;
        drop(rows);
        let rows = vec![shader_structs::Sphere::zeroed(); spheres as usize + 1];
        Ok(Self {
            gpu: gpu.clone(),
            triangles: matrices,
            spheres: gpu.buffer("spheres", BufferUsages::STORAGE, &rows)?,
            alone: [triangles, spheres],
        })
    }

    /// Writes the extra row, for an object drawn by itself; returns its number.
    pub fn write_alone(&self, row: &Row) -> u32 {
        let at = self.alone[usize::from(matches!(row, Row::Sphere(_)))];
        self.write(at, row);
        at
    }

    /// Sets the triangle that the next draw of a row begins with.
    pub fn begin_at(&self, row: u32, first_triangle: u32) {
        let byte = offset_of!(shader_structs::Batch, first_triangle);
        let at = u64::from(row) * size_of::<shader_structs::Batch>() as u64 + byte as u64;
        let bytes = bytemuck::bytes_of(&first_triangle);
        self.gpu.queue.write_buffer(&self.triangles, at, bytes);
    }

    fn write(&self, at: u32, row: &Row) {
        match row {
            Row::Triangles(row) => self.write_rows(&self.triangles, at, &[*row]),
            Row::Sphere(row) => self.write_rows(&self.spheres, at, &[*row]),
        }
    }

    fn write_share(&self, share: &Share) {
        let [triangles, spheres] = share.before;
        self.write_rows(&self.triangles, triangles, &share.triangles);
        self.write_rows(&self.spheres, spheres, &share.spheres);
    }

    fn write_rows<T: Pod>(&self, table: &wgpu::Buffer, first: u32, rows: &[T]) {
        if !rows.is_empty() {
            let at = u64::from(first) * size_of::<T>() as u64;
            let bytes = bytemuck::cast_slice(rows);
            self.gpu.queue.write_buffer(table, at, bytes);
        }
    }
}

/// What the tables hold.
pub(super) struct Seen {
    pub tables: Tables,
    view: Option<View>,
    /// The draws composed so far.
    pub draws: Vec<Draw>,
    state: State,
    /// Counts the views. A thread that composes for an earlier view writes no more rows.
    turn: Arc<Mutex<u64>>,
}

enum State {
    Nothing,
    UnderWay(Receiver<News>),
    Whole(Box<Composer>),
}

enum News {
    /// Draws whose rows are written.
    Draws(Vec<Draw>),
    /// All rows are written. The composer knows where.
    Whole(Box<Composer>),
}

impl Seen {
    /// The state before the first view.
    pub fn new(tables: Tables) -> Self {
        Self {
            tables,
            view: None,
            draws: Vec::new(),
            state: State::Nothing,
            turn: Arc::default(),
        }
    }

    /// Whether there are no more draws to come.
    pub fn is_whole(&self) -> bool {
        matches!(self.state, State::Whole(_))
    }

    /// Composes the rows of a view, or begins to.
    pub fn prepare(&mut self, all: &Arc<RwLock<ToDraw>>, view: &View) {
        if self.view == Some(*view) {
            return;
        }
        self.forget();
        self.view = Some(*view);
        let ready = read(all);
        if ready.batches.len() <= LITTLE {
            let mut composer = Composer::new(view, &ready);
            while let Some(share) = composer.next(&ready) {
                self.tables.write_share(&share);
                self.draws.extend(share.draws);
            }
            self.state = State::Whole(Box::new(composer));
            return;
        }
        let (sender, news) = channel();
        let (all, tables, view) = (Arc::clone(all), self.tables.clone(), *view);
        let (turn, now) = (Arc::clone(&self.turn), *lock(&self.turn));
        thread::spawn(move || {
            let mut composer = Composer::new(&view, &read(&all));
            loop {
                let share = composer.next(&read(&all));
                let Some(share) = share else { break };
                let current = lock(&turn);
                if *current != now {
                    return;
                }
                tables.write_share(&share);
                drop(current);
                let _ = sender.send(News::Draws(share.draws));
            }
            // The receiver is gone when another view is wanted by now.
            let _ = sender.send(News::Whole(Box::new(composer)));
        });
        self.state = State::UnderWay(news);
    }

    /// Takes the draws composed so far. With `waits` it waits for all of them, else for more than the `known` ones, if
    /// they come soon.
    pub fn take(&mut self, known: usize, waits: bool) {
        while let State::UnderWay(news) = &self.state {
            let has_more = self.draws.len() > known;
            let patience = if has_more { Duration::ZERO } else { PATIENCE };
            let next = if waits {
                news.recv().map_err(|_| RecvTimeoutError::Disconnected)
            } else {
                news.recv_timeout(patience)
            };
            match next {
                Ok(News::Draws(draws)) => self.draws.extend(draws),
                Ok(News::Whole(composer)) => self.state = State::Whole(composer),
                Err(RecvTimeoutError::Timeout) => return,
                Err(RecvTimeoutError::Disconnected) => return self.forget(),
            }
        }
    }

    /// Discards what the tables hold.
    pub fn forget(&mut self) {
        *lock(&self.turn) += 1;
        self.view = None;
        self.draws.clear();
        self.state = State::Nothing;
    }

    /// The row of a batch; `None` if the view does not show it, or rows are still being composed.
    pub fn row_of(&self, batch: u32) -> Option<u32> {
        let State::Whole(composer) = &self.state else {
            return None;
        };
        let row = composer.row_of.get(batch as usize).copied();
        row.filter(|row| *row != u32::MAX)
    }

    /// Updates the row of a batch that changed, but not in its kind or its place in the order.
    pub fn renew(&mut self, number: u32, batch: &Batch) {
        let State::Whole(composer) = &self.state else {
            return self.forget();
        };
        match self.row_of(number) {
            Some(row) => self.tables.write(row, &batch.seen_in(&composer.space)),
            None if batch.shown > 0 && composer.frustum.may_hold(&batch.bounds_world) => {
                self.forget();
            }
            None => {}
        }
    }
}

/// A poisoned lock is safe to use: a panic under it leaves nothing half done.
pub(super) fn read(all: &RwLock<ToDraw>) -> RwLockReadGuard<'_, ToDraw> {
    all.read().unwrap_or_else(PoisonError::into_inner)
}

fn lock(turn: &Mutex<u64>) -> MutexGuard<'_, u64> {
    turn.lock().unwrap_or_else(PoisonError::into_inner)
}
