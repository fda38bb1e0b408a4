//! Job control: stopping until the shell continues the program.

use std::fs;
use std::io;

use rustix::process::{Signal, getpgrp, kill_current_process_group};
use rustix::termios::tcgetpgrp;

/// Stops the whole job until it is continued: the shell waits for all its processes, also for one between the shell and
/// this program.
pub(super) fn stop() -> io::Result<()> {
    Ok(kill_current_process_group(Signal::STOP)?)
}

/// Whether this job is in the foreground of the terminal; assumed if the system does not report it.
pub(super) fn is_in_foreground() -> bool {
    tcgetpgrp(io::stdout()).map_or(true, |front| front == getpgrp())
}

/// Whether there is a shell that can continue the program after a stop.
///
/// There is none if the terminal runs only this program: its process group is then orphaned, and the system does not
/// stop it by the terminal's stop key either (POSIX.1-2017, 2.4.3). If the system does not report it, a shell is assumed.
pub fn can_suspend() -> bool {
    let Some(own) = process("self") else {
        return true;
    };
    let mut parent = own.parent;
    // A script between the shell and the program is in the same group.
    while parent != 0 {
        match process(&parent.to_string()) {
            Some(one) if one.session != own.session => return false,
            Some(one) if one.group == own.group => parent = one.parent,
            _ => return true,
        }
    }
    false
}

/// The ids of a process: parent, process group and session.
#[derive(Debug, PartialEq, Eq)]
struct Process {
    parent: u32,
    group: u32,
    session: u32,
}

/// Reads the ids from Linux's process table (proc(5), /proc/PID/stat).
fn process(id: &str) -> Option<Process> {
    parse(&fs::read_to_string(format!("/proc/{id}/stat")).ok()?)
}

fn parse(stat: &str) -> Option<Process> {
    // The name in parentheses may contain blanks and parentheses.
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
    fn a_name_with_parentheses_is_parsed() {
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
