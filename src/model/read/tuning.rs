//! The tuning of a model file.

use super::super::path::Pattern;
use super::super::schema::{AIMS, Asked, Choice, Kind, LIMITS, OBJECTIVE, VARIABLE};
use super::super::spelling;
use super::super::tuning::{Aim, Combine, Hold, Limit, Objective, Tune, Variable};
use super::super::types::Spacing;
use super::list::elements;
use super::reader::{Reader, one_of};
use super::rows::no_own;
use super::table::Table;
use super::value::{Node, pattern};

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

/// The values of a key, or of the list that replaces it; `expected` describes the key and the list.
fn one_or_several<'a>(
    [one, several]: [&'static str; 2],
    [expected, of]: [&str; 2],
    table: &mut Table<'a>,
    reader: &mut Reader,
) -> Vec<(String, Node<'a>)> {
    let [at_one, at_several] = [one, several].map(|key| table.at(key));
    if !table.has(several) {
        // Suppress the fault of the empty list, which results from the missing key.
        reader.silence(&at_several);
        let node = table.need(one, expected, reader);
        table.accept(several);
        return node.into_iter().collect();
    }
    if let Some((path, node)) = table.take(one, reader) {
        let message =
            format!("cannot be combined with {several}; must be either {one} or {several}");
        reader.fault(node.span().start, &path, message);
    }
    table.accept(one);
    let list = elements(several, of, table, reader);
    if list.len() == 1 {
        reader.alias(at_one, format!("{at_several}.1"));
    }
    list
}

fn paths(table: &mut Table<'_>, reader: &mut Reader) -> Vec<Pattern> {
    let expected = "a parameter path (or paths, an array of them)";
    one_or_several(
        ["path", "paths"],
        [expected, "parameter paths"],
        table,
        reader,
    )
    .into_iter()
    .map(|(path, node)| pattern(&path, node, reader))
    .collect()
}

fn objectives(table: &mut Table<'_>, reader: &mut Reader) -> Vec<Objective> {
    let expected = "a table (or objectives, an array of them)";
    one_or_several(
        ["objective", "objectives"],
        [expected, "tables"],
        table,
        reader,
    )
    .into_iter()
    .map(|(path, node)| objective(path, node, reader))
    .collect()
}

/// The keys of which one selects the aim.
const AIM_KEYS: [&str; 4] = ["minimise", "maximise", "place", "match"];

/// The keys that belong to some aims.
const OF_AIMS: [&str; 6] = ["response", "below", "at", "curve", "columns", "compare"];

fn objective(path: String, node: Node<'_>, reader: &mut Reader) -> Objective {
    let mut objective = Objective {
        aim: Aim::Energy,
        response: None,
        from: f64::NAN,
        to: f64::NAN,
        weight: 1.0,
    };
    let Some(mut table) = Table::open(path, node, reader) else {
        return objective;
    };
    let choice = aim(&mut table, reader);
    table.rows(
        &mut objective,
        &OBJECTIVE,
        reader,
        // The aim determines whether there is a response.
        |table, of, _, reader| aim_and_response(table, of, choice, reader),
    );
    table.finish(reader);
    objective
}

/// The aim of an objective and its response.
fn aim_and_response(
    table: &mut Table<'_>,
    of: &mut Objective,
    choice: Option<&'static Choice<Aim>>,
    reader: &mut Reader,
) {
    let response = |table: &mut Table<'_>, reader: &mut Reader| {
        Some(table.text("response", None, reader).unwrap_or_default())
    };
    if let Some(choice) = choice {
        let what = match choice.word {
            "" => choice.key.to_owned(),
            word => format!("{} = {word:?}", choice.key),
        };
        leave_out(table, &OF_AIMS, choice, &what, reader);
        if choice.response != Asked::Nothing {
            of.response = response(table, reader);
        }
        of.aim = chosen(table, choice, reader);
        return;
    }
    for key in AIM_KEYS.into_iter().chain(OF_AIMS) {
        table.accept(key);
    }
    // Every aim may have this response.
    if table.has("response") {
        of.aim = Aim::Peak;
        of.response = response(table, reader);
    }
}

/// The selected aim; none if unreadable.
fn aim(table: &mut Table<'_>, reader: &mut Reader) -> Option<&'static Choice<Aim>> {
    let given: Vec<_> = AIM_KEYS.into_iter().filter(|key| table.has(key)).collect();
    let [key] = given[..] else {
        if let [first, others @ ..] = &given[..] {
            for other in others {
                if let Some((path, node)) = table.take(other, reader) {
                    let message = format!(
                        "cannot be combined with {first}; must be only one of {}",
                        AIM_KEYS.join(", ")
                    );
                    reader.fault(node.span().start, &path, message);
                }
            }
        } else {
            let entries = table.entries();
            let slip = entries
                .iter()
                .find_map(|(key, _)| spelling::nearest(key, AIM_KEYS));
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

/// Reports keys that belong to other choices; `all` belong to some choice, `what` is the choice in a message.
fn leave_out<'a, T>(
    table: &mut Table<'a>,
    all: &[&'a str],
    choice: &Choice<T>,
    what: &str,
    reader: &mut Reader,
) {
    for key in all.iter().filter(|key| !choice.has(key)) {
        if table.has(key)
            && let Some((path, node)) = table.take(key, reader)
        {
            let message = format!("does not belong to {what}; must be omitted");
            reader.fault(node.span().start, &path, message);
        }
    }
}

/// The keys of a choice.
fn chosen<T>(table: &mut Table<'_>, choice: &'static Choice<T>, reader: &mut Reader) -> T {
    let mut chosen = (choice.blank)();
    table.rows(&mut chosen, &choice.rows, reader, no_own);
    chosen
}

/// The keys that belong to some limits.
const OF_LIMITS: [&str; 5] = ["response", "from", "to", "at_most", "at_least"];

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
    leave_out(&mut table, &OF_LIMITS, choice, &what, reader);
    let limit = chosen(&mut table, choice, reader);
    table.finish(reader);
    limit
}
