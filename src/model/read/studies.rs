//! The studies of a model file.

use super::super::path::Pattern;
use super::super::spelling;
use super::super::types::{Case, Family, Operation, Study};
use super::list::{elements, named};
use super::reader::Reader;
use super::table::Table;
use super::value::{number, pattern, wrong_type};
use toml::de::DeValue;

/// The list of studies.
pub(super) fn studies(root: &mut Table<'_>, reader: &mut Reader) -> Vec<Study> {
    let list = root.list("studies", "tables", reader);
    named(&list, "studies", reader)
        .into_iter()
        .map(|table| study(table, reader))
        .collect()
}

fn study(table: Option<Table<'_>>, reader: &mut Reader) -> Study {
    let Some(mut table) = table else {
        return Study {
            name: String::new(),
            family: Family::Cases(Vec::new()),
        };
    };
    let name = table.text("name", None, reader).unwrap_or_default();
    let operations: Vec<_> = Operation::ALL
        .into_iter()
        .filter(|operation| table.has(operation.key()))
        .collect();
    let family = if table.has("cases") {
        let other = ["vary"]
            .into_iter()
            .chain(operations.iter().map(|operation| operation.key()));
        let conflicting: Vec<_> = other.filter(|key| table.has(key)).collect();
        for key in &conflicting {
            table.take(key, reader);
        }
        if let [first, ..] = conflicting[..]
            && let Some((path, node)) = table.take(first, reader)
        {
            let message = "cannot be combined with cases; must be either cases, or vary with multiply, set or add";
            reader.fault(node.span().start, &path, message);
        }
        cases(&mut table, reader)
    } else {
        vary(&mut table, &operations, reader)
    };
    for key in ["vary", "multiply", "set", "add", "cases"] {
        table.accept(key);
    }
    table.finish(reader);
    Study { name, family }
}

fn vary(table: &mut Table<'_>, operations: &[Operation], reader: &mut Reader) -> Family {
    let paths: Vec<_> = match table.need("vary", "an array of parameter paths (or cases)", reader) {
        None => Vec::new(),
        Some(_) => elements("vary", "parameter paths", table, reader)
            .into_iter()
            .map(|(path, node)| pattern(&path, node, reader))
            .collect(),
    };
    let operation = operations.first().copied().unwrap_or(Operation::Multiply);
    let values = match operations {
        [] if !table.has("vary") => Vec::new(),
        [] => {
            table.need("multiply", "an array of numbers (or set, or add)", reader);
            Vec::new()
        }
        [operation] => elements(operation.key(), "numbers", table, reader)
            .into_iter()
            .map(|(path, node)| number(&path, node, "a number", reader))
            .collect(),
        [first, others @ ..] => {
            for other in others {
                if let Some((path, node)) = table.take(other.key(), reader) {
                    let message = format!(
                        "cannot be combined with {}; must be only one of multiply, set and add",
                        first.key()
                    );
                    reader.fault(node.span().start, &path, message);
                }
            }
            Vec::new()
        }
    };
    // An unreadable list is empty here; suppress its further faults.
    if operations.len() != 1 {
        for operation in Operation::ALL {
            reader.silence(&table.at(operation.key()));
        }
    }
    Family::Vary {
        paths,
        operation,
        values,
    }
}

fn cases(table: &mut Table<'_>, reader: &mut Reader) -> Family {
    let list = table.list("cases", "tables", reader);
    let path = table.at("cases");
    let mut cases = Vec::new();
    for table in named(&list, &path, reader) {
        let mut case = Case {
            name: String::new(),
            set: Vec::new(),
        };
        if let Some(mut table) = table {
            case.name = table.text("name", None, reader).unwrap_or_default();
            if let Some(set) = table.table("set", reader) {
                case.set = assignments(&set, reader);
            }
            table.finish(reader);
        }
        cases.push(case);
    }
    Family::Cases(cases)
}

/// Paths and numbers, in the order of the text.
fn assignments(set: &Table<'_>, reader: &mut Reader) -> Vec<(Pattern, f64)> {
    let mut assignments = Vec::new();
    for (key, node) in set.entries() {
        let path = set.at(&spelling::segment(key));
        reader.place(&path, node.span().start);
        let value = if let DeValue::Table(_) = node.get_ref() {
            let expected = "a number (put the whole path in one pair of quotes)";
            reader.fault(node.span().start, &path, wrong_type(node, expected));
            f64::NAN
        } else {
            number(&path, node, "a number", reader)
        };
        assignments.push((key.into(), value));
    }
    assignments
}
