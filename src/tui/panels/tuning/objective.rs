//! The objectives of a search: a figure of the first curve in the marked band, and limits.

use std::sync::Arc;

use crate::model::{Aim, Combine, Compare, Fault, Limit, Model, Objective, value_input};
use crate::tui::app::{App, Effect, Overlay, Purpose, Question};

/// The parsed input.
#[derive(Debug, PartialEq)]
enum Typed {
    /// An objective, and whether it is added to the existing ones.
    Objective { objective: Objective, added: bool },
    /// How several objectives are combined.
    Combine(Combine),
    /// A limit.
    Limit(Limit),
    /// Removes all limits.
    NoLimits,
}

impl App {
    /// Prompts for the objective of the first curve in the marked band.
    pub(crate) fn ask_objective(&mut self) {
        if self.model().tune.is_none() {
            let key = self
                .keys
                .key_of(crate::tui::keys::TuneCommand::TuneVariable);
            return self.refuse(format!(
                "no variables yet: {key} adds the selected parameter"
            ));
        }
        let Some(response) = self.curves.visible.first().cloned() else {
            return self.refuse("no visible response can be tuned");
        };
        let [from, to] = self.tuned_band();
        let [low, high] = [from, to].map(|f| self.display.frequency_text(f));
        let question = Question::Objective {
            subject: format!("{response}, {low} to {high}"),
            response,
            band: [from, to],
        };
        self.ask_question(question, "peak".to_owned());
    }

    /// The file to read before an objective is accepted: the measured curve of a match.
    pub(crate) fn check_objective(
        &self,
        response: &str,
        band: [f64; 2],
        text: &str,
    ) -> Option<Effect> {
        let Ok(Typed::Objective { objective, .. }) = read_objective(text, response, band) else {
            return None;
        };
        let is_match = matches!(objective.aim, Aim::Match { .. });
        is_match.then(|| Effect::CheckMatch {
            model: Arc::clone(self.model()),
            objective: Box::new(objective),
            folder: self.document.source().folder().to_owned(),
        })
    }

    /// Applies the typed objective after its measured curve was read, or shows in the prompt why it is refused.
    pub(crate) fn match_checked(&mut self, checked: Result<(), Fault>) {
        let Some(Overlay::Prompt(prompt)) = &self.overlay else {
            return;
        };
        let Purpose::Ask(Question::Objective { response, band, .. }) = prompt.purpose.clone()
        else {
            return;
        };
        let text = prompt.input.value().trim().to_owned();
        let taken = match checked {
            Ok(()) => self.take_objective(&response, band, &text),
            Err(fault) => Err(fault.to_string().trim_start_matches("tune: ").to_owned()),
        };
        match taken {
            Ok(()) => self.overlay = None,
            Err(refusal) => self.refuse_prompt(refusal),
        }
    }

    /// Applies the typed text.
    ///
    /// # Errors
    /// Why it is refused, in one line.
    pub(crate) fn take_objective(
        &mut self,
        response: &str,
        band: [f64; 2],
        text: &str,
    ) -> Result<(), String> {
        let typed = read_objective(text, response, band)?;
        let mut changed = Model::clone(self.model());
        let tune = changed.tune.as_mut().ok_or("no variables yet")?;
        let words = match typed {
            Typed::Objective { objective, added } => {
                if !added {
                    tune.objectives.clear();
                }
                tune.objectives.push(objective);
                format!("objective: {text}")
            }
            Typed::Combine(combine) => {
                tune.combine = combine;
                format!("objectives: {}", combine.key())
            }
            Typed::Limit(limit) => {
                tune.limits.push(limit);
                text.to_owned()
            }
            Typed::NoLimits => {
                tune.limits.clear();
                "remove all limits".to_owned()
            }
        };
        self.take_tune(words, changed)
    }

    /// Removes an objective; the last one stays.
    pub(crate) fn drop_objective(&mut self, index: usize) {
        let mut changed = Model::clone(self.model());
        let Some(tune) = &mut changed.tune else {
            return;
        };
        if tune.objectives.len() == 1 {
            let key = self
                .keys
                .key_of(crate::tui::keys::TuneCommand::TuneObjective);
            return self.refuse(format!("one objective is needed: {key} adds another one"));
        }
        tune.objectives.remove(index);
        if let Err(reason) = self.take_tune("remove an objective".to_owned(), changed) {
            self.refuse(reason);
        }
    }

    /// Removes a limit.
    pub(crate) fn drop_limit(&mut self, index: usize) {
        let mut changed = Model::clone(self.model());
        let Some(tune) = &mut changed.tune else {
            return;
        };
        tune.limits.remove(index);
        if let Err(reason) = self.take_tune("remove a limit".to_owned(), changed) {
            self.refuse(reason);
        }
    }
}

/// Parses the text for a response and a band.
fn read_objective(text: &str, response: &str, band: [f64; 2]) -> Result<Typed, String> {
    const FORM: &str = "peak, mean square, energy, width LEVEL, anti-resonance HZ, match FILE, match FILE columns hz; re im; m/N; + adds one, x 2 weighs it; sum, worst; limit mass KG, limit modes, limit peak SIZE, limit static SIZE, limit buckling FACTOR, no limits";
    let text = text.trim();
    match text {
        "sum" => return Ok(Typed::Combine(Combine::Sum)),
        "worst" => return Ok(Typed::Combine(Combine::Worst)),
        "no limits" => return Ok(Typed::NoLimits),
        _ => {}
    }
    if let Some(limit) = text.strip_prefix("limit ") {
        return read_limit(limit.trim(), response, band).map(Typed::Limit);
    }
    let (added, text) = match text.strip_prefix('+') {
        Some(rest) => (true, rest.trim()),
        None => (false, text),
    };
    let (what, weight) = match text.rsplit_once(" x ") {
        Some((what, weight)) => (what.trim(), number(weight)?),
        None => (text, 1.0),
    };
    let (word, rest) = what.split_once(' ').unwrap_or((what, ""));
    let rest = rest.trim();
    let aim = match (word, rest) {
        ("peak", "") => Aim::Peak,
        ("mean", "square") | ("mean_square", "") => Aim::MeanSquare,
        ("energy", "") => Aim::Energy,
        ("width", level) if !level.is_empty() => Aim::Width {
            below: number(level)?,
        },
        ("anti-resonance", at) if !at.is_empty() => Aim::AntiResonance {
            at: number(at.trim_end_matches("Hz"))?,
        },
        ("match", rest) if !rest.is_empty() => matched(rest),
        _ => return Err(FORM.to_owned()),
    };
    let objective = Objective {
        response: (aim != Aim::Energy).then(|| response.to_owned()),
        aim,
        from: band[0],
        to: band[1],
        weight,
    };
    Ok(Typed::Objective { objective, added })
}

/// A match of a file, optionally with a description of its columns.
fn matched(text: &str) -> Aim {
    let (file, columns) = match text.split_once(" columns ") {
        Some((file, columns)) => (file, Some(columns)),
        None => (text, None),
    };
    // Also as in a model file: columns = "..".
    let bare = |columns: &str| {
        columns
            .trim()
            .trim_start_matches('=')
            .trim()
            .trim_matches('"')
            .to_owned()
    };
    Aim::Match {
        file: file.trim().to_owned(),
        curve: None,
        columns: columns.map(bare),
        compare: Compare::LogMagnitude,
    }
}

fn read_limit(text: &str, response: &str, [from, to]: [f64; 2]) -> Result<Limit, String> {
    match text.split_once(' ').unwrap_or((text, "")) {
        ("mass", most) => Ok(Limit::AddedMass {
            at_most: number(most.trim_end_matches("kg"))?,
        }),
        ("modes", "") => Ok(Limit::NoMode { from, to }),
        ("peak", most) => Ok(Limit::Peak {
            response: response.to_owned(),
            at_most: number(most)?,
        }),
        ("static", most) => Ok(Limit::StaticDeflection {
            response: response.to_owned(),
            at_most: number(most)?,
        }),
        ("buckling", least) => Ok(Limit::Buckling {
            at_least: number(least)?,
        }),
        _ => Err(
            "limit mass KG, limit modes (none in the band), limit peak SIZE, limit static SIZE or limit buckling FACTOR"
                .to_owned(),
        ),
    }
}

fn number(text: &str) -> Result<f64, String> {
    let text = text.trim();
    text.parse().map_err(|_| {
        value_input::decimal_comma(text).unwrap_or_else(|| format!("{text} is not a number"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Typed, String> {
        read_objective(text, "tip", [10.0, 20.0])
    }

    /// The text for an aim, for the response and the band of [`read`].
    fn objective(aim: Aim) -> Objective {
        Objective {
            response: (aim != Aim::Energy).then(|| "tip".to_owned()),
            aim,
            from: 10.0,
            to: 20.0,
            weight: 1.0,
        }
    }

    fn alone(aim: Aim) -> Typed {
        Typed::Objective {
            objective: objective(aim),
            added: false,
        }
    }

    #[test]
    fn objectives_are_read_from_words() {
        let aims = [
            ("peak", Aim::Peak),
            ("mean square", Aim::MeanSquare),
            ("energy", Aim::Energy),
            ("width 1e-7", Aim::Width { below: 1e-7 }),
            ("anti-resonance 15 Hz", Aim::AntiResonance { at: 15.0 }),
        ];
        for (text, aim) in aims {
            assert_eq!(read(text), Ok(alone(aim)), "{text}");
        }
        for text in [
            "match run 7.csv columns hz 1; re 8; im 9; m/N",
            "match run 7.csv columns = \"hz 1; re 8; im 9; m/N\"",
        ] {
            let matched = Aim::Match {
                file: "run 7.csv".to_owned(),
                curve: None,
                columns: Some("hz 1; re 8; im 9; m/N".to_owned()),
                compare: Compare::LogMagnitude,
            };
            assert_eq!(read(text), Ok(alone(matched)), "{text}");
        }
        let added = Typed::Objective {
            objective: Objective {
                weight: 2.5,
                ..objective(Aim::Energy)
            },
            added: true,
        };
        assert_eq!(read("+ energy x 2.5"), Ok(added));
        assert_eq!(read("worst"), Ok(Typed::Combine(Combine::Worst)));
        for wrong in [
            "",
            "peaks",
            "width",
            "anti-resonance",
            "match",
            "peak x two",
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn limits_are_read_from_words() {
        let mass = Limit::AddedMass { at_most: 300.0 };
        let modes = Limit::NoMode {
            from: 10.0,
            to: 20.0,
        };
        assert_eq!(read("limit mass 300 kg"), Ok(Typed::Limit(mass)));
        assert_eq!(read("limit modes"), Ok(Typed::Limit(modes)));
        let buckling = Limit::Buckling { at_least: 2.5 };
        assert_eq!(read("limit buckling 2.5"), Ok(Typed::Limit(buckling)));
        assert_eq!(read("no limits"), Ok(Typed::NoLimits));
        for wrong in ["limit weight 3", "limit buckling", "limit buckling twice"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
