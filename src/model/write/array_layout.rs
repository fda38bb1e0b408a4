//! The space and the comments around the elements of an array that changes.

use toml_edit::{Array, RawString, Value};

/// The space around the elements of an array.
pub(super) struct ArrayLayout {
    /// A comment after the opening bracket.
    heading: String,
    /// Before the first element.
    first: String,
    /// Before the others.
    other: String,
    /// After the last one, before a comma.
    end: String,
}

impl ArrayLayout {
    /// Reads the layout of an array before a change, and moves its comments to the values that they describe.
    pub(super) fn take(array: &mut Array, old: &mut [Value]) -> Self {
        let heading = join_comments(array, old);
        let first = old.first().and_then(prefix).unwrap_or_default();
        let other = match old.get(1).and_then(prefix) {
            Some(other) => last_line(&other).to_owned(),
            None if first.contains('\n') => last_line(&first).to_owned(),
            None => " ".to_owned(),
        };
        let end = old.last().and_then(suffix).unwrap_or_default();
        let end = if end.contains('#') && !end.contains('\n') {
            ""
        } else {
            last_line(&end)
        };
        let first = if first.contains('#') {
            last_line(&first)
        } else {
            &first
        };
        Self {
            heading,
            first: first.to_owned(),
            other,
            end: end.to_owned(),
        }
    }

    /// Gives values the space of their new positions. A comment stays with its value; one that follows the value moves
    /// after the comma.
    pub(super) fn apply(&self, array: &mut Array, values: &mut [Value], from: &[Option<usize>]) {
        let mut behind = self.heading.clone();
        for (index, value) in values.iter_mut().enumerate() {
            let own = prefix(value).filter(|own| from[index].is_some() && own.contains('#'));
            let before = own.unwrap_or_else(|| {
                if index == 0 {
                    self.first.clone()
                } else {
                    self.other.clone()
                }
            });
            let line_end = if behind.is_empty() || before.starts_with('\n') {
                ""
            } else {
                "\n"
            };
            value
                .decor_mut()
                .set_prefix(std::mem::take(&mut behind) + line_end + &before);
            let comment = suffix(value)
                .filter(|suffix| suffix.contains('#'))
                .unwrap_or_default();
            comment.trim_end().clone_into(&mut behind);
            value.decor_mut().set_suffix("");
        }
        let end = if array.trailing_comma() {
            array.trailing().as_str().unwrap_or_default().to_owned()
        } else {
            self.end.clone()
        };
        let line_end = if behind.is_empty() || end.starts_with('\n') {
            ""
        } else {
            "\n"
        };
        let end = behind + line_end + &end;
        if array.trailing_comma() {
            array.set_trailing(end);
        } else if let Some(last) = values.last_mut() {
            last.decor_mut().set_suffix(end);
        }
    }
}

/// Moves comments after a comma to the value before it, and returns the one after the bracket.
fn join_comments(array: &mut Array, old: &mut [Value]) -> String {
    let mut heading = String::new();
    for index in 0..old.len() {
        let (comment, own) = behind_comma(&prefix(&old[index]).unwrap_or_else(|| {
            if index == 0 {
                String::new()
            } else {
                " ".to_owned()
            }
        }));
        old[index].decor_mut().set_prefix(own);
        if index == 0 {
            heading = comment;
        } else {
            append(&mut old[index - 1], &comment);
        }
    }
    if array.trailing_comma() {
        let (comment, own) = behind_comma(array.trailing().as_str().unwrap_or_default());
        array.set_trailing(own);
        old.last_mut()
            .into_iter()
            .for_each(|last| append(last, &comment));
    }
    heading
}

/// Splits the text after a comma into a comment on the same line and the rest.
fn behind_comma(text: &str) -> (String, String) {
    let line_end = text.find('\n').unwrap_or(text.len());
    let (comment, rest) = text.split_at(line_end);
    if comment.contains('#') {
        (comment.to_owned(), rest.to_owned())
    } else {
        (String::new(), text.to_owned())
    }
}

/// The last line end and what follows it.
fn last_line(text: &str) -> &str {
    text.rfind('\n').map_or(text, |newline| &text[newline..])
}

fn append(value: &mut Value, comment: &str) {
    if !comment.is_empty() {
        let suffix = suffix(value).unwrap_or_default();
        value
            .decor_mut()
            .set_suffix(suffix.trim_end().to_owned() + comment);
    }
}

fn prefix(value: &Value) -> Option<String> {
    value
        .decor()
        .prefix()
        .and_then(RawString::as_str)
        .map(str::to_owned)
}

fn suffix(value: &Value) -> Option<String> {
    value
        .decor()
        .suffix()
        .and_then(RawString::as_str)
        .map(str::to_owned)
}
