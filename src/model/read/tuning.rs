//! The tuning of a model file.

use super::super::field::Range;
use super::super::names;
use super::super::tuning::{Aim, Combine, Compare, Hold, Limit, Objective, Tune, Variable};
use super::super::types::Spacing;
use super::plans::elements;
use super::reader::{Reader, one_of};
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
    let words = Combine::ALL.map(Combine::key);
    let combine = table.word("combine", &words, Some(0), reader);
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
    variable.paths = paths(&mut table, reader);
    let holds = Hold::ALL.map(Hold::key);
    if let Some(index) = table.word("hold", &holds, Some(0), reader) {
        variable.hold = Hold::ALL[index];
    }
    variable.min = table.number("min", Range::Any, None, reader);
    variable.max = table.number("max", Range::Any, None, reader);
    table.accept("scale");
    if table.has("scale") {
        let scale = table.word("scale", &Spacing::ALL.map(Spacing::key), None, reader);
        variable.scale = scale.map(|index| Spacing::ALL[index]);
    }
    variable.tolerance = table.number("tolerance", Range::NonNegative, Some(0.0), reader);
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

/// What may be asked for: key, word, and the keys that go with it; `match` has a file for its word.
const AIMS: [(&str, &str, &[&str]); 6] = [
    ("minimise", "peak", &["response"]),
    ("minimise", "mean_square", &["response"]),
    ("minimise", "energy", &[]),
    ("maximise", "width", &["response", "below"]),
    ("place", "anti_resonance", &["response", "at"]),
    ("match", "", &["response", "curve", "columns", "compare"]),
];

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
    let found = aim_index(&mut table, reader);
    objective.aim = if let Some(index) = found {
        let (key, word, own) = AIMS[index];
        let aim = if word.is_empty() {
            key.to_owned()
        } else {
            format!("{key} = {word:?}")
        };
        foreign(&mut table, &OF_AIMS, own, &aim, reader);
        aim_of(index, &mut table, reader)
    } else {
        for key in AIM_KEYS.into_iter().chain(OF_AIMS) {
            table.accept(key);
        }
        // Whatever is sought, it is of this response.
        if table.has("response") {
            Aim::Peak {
                response: table.text("response", None, reader).unwrap_or_default(),
            }
        } else {
            Aim::Energy
        }
    };
    objective.from = table.number("from", Range::Positive, None, reader);
    objective.to = table.number("to", Range::Positive, None, reader);
    objective.weight = table.number("weight", Range::Positive, Some(1.0), reader);
    table.finish(reader);
    objective
}

/// Which of the aims is asked for; none where that cannot be read.
fn aim_index(table: &mut Table<'_>, reader: &mut Reader) -> Option<usize> {
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
    let of_key = || (0..AIMS.len()).filter(|index| AIMS[*index].0 == key);
    if key == "match" {
        table.accept(key);
        return of_key().next();
    }
    let words: Vec<_> = of_key().map(|index| AIMS[index].1).collect();
    let word = table.word(key, &words, None, reader)?;
    of_key().nth(word)
}

/// The aim with its own keys.
fn aim_of(index: usize, table: &mut Table<'_>, reader: &mut Reader) -> Aim {
    let (_, _, own) = AIMS[index];
    if !own.contains(&"response") {
        return Aim::Energy;
    }
    let response = table.text("response", None, reader).unwrap_or_default();
    match AIMS[index].1 {
        "peak" => Aim::Peak { response },
        "mean_square" => Aim::MeanSquare { response },
        "width" => Aim::Width {
            response,
            below: table.number("below", Range::Positive, None, reader),
        },
        "anti_resonance" => Aim::AntiResonance {
            response,
            at: table.number("at", Range::Positive, None, reader),
        },
        _ => matched(response, table, reader),
    }
}

fn matched(response: String, table: &mut Table<'_>, reader: &mut Reader) -> Aim {
    let file = table.text("match", None, reader).unwrap_or_default();
    let mut optional = |key| {
        table.accept(key);
        let is_there = table.has(key);
        is_there.then(|| table.text(key, None, reader)).flatten()
    };
    let (curve, columns) = (optional("curve"), optional("columns"));
    let words = Compare::ALL.map(Compare::key);
    let compare = table.word("compare", &words, Some(0), reader);
    Aim::Match {
        response,
        file,
        curve,
        columns,
        compare: compare.map_or_else(Compare::default, |index| Compare::ALL[index]),
    }
}

/// Says which keys belong to something else than what the table is.
fn foreign<'a>(
    table: &mut Table<'a>,
    all: &[&'a str],
    own: &[&str],
    what: &str,
    reader: &mut Reader,
) {
    for key in all.iter().filter(|key| !own.contains(key)) {
        if table.has(key)
            && let Some((path, node)) = table.take(key, reader)
        {
            let message = format!("does not belong to {what}; must be left out");
            reader.fault(node.span().start, &path, message);
        }
    }
}

/// What may be limited, and the keys that go with it.
const LIMITS: [(&str, &[&str]); 3] = [
    ("added_mass", &["at_most"]),
    ("no_mode", &["from", "to"]),
    ("static_deflection", &["response", "at_most"]),
];

/// The keys that belong to some limits.
const OF_LIMITS: [&str; 4] = ["response", "from", "to", "at_most"];

fn limit(path: &str, node: Node<'_>, reader: &mut Reader) -> Limit {
    let unread = Limit::AddedMass { at_most: f64::NAN };
    let Some(mut table) = Table::open(path.to_owned(), node, reader) else {
        return unread;
    };
    let words = LIMITS.map(|(word, _)| word);
    let Some(index) = table.word("limit", &words, None, reader) else {
        for key in OF_LIMITS {
            table.accept(key);
        }
        table.finish(reader);
        reader.silence(path);
        return unread;
    };
    let (word, own) = LIMITS[index];
    foreign(&mut table, &OF_LIMITS, own, &one_of(&[word]), reader);
    let limit = match word {
        "added_mass" => Limit::AddedMass {
            at_most: table.number("at_most", Range::Positive, None, reader),
        },
        "no_mode" => Limit::NoMode {
            from: table.number("from", Range::NonNegative, None, reader),
            to: table.number("to", Range::Positive, None, reader),
        },
        _ => Limit::StaticDeflection {
            response: table.text("response", None, reader).unwrap_or_default(),
            at_most: table.number("at_most", Range::Positive, None, reader),
        },
    };
    table.finish(reader);
    limit
}
