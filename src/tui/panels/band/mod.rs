//! The levels in a band of the frequency axis: maximum, mean square, and the reduction relative to a reference.

mod commands;
pub(crate) mod view;

use crate::model::Checked;
use crate::solve::Reference;
use crate::solve::band::Level;
use crate::tui::app::last_request::LastRequest;
use crate::unit::{Form, Kind};
use crate::worker::LevelsAnswer;

/// The key of a request for levels.
#[derive(Debug, Clone, PartialEq)]
struct Key {
    generation: u64,
    references: Vec<u64>,
    span: [f64; 2],
    form: Option<Form>,
    motion: bool,
}

/// The levels of one model in the band.
#[derive(Debug, Clone)]
pub struct MemberLevels {
    /// The label of the member of a study; none for the model itself.
    pub label: Option<String>,
    /// One for each enabled response.
    pub levels: Vec<ResponseLevel>,
}

/// The level of a response in the band, divided by the force where the display does so.
#[derive(Debug, Clone)]
pub struct ResponseLevel {
    /// The response's name.
    pub response: String,
    /// The unit of the maximum; none for an energy.
    pub kind: Kind,
    /// Maximum and mean square.
    pub level: Level,
}

/// The levels in the band.
#[derive(Debug)]
pub struct BandLevels {
    /// The model's generation.
    pub generation: u64,
    /// The model's members.
    pub members: Vec<MemberLevels>,
    /// The numbers of the references, and their members.
    pub references: Vec<(u64, Vec<MemberLevels>)>,
}

/// The levels in the marked band.
#[derive(Debug, Default)]
pub struct Band {
    /// The levels solved last.
    pub levels: Option<BandLevels>,
    /// Why the last request failed.
    pub failure: Option<String>,
    asked: LastRequest<Key>,
}

impl Band {
    /// Stores the levels of the last request.
    pub(crate) fn take(&mut self, answer: LevelsAnswer) {
        let Some(key) = self.asked.answered(answer.serial) else {
            return;
        };
        let solved = match answer.result {
            Ok(solved) => solved,
            Err(reason) => {
                (self.levels, self.failure) = (None, Some(reason));
                return;
            }
        };
        self.failure = None;
        let motion = key.motion;
        let mut solved = solved.into_iter().map(|members| {
            let members = members.into_iter().map(|member| MemberLevels {
                levels: response_levels(&member.model, &member.levels, motion),
                label: member.label,
            });
            members.collect()
        });
        self.levels = Some(BandLevels {
            generation: key.generation,
            members: solved.next().unwrap_or_default(),
            references: key.references.iter().copied().zip(solved).collect(),
        });
    }
}

/// The levels of the enabled responses: of the `motion` itself, or divided by the force if there is exactly one.
fn response_levels(model: &Checked, levels: &[Level], motion: bool) -> Vec<ResponseLevel> {
    let reference = Reference::of(model).filter(|_| !motion);
    let enabled = model.responses.iter().filter(|one| one.enabled);
    enabled
        .zip(levels)
        .map(|(response, level)| {
            let kind = response.kind(model, reference.map(|one| one.load));
            let divisor = match &reference {
                Some(reference) if response.is_linear() => reference.amplitude.norm(),
                Some(_) | None => 1.0,
            };
            ResponseLevel {
                response: response.name.clone(),
                kind,
                level: Level {
                    maximum: level.maximum / divisor,
                    mean_square: level.mean_square / (divisor * divisor),
                    ..*level
                },
            }
        })
        .collect()
}
