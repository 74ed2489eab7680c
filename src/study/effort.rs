//! How much of the study is run.

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Cases at each value of each family's parameter.
    pub cases: usize,
    /// The same for whole picks. They are fewer, because their truth tests every triangle.
    pub picks: usize,
    /// Rounds of timing; 0 for none.
    pub rounds: usize,
    /// The seed of the random numbers. The same seed gives the same verdicts on every machine.
    pub seed: u64,
}

impl Effort {
    /// Takes seconds.
    pub const QUICK: Self = Self::new(500, 200, 11);
    /// Takes minutes.
    pub const FULL: Self = Self::new(8000, 4000, 41);

    const fn new(cases: usize, picks: usize, rounds: usize) -> Self {
        Self {
            cases,
            picks,
            rounds,
            seed: 1,
        }
    }
}
