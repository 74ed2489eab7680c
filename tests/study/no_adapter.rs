//! On a machine without a graphics driver, the study names the rows that it cannot measure and prints the rest.

use std::process::Command;

#[test]
fn what_needs_a_driver_is_named_as_missing_and_the_rest_is_there() {
    let nowhere = "/nowhere.json";
    let run = Command::new(env!("CARGO_BIN_EXE_sightline"))
        .args(["study", "--quick"])
        .env("VK_DRIVER_FILES", nowhere)
        .env("VK_ICD_FILENAMES", nowhere)
        .output()
        .expect("the program");
    assert!(run.status.success(), "{run:?}");
    let table = String::from_utf8(run.stdout).expect("text");
    let without: Vec<&str> = table
        .lines()
        .filter(|line| line.contains("no graphics adapter"))
        .collect();
    let named = ["ids, drawn and read back", "ids, one pixel read back"];
    assert_eq!(without.len(), named.len(), "{without:#?}");
    for (row, name) in without.into_iter().zip(named) {
        assert!(row.trim_start().starts_with(name), "{row}");
        assert!(
            row.trim_end().ends_with("no graphics adapter"),
            "nothing is made up: {row}"
        );
    }
    assert!(
        table.contains("Sightline's, a triangle at a time"),
        "{table}"
    );
}
