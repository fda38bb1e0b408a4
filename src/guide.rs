//! The guide: how to use the designer and the commands, one module per chapter.
//!
//! `beamtune guide` shows it in a terminal, and the command `guide` of the designer opens its chapters.
//!
//! # Example
//!
//! ```
//! use beamtune::guide;
//!
//! let chapter = guide::find("tuning").expect("a chapter");
//! assert!(chapter.title().starts_with("Tuning: "));
//! // Wrapped for a terminal of 60 columns.
//! assert!(!guide::lines(chapter.markdown, 60).is_empty());
//! ```

mod text;

pub use text::{Kind, Line, lines};

/// A chapter of the guide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Chapter {
    /// The name by which it is opened.
    pub name: &'static str,
    /// Its text, GitHub-flavoured Markdown that begins with the title.
    pub markdown: &'static str,
}

impl Chapter {
    /// The title, one line: the subject, a colon and the summary.
    pub fn title(&self) -> &'static str {
        let first = self.markdown.lines().next().unwrap_or(self.name);
        first.trim_start_matches("# ")
    }

    /// What the chapter explains, one line.
    pub fn summary(&self) -> &'static str {
        let title = self.title();
        title.split_once(": ").map_or(title, |(_, summary)| summary)
    }
}

/// The chapter of this name.
pub fn find(name: &str) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.name == name)
}

/// The list of chapters: a line each, name and summary.
pub fn contents() -> String {
    let widest = CHAPTERS.iter().map(|chapter| chapter.name.len()).max();
    let width = widest.unwrap_or(0);
    let line = |chapter: &Chapter| format!("{:<width$}  {}\n", chapter.name, chapter.summary());
    CHAPTERS.iter().map(line).collect()
}

/// Names a chapter once, so that its name, its file and its module cannot differ.
macro_rules! chapters {
    ($($name:ident),+ $(,)?) => {
        /// All chapters, in the order of reading.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter {
            name: stringify!($name),
            markdown: include_str!(concat!("guide/", stringify!($name), ".md")),
        }),+];
        $(
            #[doc = include_str!(concat!("guide/", stringify!($name), ".md"))]
            // Tables of symbols and units are prose here.
            #[allow(clippy::doc_markdown)]
            pub mod $name {}
        )+
    };
}

chapters!(
    designer,
    analyser,
    measured,
    tuning,
    model,
    commands,
    keys,
    terminal,
    configuration,
    method,
    validation,
    performance,
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chapter_begins_with_a_title_that_fits_in_the_list() {
        for chapter in CHAPTERS {
            assert!(chapter.markdown.starts_with("# "), "{}", chapter.name);
            assert!(chapter.title().contains(": "), "{}", chapter.name);
        }
        for line in contents().lines() {
            assert!(line.chars().count() <= 100, "{line}");
        }
    }

    #[test]
    fn code_fits_in_a_terminal_of_80_columns() {
        for chapter in CHAPTERS {
            for line in lines(chapter.markdown, 80) {
                let width = line.text.chars().count();
                assert!(width <= 80, "{}: {}", chapter.name, line.text);
            }
        }
    }

    /// A block without a language would be compiled as Rust by rustdoc.
    #[test]
    fn every_code_block_names_its_language() {
        for chapter in CHAPTERS {
            let fences = chapter
                .markdown
                .lines()
                .filter(|line| line.starts_with("```"));
            for fence in fences.step_by(2) {
                assert!(["```text", "```toml", "```sh"].contains(&fence), "{fence}");
            }
        }
    }
}
