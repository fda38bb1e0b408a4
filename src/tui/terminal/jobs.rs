//! Job control: stopping until the shell goes on with the program.

use std::fs;
use std::io;

use rustix::process::{Signal, getpgrp, kill_current_process_group};
use rustix::termios::tcgetpgrp;

/// Stops the whole job until it is told to go on: the shell waits for all of it, also for a program that stands between
/// it and this one.
pub(super) fn stop() -> io::Result<()> {
    Ok(kill_current_process_group(Signal::STOP)?)
}

/// Whether the job is the one to which the terminal listens. Where the system does not tell, it is.
pub(super) fn is_in_front() -> bool {
    tcgetpgrp(io::stdout()).map_or(true, |front| front == getpgrp())
}

/// Whether there is a shell that can go on with the program once it has stopped.
///
/// There is none where the terminal runs nothing but the program: its process group is then an orphaned one, which the
/// system would not stop by the terminal's stop key either (POSIX.1-2017, 2.4.3). Where the system does not tell, a
/// shell is taken to be there.
pub fn can_suspend() -> bool {
    let Some(own) = process("self") else {
        return true;
    };
    let mut parent = own.parent;
    // A script between the shell and the program is of the same group.
    while parent != 0 {
        match process(&parent.to_string()) {
            Some(one) if one.session != own.session => return false,
            Some(one) if one.group == own.group => parent = one.parent,
            _ => return true,
        }
    }
    false
}

/// What the system knows of a process: the numbers of its parent, its group and its session.
#[derive(Debug, PartialEq, Eq)]
struct Process {
    parent: u32,
    group: u32,
    session: u32,
}

/// From Linux's table of processes (proc(5), /proc/PID/stat).
fn process(id: &str) -> Option<Process> {
    parse(&fs::read_to_string(format!("/proc/{id}/stat")).ok()?)
}

fn parse(stat: &str) -> Option<Process> {
    // The name in parentheses may hold anything, blanks and parentheses too.
    let (_, rest) = stat.rsplit_once(')')?;
    let mut numbers = rest.split_whitespace().skip(1).map(str::parse);
    let mut next = || numbers.next()?.ok();
    Some(Process {
        parent: next()?,
        group: next()?,
        session: next()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_parentheses_is_no_hindrance() {
        let expected = Process {
            parent: 7,
            group: 12,
            session: 5,
        };
        let stat = "12 (a) S 1 (b) S 7 12 5 34816 12 4194304 0";
        assert_eq!(parse(stat), Some(expected));
        assert_eq!(parse("nonsense"), None);
    }
}
