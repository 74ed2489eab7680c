//! The history: steps that can be undone, and steps that can be redone.

/// The history keeps this many steps; older ones are forgotten first.
const MOST: usize = 256;

/// A slide or a drag: all its changes are one step of undo.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum Gesture {
    /// The lens is slid.
    Lens,
    /// The camera's place is dragged.
    Pose,
    /// The section is slid or dragged.
    Section,
    /// An object is dragged.
    Place(usize),
}

/// The history. A step `S` takes one change back, and taking it leaves a step that makes the change again.
pub(super) struct Timeline<S> {
    past: Vec<S>,
    future: Vec<S>,
    gesture: Option<Gesture>,
    /// Whether the gesture has added its step.
    has_step: bool,
    marks: u64,
}

impl<S> Default for Timeline<S> {
    fn default() -> Self {
        Self {
            past: Vec::new(),
            future: Vec::new(),
            gesture: None,
            has_step: false,
            marks: 0,
        }
    }
}

impl<S> Timeline<S> {
    /// A number that was never given before.
    pub fn mark(&mut self) -> u64 {
        self.marks += 1;
        self.marks
    }

    /// Adds the step that takes back what was just done. Within a gesture, only the first change adds a step.
    pub fn push(&mut self, step: S) {
        if std::mem::replace(&mut self.has_step, self.gesture.is_some()) {
            return;
        }
        self.past.push(step);
        self.future.clear();
        if self.past.len() > MOST {
            self.past.remove(0);
        }
    }

    /// A gesture begins or goes on; `None`: the next change is a step of its own.
    pub fn begin(&mut self, gesture: Option<Gesture>) {
        self.has_step &= gesture.is_some() && self.gesture == gesture;
        self.gesture = gesture;
    }

    /// Takes the last step, back or forth.
    pub fn take(&mut self, back: bool) -> Option<S> {
        self.begin(None);
        if back {
            self.past.pop()
        } else {
            self.future.pop()
        }
    }

    /// Keeps the opposite of a step that was taken, back or forth.
    pub fn give(&mut self, step: S, back: bool) {
        if back {
            self.future.push(step);
        } else {
            self.past.push(step);
        }
    }

    /// The step that would be taken next, back or forth.
    pub fn next(&self, back: bool) -> Option<&S> {
        if back {
            self.past.last()
        } else {
            self.future.last()
        }
    }

    /// Forgets all steps. Marks go on counting.
    pub fn clear(&mut self) {
        *self = Self {
            marks: self.marks,
            ..Self::default()
        };
    }
}
