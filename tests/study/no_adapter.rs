//! On a machine without a graphics driver, the study names the rows that it cannot measure and prints the rest.

use sightline::study::{self, Effort};
use std::process::Command;

const NOWHERE: &str = "/nowhere.json";

/// Runs itself in a process that sees no driver.
#[test]
fn what_needs_a_driver_is_named_as_missing_and_the_rest_is_there() {
    if std::env::var("VK_DRIVER_FILES").is_ok_and(|files| files == NOWHERE) {
        return names_what_is_missing();
    }
    let run = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", "--nocapture"])
        .arg("no_adapter::what_needs_a_driver_is_named_as_missing_and_the_rest_is_there")
        .env("VK_DRIVER_FILES", NOWHERE)
        .env("VK_ICD_FILENAMES", NOWHERE)
        .output()
        .expect("the program");
    let said = String::from_utf8_lossy(&run.stdout);
    assert!(said.contains("1 passed") && run.status.success(), "{run:?}");
}

fn names_what_is_missing() {
    let effort = Effort {
        cases: 12,
        picks: 4,
        rounds: 1,
        seed: 1,
    };
    let table = study::table(&study::run(effort, None, &|_, _| {}));
    let without: Vec<&str> = table
        .lines()
        .filter(|line| line.contains("no graphics adapter"))
        .collect();
    let named = [
        "the GPU's ids, drawn and read back",
        "the GPU's ids, one pixel read back",
    ];
    assert_eq!(without.len(), named.len(), "{without:#?}");
    for (row, name) in without.into_iter().zip(named) {
        assert!(row.trim_start().starts_with(name), "{row}");
        assert!(
            row.trim_end().ends_with("no graphics adapter"),
            "nothing is made up: {row}"
        );
    }
    assert!(table.contains("Sightline's without its tree"), "{table}");
}
