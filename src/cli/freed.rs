//! Gives freed memory back to the system.

#![cfg_attr(
    all(target_os = "linux", target_env = "gnu"),
    expect(unsafe_code, reason = "see SAFETY")
)]

/// From here on each block of 4 MiB or more goes back to the system when it is freed. By itself, glibc raises this
/// size up to 32 MiB as such blocks are freed; what is then freed below smaller blocks that live on stays with the
/// program: 90 of the 490 MB that a picture of a noisy scan of two million triangles takes.
pub(super) fn give_back() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: it sets a number of the allocator, under the allocator's own lock.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, 4 << 20);
    }
}

#[cfg(all(test, target_os = "linux", target_env = "gnu"))]
mod tests {
    use super::give_back;
    use std::{fs, hint::black_box};

    fn resident_mb() -> f64 {
        let status = fs::read_to_string("/proc/self/status").expect("this process");
        let resident = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
        let kb = resident.and_then(|kb| kb.trim().strip_suffix(" kB"));
        kb.expect("in kB").parse::<f64>().expect("a number") / 1024.0
    }

    /// Large blocks with a small one that lives on after each. Once they are freed, others of their size are freed, too:
    /// then glibc would keep such blocks.
    #[test]
    fn blocks_below_others_are_given_back() {
        give_back();
        let large = || black_box(vec![1_u8; 20 << 20]);
        drop(large());
        let before = resident_mb();
        let blocks: Vec<_> = (0..10)
            .map(|_| (large(), black_box(vec![1_u8; 5000])))
            .collect();
        let with = resident_mb();
        let (freed, kept): (Vec<_>, Vec<_>) = blocks.into_iter().unzip();
        drop(freed);
        let after = resident_mb();
        assert_eq!(kept.len(), 10);
        assert!(with - before > 150.0, "{before} MB, then {with} MB");
        assert!(after - before < 50.0, "{before} MB, {with} MB, {after} MB");
    }
}
