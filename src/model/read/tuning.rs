//! The tuning of a model file.

use super::super::names;
use super::super::schema::{AIMS, Choice, Kind, LIMITS, OBJECTIVE, VARIABLE};
use super::super::tuning::{Aim, Combine, Hold, Limit, Objective, Tune, Variable};
use super::super::types::Spacing;
use super::list::elements;
use super::reader::{Reader, one_of};
use super::rows::no_own;
use super::table::Table;
use super::value::{Node, text};

/// The tuning, if the file has one.
pub(super) fn tune(root: &mut Table<'_>, reader: &mut Reader) -> Option<Tune> {
    let mut table = root.table("tune", reader)?;
    let expected = "an array of tables of path, min and max";
    let mut variables = Vec::new();
    if table.need("variables", expected, reader).is_some() {
        for (path, node) in elements("variables", "tables", &mut table, reader) {
            variables.push(variable(path, node, reader));
        }
    }
    let objectives = objectives(&mut table, reader);
    let combine = table.word("combine", Combine::WORDS, Some(0), reader);
    let limits = elements("limits", "tables", &mut table, reader)
        .into_iter()
        .map(|(path, node)| limit(&path, node, reader))
        .collect();
    table.finish(reader);
    Some(Tune {
        variables,
        objectives,
        combine: combine.map_or_else(Combine::default, |index| Combine::ALL[index]),
        limits,
    })
}

fn variable(path: String, node: Node<'_>, reader: &mut Reader) -> Variable {
    let mut variable = Variable {
        paths: Vec::new(),
        hold: Hold::default(),
        min: f64::NAN,
        max: f64::NAN,
        scale: None,
        tolerance: 0.0,
    };
    let Some(mut table) = Table::open(path, node, reader) else {
        return variable;
    };
    table.rows(
        &mut variable,
        &VARIABLE,
        reader,
        |table, of, kind, reader| {
            if kind == Kind::Paths {
                of.paths = paths(table, reader);
                return;
            }
            table.accept("scale");
            if table.has("scale") {
                let scale = table.word("scale", Spacing::WORDS, None, reader);
                of.scale = scale.map(|index| Spacing::ALL[index]);
            }
        },
    );
    table.finish(reader);
    variable
}

/// `path`, or `paths` in its place.
fn paths(table: &mut Table<'_>, reader: &mut Reader) -> Vec<String> {
    let (one, several) = (table.at("path"), table.at("paths"));
    if !table.has("paths") {
        // Nothing is said of the list that is empty for want of it.
        reader.silence(&several);
        let expected = "a parameter path (or paths, an array of them)";
        let path = table.need("path", expected, reader);
        table.accept("paths");
        return path
            .into_iter()
            .map(|(path, node)| text(&path, node, reader).unwrap_or_default())
            .collect();
    }
    if let Some((path, node)) = table.take("path", reader) {
        let message = "stands beside paths; must be either path or paths";
        reader.fault(node.span().start, &path, message);
    }
    table.accept("path");
    let list = elements("paths", "parameter paths", table, reader);
    if list.len() == 1 {
        reader.alias(one, format!("{several}.1"));
    }
    list.into_iter()
        .map(|(path, node)| text(&path, node, reader).unwrap_or_default())
        .collect()
}

/// `objective`, or `objectives` in its place.
fn objectives(table: &mut Table<'_>, reader: &mut Reader) -> Vec<Objective> {
    let (one, several) = (table.at("objective"), table.at("objectives"));
    if !table.has("objectives") {
        reader.silence(&several);
        let expected = "a table (or objectives, an array of them)";
        let node = table.need("objective", expected, reader);
        table.accept("objectives");
        return node
            .into_iter()
            .map(|(path, node)| objective(path, node, reader))
            .collect();
    }
    if let Some((path, node)) = table.take("objective", reader) {
        let message = "stands beside objectives; must be either objective or objectives";
        reader.fault(node.span().start, &path, message);
    }
    table.accept("objective");
    let list = elements("objectives", "tables", table, reader);
    if list.len() == 1 {
        reader.alias(one, format!("{several}.1"));
    }
    list.into_iter()
        .map(|(path, node)| objective(path, node, reader))
        .collect()
}

/// The keys of which one says what is asked for.
const AIM_KEYS: [&str; 4] = ["minimise", "maximise", "place", "match"];

/// The keys that belong to some aims.
const OF_AIMS: [&str; 6] = ["response", "below", "at", "curve", "columns", "compare"];

fn objective(path: String, node: Node<'_>, reader: &mut Reader) -> Objective {
    let mut objective = Objective {
        aim: Aim::Energy,
        from: f64::NAN,
        to: f64::NAN,
        weight: 1.0,
    };
    let Some(mut table) = Table::open(path, node, reader) else {
        return objective;
    };
    if let Some(choice) = aim(&mut table, reader) {
        let what = match choice.word {
            "" => choice.key.to_owned(),
            word => format!("{} = {word:?}", choice.key),
        };
        objective.aim = chosen(&mut table, &OF_AIMS, choice, &what, reader);
    } else {
        for key in AIM_KEYS.into_iter().chain(OF_AIMS) {
            table.accept(key);
        }
        // Whatever is asked for, it is of this response.
        if table.has("response") {
            objective.aim = Aim::Peak {
                response: table.text("response", None, reader).unwrap_or_default(),
            };
        }
    }
    table.rows(&mut objective, &OBJECTIVE, reader, no_own);
    table.finish(reader);
    objective
}

/// Which of the aims is asked for; none where that cannot be read.
fn aim(table: &mut Table<'_>, reader: &mut Reader) -> Option<&'static Choice<Aim>> {
    let given: Vec<_> = AIM_KEYS.into_iter().filter(|key| table.has(key)).collect();
    let [key] = given[..] else {
        if let [first, others @ ..] = &given[..] {
            for other in others {
                if let Some((path, node)) = table.take(other, reader) {
                    let message = format!(
                        "stands beside {first}; must be only one of {}",
                        AIM_KEYS.join(", ")
                    );
                    reader.fault(node.span().start, &path, message);
                }
            }
        } else {
            let entries = table.entries();
            let slip = entries
                .iter()
                .find_map(|(key, _)| names::nearest(key, AIM_KEYS));
            let expected = "\"peak\", \"mean_square\" or \"energy\" (or maximise, place or match)";
            table.need(slip.unwrap_or("minimise"), expected, reader);
        }
        return None;
    };
    let mut of_key = AIMS.iter().filter(|aim| aim.key == key);
    if key == "match" {
        table.accept(key);
        return of_key.next();
    }
    let words: Vec<_> = of_key.clone().map(|aim| aim.word).collect();
    of_key.nth(table.word(key, &words, None, reader)?)
}

/// What a word says that a table is; `all` are the keys that go with some of its words, and `what` is the word in a
/// message.
fn chosen<'a, T>(
    table: &mut Table<'a>,
    all: &[&'a str],
    choice: &'static Choice<T>,
    what: &str,
    reader: &mut Reader,
) -> T {
    for key in all.iter().filter(|key| !choice.has(key)) {
        if table.has(key)
            && let Some((path, node)) = table.take(key, reader)
        {
            let message = format!("does not belong to {what}; must be left out");
            reader.fault(node.span().start, &path, message);
        }
    }
    let mut chosen = (choice.blank)();
    table.rows(&mut chosen, &choice.rows, reader, no_own);
    chosen
}

/// The keys that belong to some limits.
const OF_LIMITS: [&str; 4] = ["response", "from", "to", "at_most"];

fn limit(path: &str, node: Node<'_>, reader: &mut Reader) -> Limit {
    let unread = Limit::AddedMass { at_most: f64::NAN };
    let Some(mut table) = Table::open(path.to_owned(), node, reader) else {
        return unread;
    };
    let words: Vec<_> = LIMITS.iter().map(|limit| limit.word).collect();
    let Some(index) = table.word("limit", &words, None, reader) else {
        for key in OF_LIMITS {
            table.accept(key);
        }
        table.finish(reader);
        reader.silence(path);
        return unread;
    };
    let choice = &LIMITS[index];
    let what = one_of(&[choice.word]);
    let limit = chosen(&mut table, &OF_LIMITS, choice, &what, reader);
    table.finish(reader);
    limit
}
