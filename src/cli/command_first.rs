//! Allows flags to be written before their command.

use super::Cli;
use clap::{Command, CommandFactory};
use std::ffi::OsString;

/// Moves flags that come before a command to the end of the command's own arguments. `args` starts with the program's
/// name. If anything other than flags comes before the command, nothing is moved.
pub(super) fn command_first(mut args: Vec<OsString>) -> Vec<OsString> {
    let cli = Cli::command();
    let mut at = 1;
    while let Some(word) = args.get(at).and_then(|word| word.to_str()) {
        if cli.find_subcommand(word).is_some() {
            let flags: Vec<_> = args.drain(1..at).collect();
            // Nothing after a lone -- is a flag.
            let end = args.iter().position(|word| word == "--");
            let end = end.unwrap_or(args.len());
            args.splice(end..end, flags);
            break;
        }
        if !word.starts_with('-') || word == "--" {
            break;
        }
        at += 1 + usize::from(takes_next(&cli, word));
    }
    args
}

/// Whether a flag of the window or of any command takes the next word as its value.
fn takes_next(cli: &Command, flag: &str) -> bool {
    let commands = std::iter::once(cli).chain(cli.get_subcommands());
    let mut args = commands.flat_map(Command::get_arguments);
    args.any(|arg| {
        let long = flag.strip_prefix("--");
        let is_long = long.is_some() && arg.get_long() == long;
        let is_short = arg.get_short().is_some_and(|c| flag == format!("-{c}"));
        (is_long || is_short) && arg.get_action().takes_values()
    })
}
