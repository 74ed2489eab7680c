//! Shares, their intervals, and quantiles.

/// The ends of a share's 95 % interval by Wilson (JASA 22, 1927). For 0 of n they are 0 and 3 / n.
pub(super) fn interval(some: usize, of: usize) -> [f64; 2] {
    const Z2: f64 = 1.96 * 1.96;
    if some == 0 {
        return [0.0, rate(3, of).min(1.0)];
    }
    let (p, per_n) = (rate(some, of), rate(1, of));
    let half = (Z2 * per_n * (p * (1.0 - p) + 0.25 * Z2 * per_n)).sqrt();
    [-half, half].map(|half| (p + 0.5 * Z2 * per_n + half) / (1.0 + Z2 * per_n))
}

/// The share `some / of`; 0 for 0 of 0.
#[expect(clippy::cast_precision_loss, reason = "millions at most")]
pub(super) fn rate(some: usize, of: usize) -> f64 {
    some as f64 / of.max(1) as f64
}

/// The value that a given share of the sorted values does not exceed; 0 if there are no values.
pub(super) fn quantile(sorted: &[f64], share: f64) -> f64 {
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "millions at most"
    )]
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(0.0)
}
