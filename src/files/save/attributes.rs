//! The properties of a file other than its text: owner, group, mode, extended attributes (access control lists are some
//! of them) and other names.

use std::fs::{self, Permissions};
use std::io;
use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, chown};
use std::path::Path;

use rustix::fs::{XattrFlags, getxattr, listxattr, removexattr, setxattr};
use rustix::io::Errno;

/// Attributes that depend on the text, so that a new text must not have them.
const OF_THE_TEXT: [&[u8]; 3] = [b"security.capability", b"security.evm", b"security.ima"];

/// The longest list and the longest value of extended attributes on Linux, bytes.
const LONGEST: usize = 1 << 16;

/// Name and value.
type Extended = (Vec<u8>, Vec<u8>);

/// The properties of a file.
#[derive(Debug, PartialEq, Eq)]
struct Attributes {
    owner: u32,
    group: u32,
    mode: u32,
    /// By name.
    extended: Vec<Extended>,
}

/// Copies the properties of a file to its replacement; returns what is lost, in words.
///
/// # Errors
/// The attributes of one of them cannot be read.
pub(super) fn carry(from: &Path, to: &Path) -> io::Result<Vec<&'static str>> {
    let wanted = Attributes::of(from)?;
    wanted.give(to)?;
    let mut lost = wanted.missing(&Attributes::of(to)?);
    if fs::metadata(from)?.nlink() > 1 {
        lost.push("other names (hard links)");
    }
    Ok(lost)
}

impl Attributes {
    fn of(path: &Path) -> io::Result<Self> {
        let found = fs::metadata(path)?;
        Ok(Self {
            owner: found.uid(),
            group: found.gid(),
            mode: found.mode() & 0o7777,
            extended: extended_of(path)?,
        })
    }

    /// Sets all properties that the user may set.
    fn give(&self, path: &Path) -> io::Result<()> {
        let found = fs::metadata(path)?;
        if (found.uid(), found.gid()) != (self.owner, self.group) {
            // The user may be permitted to set the group only.
            let _ = chown(path, Some(self.owner), Some(self.group))
                .or_else(|_| chown(path, None, Some(self.group)));
        }
        give_extended(path, &self.extended);
        // The group bits are also the mask of an access control list; without the list they would grant more.
        let whole = extended_of(path)? == self.extended;
        let mode = if whole { self.mode } else { self.mode & !0o070 };
        // Last, because setting the owner or the list changes it.
        fs::set_permissions(path, Permissions::from_mode(mode))
    }

    /// The properties in which `self` differs from another file.
    fn missing(&self, other: &Self) -> Vec<&'static str> {
        let parts = [
            (self.owner == other.owner, "owner"),
            (self.group == other.group, "group"),
            (self.mode == other.mode, "permissions"),
            (
                self.extended == other.extended,
                "extended attributes or access control list",
            ),
        ];
        let missing = parts.into_iter().filter(|(same, _)| !same);
        missing.map(|(_, name)| name).collect()
    }
}

/// The extended attributes of a file, by name; empty if the file system has none.
fn extended_of(path: &Path) -> io::Result<Vec<Extended>> {
    let mut buffer = vec![0_u8; LONGEST];
    let length = match listxattr(path, &mut buffer[..]) {
        Err(Errno::NOTSUP | Errno::NOSYS) => 0,
        other => other?,
    };
    let names = buffer[..length].split(|byte| *byte == 0);
    let names = names.filter(|name| !name.is_empty() && !OF_THE_TEXT.contains(name));
    let mut value = vec![0_u8; LONGEST];
    let mut all: Vec<Extended> = Vec::new();
    for name in names {
        let length = getxattr(path, name, &mut value[..])?;
        all.push((name.to_vec(), value[..length].to_vec()));
    }
    all.sort();
    Ok(all)
}

/// Sets these extended attributes of a file and removes others, if permitted; the caller compares the result.
fn give_extended(path: &Path, wanted: &[Extended]) {
    let found = extended_of(path).unwrap_or_default();
    for (name, value) in wanted.iter().filter(|one| !found.contains(one)) {
        let _ = setxattr(path, name.as_slice(), value, XattrFlags::empty());
    }
    let is_wanted = |name: &[u8]| wanted.iter().any(|(wanted, _)| wanted == name);
    for (name, _) in found.iter().filter(|(name, _)| !is_wanted(name)) {
        let _ = removexattr(path, name.as_slice());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_lost_is_named() {
        let full = || Attributes {
            owner: 1,
            group: 2,
            mode: 0o640,
            extended: vec![(b"user.a".to_vec(), b"1".to_vec())],
        };
        assert_eq!(full().missing(&full()), [""; 0]);
        let none = Attributes {
            owner: 0,
            group: 0,
            mode: 0,
            extended: Vec::new(),
        };
        let all = [
            "owner",
            "group",
            "permissions",
            "extended attributes or access control list",
        ];
        assert_eq!(full().missing(&none), all);
    }
}
