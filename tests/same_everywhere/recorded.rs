//! Records of picks are the recorded bytes.

use super::results;
use std::{fs, path::Path};

/// `SIGHTLINE_GOLDENS=write` records anew.
#[test]
fn picks_print_the_recorded_bytes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/same_everywhere/recorded.txt");
    let results = results(|_| {});
    if std::env::var_os("SIGHTLINE_GOLDENS").is_some_and(|what| what == "write") {
        fs::write(&path, &results).expect("a writable folder");
    }
    let recorded = fs::read_to_string(&path).expect("the recorded results");
    for (what, least) in [("\"object\":", 60), ("\"exact\":true", 10)] {
        let count = recorded.matches(what).count();
        assert!(count >= least, "{count} of {what}");
    }
    for (found, recorded) in results.lines().zip(recorded.lines()) {
        assert_eq!(found, recorded);
    }
    assert_eq!(results.lines().count(), recorded.lines().count());
}
