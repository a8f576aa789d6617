//! The command `capwalk`, on top of the crate of the same name: the command line ([`args`]), one
//! file for each [`command`], progress bars and interruption ([`progress`]), printed output
//! ([`console`]), and error messages with exit statuses ([`diagnostics`]).

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod args;
mod command;
mod console;
mod diagnostics;
mod direction;
mod memory;
mod method;
mod output;
mod progress;
mod report;
mod source;

use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use args::{Cli, Command};
use diagnostics::Outcome;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(mut error) => {
            diagnostics::advise_on_values(&mut error);
            let asked = matches!(
                error.kind(),
                ErrorKind::DisplayHelp | ErrorKind::DisplayVersion
            );
            if !asked && let Some(text) = diagnostics::shortened(&error.to_string()) {
                console::remark(&text);
                return ExitCode::from(diagnostics::BAD_INPUT);
            }
            let printed = error.print();
            if !asked {
                return ExitCode::from(diagnostics::BAD_INPUT);
            }
            return finish(console::delivered(printed).map(|()| Outcome::Done));
        }
    };
    start_log(cli.verbose);
    let run = || run(&cli.command);
    finish(
        progress::watch_for_stops(cli.command.time_limit()).and_then(|()| {
            match cli.command.threads() {
                None => run(),
                Some(threads) => capwalk::with_threads(threads, run),
            }
        }),
    )
}

/// Runs a command, and says how it ended.
fn run(command: &Command) -> anyhow::Result<Outcome> {
    match command {
        Command::Render(args) => command::render::run(args),
        Command::Gradient(args) => command::gradient::run(args),
        Command::Backward(args) => command::backward::run(args),
        Command::Check(args) => command::check::run(args),
        Command::Info(args) => command::info::run(args),
        Command::Compare(args) => command::compare::run(args),
        Command::Scenes(args) => command::scenes::run(args),
        Command::Optimize(args) => command::optimize::run(args),
        Command::Demo(args) => command::demo::run(args),
        Command::Figures { arguments } => anyhow::bail!(
            "the figures of the paper are made by a program of its own, from a checkout of \
             capwalk: cargo run --release -p capwalk-paper -- figures {}",
            arguments.join(" ")
        ),
    }
}

/// The exit status, after the text of an error.
fn finish(result: anyhow::Result<Outcome>) -> ExitCode {
    match result {
        Ok(outcome) => outcome.into(),
        Err(error) => {
            // Whoever is asked to stop does not know by what.
            let (words, status) = match error.downcast_ref() {
                Some(capwalk::Error::Stopped { before }) if progress::interrupted() => {
                    (progress::stopped(before), diagnostics::INTERRUPTED)
                }
                Some(capwalk::Error::Stopped { before }) => (
                    format!("error: {}", progress::out_of_time(before)),
                    diagnostics::BAD_INPUT,
                ),
                _ => (diagnostics::describe(&error), diagnostics::BAD_INPUT),
            };
            let words = diagnostics::shortened(&words).unwrap_or(words);
            console::remark(&format!("{words}\n"));
            ExitCode::from(status)
        }
    }
}

/// Shows the libraries' warnings, and more if asked to.
fn start_log(verbose: u8) {
    let level = match verbose {
        0 => log::LevelFilter::Warn,
        1 => log::LevelFilter::Info,
        _ => log::LevelFilter::Debug,
    };
    env_logger::Builder::new()
        .filter_level(level)
        .format(|out, record| {
            use std::io::Write;
            let level = record.level().as_str().to_lowercase();
            writeln!(out, "{level}: {}", record.args())
        })
        .init();
}
