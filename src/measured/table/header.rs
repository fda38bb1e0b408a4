//! Finds the header in the lines above the numbers, and assigns its words to columns by position and count.

use super::column_title::{ColumnTitle, Role};
use super::records::Separator;
use super::tokens::{Token, grouped, joined, placed, split, tokens, with_units};
use crate::unit::ValueUnit;
use crate::unit::{FrequencyUnit, PhaseUnit};

/// Most lines above the numbers that are inspected.
const MOST_LINES: usize = 12;

/// The columns that a header must match.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeaderShape<'a> {
    pub(super) separator: Separator,
    /// Number of columns.
    pub(super) width: usize,
    /// Number of cells in most rows; empty cells at the end are not columns.
    pub(super) cells: usize,
    /// The first rows of numbers, as text.
    pub(super) lines: &'a [&'a str],
}

/// A header.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Header {
    /// One text per column; empty without a header.
    pub(super) cells: Vec<String>,
    /// The words of a header that does not match the columns.
    pub(super) misfit: Vec<String>,
}

impl Header {
    /// Finds the header in the lines above the numbers, nearest first.
    pub(super) fn find<'a>(above: impl Iterator<Item = &'a str>, shape: HeaderShape) -> Self {
        let lines = above.filter(|line| line.contains(char::is_alphanumeric) || line.contains('|'));
        let mut units: Option<Vec<String>> = None;
        let mut is_next = true;
        for line in lines.take(MOST_LINES).map(bare_line) {
            if units.is_none()
                && let Some(found) = row_of_units(line, shape)
            {
                units = Some(found);
                continue;
            }
            if let Some(words) = fitted(line, shape, is_next) {
                let cells = match units {
                    Some(units) => words.iter().zip(units).map(with_unit).collect(),
                    None => words,
                };
                return Self {
                    cells,
                    misfit: Vec::new(),
                };
            }
            let words = split(line, shape.separator);
            if known(&words) >= 2 || known(&texts(joined(tokens(line)))) >= 2 {
                return Self {
                    cells: Vec::new(),
                    misfit: words,
                };
            }
            is_next = false;
        }
        Self {
            cells: units.unwrap_or_default(),
            misfit: Vec::new(),
        }
    }

    /// Finds the header in the cells after the first row of numbers: a name and optionally a unit per column.
    pub(super) fn after_data(words: &[String], shape: HeaderShape) -> Self {
        let filled = words.iter().rposition(|word| !word.trim().is_empty());
        let words = &words[..filled.map_or(0, |last| last + 1)];
        let pairs = words.chunks(2).map(|pair| {
            let unit = pair.get(1).cloned().unwrap_or_default();
            with_unit((&pair[0], unit))
        });
        let line = words.join(" ");
        let blanks = HeaderShape {
            separator: Separator::Blanks,
            ..shape
        };
        let ways = [words.to_vec(), pairs.collect()];
        let fits = |cells: &Vec<String>| cells.len() == shape.width && known(cells) >= 2;
        let cells = ways.into_iter().find(fits);
        let cells = cells.or_else(|| fitted(bare_line(&line), blanks, false).filter(fits));
        let cells = cells.unwrap_or_default();
        Self {
            cells,
            misfit: Vec::new(),
        }
    }
}

/// A line without its comment characters.
fn bare_line(line: &str) -> &str {
    let signs = ['#', '%', '!', '*', '/', '\'', '\u{feff}'];
    let start = line.trim_start();
    if !start.starts_with(signs) {
        return line.trim_end_matches(['\r', '\n']);
    }
    // A tab after the comment character may end an empty cell or have no meaning.
    let rest = start.trim_start_matches(signs).trim_start();
    rest.trim_end_matches(['\r', '\n'])
}

/// Splits a line into one cell per column, by the first method that fits.
fn fitted(line: &str, shape: HeaderShape, is_next: bool) -> Option<Vec<String>> {
    let own = split(line, shape.separator);
    if let Some(cells) = resized(&own, shape) {
        let is_blank = shape.separator == Separator::Blanks;
        // Names only: directly above the numbers, and not the words of a sentence.
        let names = is_next && !is_blank && !cells.iter().any(|cell| is_not_a_name(cell));
        if known(&cells) >= 1 || names {
            return Some(cells);
        }
    }
    let others = Separator::ALL
        .into_iter()
        .filter(|other| *other != Separator::Blanks);
    let words = joined(tokens(line));
    let ways = others
        .map(|other| split(line, other))
        .chain([
            wide(line),
            texts(tokens(line)),
            texts(words.clone()),
            texts(with_units(words.clone(), is_unit)),
        ])
        .chain(by_words(&words, shape.width))
        .chain(by_place(&words, shape));
    ways.filter_map(|cells| resized(&cells, shape))
        .find(|cells| known(cells) >= 2)
}

fn texts(tokens: Vec<Token>) -> Vec<String> {
    tokens.into_iter().map(|token| token.text).collect()
}

/// Splits a line at two or more blanks.
fn wide(line: &str) -> Vec<String> {
    let cells = line.trim().split("  ").map(str::trim);
    cells
        .filter(|cell| !cell.is_empty())
        .map(str::to_owned)
        .collect()
}

/// Groups the words of a line, one group with one known word per column.
fn by_words(words: &[Token], width: usize) -> Option<Vec<String>> {
    let words = with_units(words.to_vec(), is_unit);
    let is_known: Vec<bool> = words.iter().map(|word| is_role(&word.text)).collect();
    let count = is_known.iter().filter(|known| **known).count();
    (count == width).then(|| grouped(&words, &is_known))
}

/// Groups the words of a line by the columns below them; each column needs words, and at most one known word.
fn by_place(words: &[Token], shape: HeaderShape) -> Option<Vec<String>> {
    if shape.separator != Separator::Blanks {
        return None;
    }
    let groups = placed(words, shape.lines, shape.width)?;
    let one_role = |group: &Vec<String>| group.iter().filter(|word| is_role(word)).count() <= 1;
    groups
        .iter()
        .all(one_role)
        .then(|| groups.iter().map(|group| group.join(" ")).collect())
}

/// One cell per column; none if the number of cells does not match.
fn resized(cells: &[String], shape: HeaderShape) -> Option<Vec<String>> {
    let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
    let last = cells
        .iter()
        .rposition(|cell| !cell.is_empty())
        .map_or(0, |last| last + 1);
    if filled < 2.min(shape.width) || cells.len() < shape.width {
        return None;
    }
    if last <= shape.width || last <= shape.cells {
        return Some(cells[..shape.width].to_vec());
    }
    // The comment character may be a separate cell.
    let is_comment = cells[0].is_empty() && last == shape.width + 1;
    is_comment.then(|| cells[1..last].to_vec())
}

/// The cells of a row that contains only units.
fn row_of_units(line: &str, shape: HeaderShape) -> Option<Vec<String>> {
    let others = Separator::ALL.into_iter().map(|other| split(line, other));
    let ways = std::iter::once(split(line, shape.separator))
        .chain(others)
        .chain([texts(tokens(line))]);
    let mut ways = ways.filter_map(|cells| resized(&cells, shape));
    let is_units = |cells: &Vec<String>| {
        let filled = cells.iter().filter(|cell| !bare(cell).is_empty()).count();
        filled >= 1
            && cells
                .iter()
                .all(|cell| is_unit(cell) || matches!(bare(cell), "" | "-"))
    };
    ways.find(is_units)
}

fn with_unit((word, unit): (&String, String)) -> String {
    match bare(&unit) {
        "" | "-" => word.clone(),
        unit if is_unit(unit) || word.trim().is_empty() => {
            format!("{word} [{unit}]").trim().to_owned()
        }
        _ => word.clone(),
    }
}

/// The number of cells with known words or units.
fn known(cells: &[String]) -> usize {
    cells
        .iter()
        .filter(|cell| ColumnTitle::new(cell).is_known())
        .count()
}

/// Whether a word gives the role of a column.
fn is_role(word: &str) -> bool {
    ColumnTitle::new(word).role != Role::Unknown
}

/// Whether a cell cannot be a column name: a number, or a sentence of a preamble.
fn is_not_a_name(cell: &str) -> bool {
    cell.contains(':') || cell.parse::<f64>().is_ok()
}

/// Whether a cell contains only a unit.
fn is_unit(cell: &str) -> bool {
    let word = bare(cell);
    word.eq_ignore_ascii_case("db")
        || FrequencyUnit::from_word(word).is_some()
        || PhaseUnit::from_word(word).is_some()
        || ValueUnit::parse(word).is_ok()
}

/// A word without surrounding brackets.
fn bare(word: &str) -> &str {
    let word = word.trim();
    let inside = |open: char, close: char| {
        let inside = word.strip_prefix(open)?.strip_suffix(close)?;
        // In (m)/(N) the first and the last bracket are not a pair.
        (!inside.contains([open, close])).then_some(inside)
    };
    inside('[', ']').or(inside('(', ')')).unwrap_or(word).trim()
}
