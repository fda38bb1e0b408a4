//! Bad model files: `tests/invalid/*.toml` each begin with all faults that reading must report, and no other:
//! `# expect: LINE:COLUMN: PATH: PART OF THE MESSAGE`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::format_push_string)]

use beamtune::model::{self, Fault};
use std::fs;
use std::path::PathBuf;

/// One `# expect:` line.
struct Expected {
    line: usize,
    column: usize,
    path: String,
    part: String,
}

impl Expected {
    fn parse(line: &str) -> Option<Self> {
        let rest = line.strip_prefix("# expect: ")?;
        let mut parts = rest.splitn(3, ": ");
        let (line, column) = parts.next()?.split_once(':')?;
        Some(Self {
            line: line.parse().ok()?,
            column: column.parse().ok()?,
            path: parts.next()?.to_owned(),
            part: parts.next()?.to_owned(),
        })
    }

    fn fits(&self, fault: &Fault) -> bool {
        (fault.line, fault.column) == (Some(self.line), Some(self.column))
            && fault.path == self.path
            && fault.message.contains(&self.part)
    }
}

fn files() -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/invalid");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    files.sort();
    files
}

#[test]
fn every_fault_is_reported_where_it_is_and_no_other() {
    let files = files();
    assert!(files.len() >= 30, "only {} files", files.len());
    let mut failures = String::new();
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        let header: Vec<&str> = text
            .lines()
            .take_while(|line| line.starts_with('#'))
            .collect();
        let expected: Vec<_> = header
            .iter()
            .map(|line| Expected::parse(line).expect(line))
            .collect();
        let faults = model::read(&text).err().unwrap_or_default();
        let fits = expected.len() == faults.len()
            && expected
                .iter()
                .zip(&faults)
                .all(|(one, fault)| one.fits(fault));
        if !fits || faults.is_empty() {
            failures += &format!("{}\n  expected\n", file.display());
            for line in header {
                failures += &format!("    {line}\n");
            }
            failures += "  reported\n";
            for fault in faults {
                failures += &format!("    {fault}\n");
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

/// Every message says what is accepted.
#[test]
fn every_message_says_what_would_be_accepted() {
    for file in files() {
        let text = fs::read_to_string(&file).unwrap();
        for fault in model::read(&text).unwrap_err() {
            let helpful = ["must", "did you mean", "set ", "expected", "duplicate"];
            assert!(
                helpful.iter().any(|word| fault.message.contains(word)),
                "{}: {fault}",
                file.display()
            );
        }
    }
}
