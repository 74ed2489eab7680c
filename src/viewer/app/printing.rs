//! Prints picks as lines on stdout, in the order of the clicks, each once its file has answered.

use super::{numbers::file_of, program::App};
use crate::{
    json,
    pick::PickLine,
    viewer::jobs::{Found, Question, ReadingAgain},
};
use std::io::Write;

impl App {
    /// Queues a pick, to be printed once its file has answered.
    pub(super) fn print(&mut self, line: PickLine) {
        let asked = line.hit.as_ref().and_then(|hit| file_of(&self.state, hit));
        let reading = asked.map(|(triangle, file)| {
            ReadingAgain::start(file, Question::Triangle(triangle), self.waker())
        });
        self.numbers.unprinted.push_back((line, reading));
        self.print_known(ReadingAgain::poll);
    }

    /// Prints queued picks, up to the first whose file has not answered yet.
    pub(super) fn print_known(&mut self, answer: impl Fn(&ReadingAgain) -> Option<Found>) {
        while let Some((line, reading)) = self.numbers.unprinted.front_mut() {
            if let Some(reading) = reading {
                match answer(reading) {
                    Some(Found::Triangle(in_file)) => {
                        if let Some(hit) = &mut line.hit {
                            hit.in_file = in_file;
                        }
                    }
                    Some(_) => {}
                    None => return,
                }
            }
            print(line);
            self.numbers.unprinted.pop_front();
        }
    }
}

impl Drop for App {
    /// A window that closes waits for the files' answers about its picks.
    fn drop(&mut self) {
        self.print_known(ReadingAgain::wait);
    }
}

/// Prints a pick as a line on stdout. If the program that reads it is gone, the window goes on all the same.
fn print(line: &PickLine) {
    if let Ok(json) = json::text(line) {
        let mut out = std::io::stdout().lock();
        let _ = writeln!(out, "{json}").and_then(|()| out.flush());
    }
}
