//! Ends the program on a signal without leaving unfinished files behind.

#[cfg(unix)]
use {
    crate::replace::remove_unfinished,
    signal_hook::{
        consts::{SIGHUP, SIGINT, SIGTERM},
        iterator::Signals,
        low_level::emulate_default_handler,
    },
    std::{fs, thread},
};

/// From now on a signal that ends the program first removes the files that are being written.
#[cfg(unix)]
pub(super) fn clean_up_on_signals() {
    let wait = || {
        let ignored = ignored();
        let ending = [SIGHUP, SIGINT, SIGTERM].into_iter();
        let ending = ending.filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let Ok(mut signals) = Signals::new(ending) else {
            return;
        };
        for signal in signals.forever() {
            remove_unfinished();
            // The program ends here, as from the signal itself.
            let _ = emulate_default_handler(signal);
        }
    };
    // Where the system gives no more threads, a signal ends the program as before.
    let _ = thread::Builder::new().spawn(wait);
}

/// The signals that the program was started with as ignored, as by `nohup`, a bit each. They stay so. Only Linux tells.
#[cfg(unix)]
fn ignored() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mut lines = status.lines();
    let ignored = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
    ignored.unwrap_or(0)
}

/// The system ends the program and knows nothing of its files.
#[cfg(not(unix))]
pub(super) fn clean_up_on_signals() {}
