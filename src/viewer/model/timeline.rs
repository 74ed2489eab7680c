//! The history: steps that can be undone, and steps that can be redone.

/// The history keeps this many steps; older ones are forgotten first.
const MOST: usize = 256;

/// A slide or a drag: all its changes are one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gesture {
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
    marks: u64,
}

impl<S> Default for Timeline<S> {
    fn default() -> Self {
        Self {
            past: Vec::new(),
            future: Vec::new(),
            gesture: None,
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

    /// Adds the step that takes back what was just done. Within a gesture, only the first change adds a step. Steps for
    /// which `stays` holds are never forgotten.
    pub fn push(&mut self, gesture: Option<Gesture>, step: S, stays: impl Fn(&S) -> bool) {
        if gesture.is_some() && self.gesture == gesture {
            return;
        }
        self.past.push(step);
        self.future.clear();
        self.gesture = gesture;
        if self.past.len() > MOST
            && let Some(oldest) = self.past.iter().position(|step| !stays(step))
        {
            self.past.remove(oldest);
        }
    }

    /// The next change is a step of its own.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// Takes the last step, back or forth.
    pub fn take(&mut self, back: bool) -> Option<S> {
        self.gesture = None;
        self.steps_mut(back).pop()
    }

    /// Keeps the opposite of a step that was taken, back or forth.
    pub fn give(&mut self, step: S, back: bool) {
        self.steps_mut(!back).push(step);
    }

    /// The steps back or forth; the last one would be taken next.
    pub fn steps(&self, back: bool) -> &[S] {
        if back { &self.past } else { &self.future }
    }

    /// All steps.
    pub fn all(&self) -> impl Iterator<Item = &S> {
        self.past.iter().chain(&self.future)
    }

    /// All steps, to be changed.
    pub fn all_mut(&mut self) -> impl Iterator<Item = &mut S> {
        self.past.iter_mut().chain(&mut self.future)
    }

    /// Takes out the steps, back or forth, that come before the first for which `ends` holds; the next step comes
    /// first.
    pub fn take_near(&mut self, back: bool, ends: impl Fn(&S) -> bool) -> Vec<S> {
        self.gesture = None;
        let steps = self.steps_mut(back);
        let far = steps.iter().rposition(ends).map_or(0, |last| last + 1);
        let mut near = steps.split_off(far);
        near.reverse();
        near
    }

    /// Puts steps back that were taken out, in the same order.
    pub fn put_near(&mut self, back: bool, near: Vec<S>) {
        self.steps_mut(back).extend(near.into_iter().rev());
    }

    fn steps_mut(&mut self, back: bool) -> &mut Vec<S> {
        if back {
            &mut self.past
        } else {
            &mut self.future
        }
    }

    /// A history without steps, whose marks go on counting.
    pub fn fresh(&self) -> Self {
        Self {
            marks: self.marks,
            ..Self::default()
        }
    }
}
