//! `shape-up watch`: solves a file again whenever another program saves it.

use super::arguments::Solve;
use super::{Failure, one_line, solve};
use std::fs;
use std::path::Path;
use std::thread;
use std::time::{Duration, SystemTime};

/// How often the file is looked at.
const EVERY: Duration = Duration::from_millis(200);

/// The time and the size of a file, by which a save is noticed.
type Stamp = (SystemTime, u64);

/// Solves until the program is stopped. What is wrong with the input is said, and waited for.
pub(super) fn watch(command: &Solve) -> Result<(), Failure> {
    let (mut last, mut solved) = (None, None);
    loop {
        let now = stamp(&command.input);
        // A file that is still written changes from one look to the next.
        if now.is_some() && now == last && now != solved {
            solved = now;
            match solve::solve(command) {
                Ok(()) => {}
                Err(Failure::Input(message)) => eprintln!("{}", one_line(&message)),
                Err(failure) => return Err(failure),
            }
        }
        last = now;
        thread::sleep(EVERY);
    }
}

/// None while there is no such file: some programs write another one and rename it.
fn stamp(path: &Path) -> Option<Stamp> {
    let about = fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}
