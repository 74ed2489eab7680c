//! A command line, a word a line: it is refused in words, or a pick's positions and radius in it can be used.

#![no_main]

use clap::Parser;
use libfuzzer_sys::fuzz_target;
use sightline::cli::{At, Cli, Command};

fuzz_target!(|text: &str| {
    let words = std::iter::once("sightline").chain(text.lines());
    match Cli::try_parse_from(words) {
        Ok(Cli {
            command: Some(Command::Pick(pick)),
            ..
        }) => {
            for at in pick.at {
                assert!(!matches!(at, At::Px(px) if !px.is_finite()));
            }
            assert!(
                !pick
                    .snap
                    .is_some_and(|radius_px| !(radius_px >= 0.0 && radius_px.is_finite()))
            );
        }
        Ok(_) => {}
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
