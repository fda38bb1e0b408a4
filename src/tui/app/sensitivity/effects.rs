//! What was found of the parameters: it stays with the model that was asked about.

use std::collections::HashMap;

use super::{Key, Sensed};
use crate::model::{Model, Moves};
use crate::solve::sensitivity::Sensitivity;
use crate::tui::tree::{self, Node};

/// The sensitivities solved last.
#[derive(Debug)]
pub struct Effects {
    /// The model's generation.
    pub generation: u64,
    /// What they are of.
    pub sensed: Sensed,
    /// The response they are of.
    pub response: String,
    /// Hz: where, or the ends of the band.
    pub at: [f64; 2],
    /// The largest effect first.
    pub rows: Vec<Weighed>,
    /// Why some of them are empty, where some are.
    pub lack: Option<String>,
    /// Where a row of the tree is among the rows.
    pub(super) places: HashMap<Node, usize>,
}

/// What a parameter does.
#[derive(Debug)]
pub struct Weighed {
    /// What the parameter is called in the model that was solved.
    pub name: String,
    /// Its row in the tree as that is now; none where the model no longer has it.
    pub node: Option<Node>,
    /// What it does.
    pub effect: Sensitivity,
}

impl Effects {
    /// What was found for the model that was asked about, the largest effect first.
    pub(super) fn new(key: &Key, model: &Model, found: Vec<Sensitivity>) -> Self {
        let mut effects = Self {
            generation: key.generation,
            sensed: key.sensed,
            response: key.response.clone(),
            at: key.at,
            rows: Vec::new(),
            lack: None,
            places: HashMap::new(),
        };
        let rows = found.into_iter().map(|effect| {
            let node = Node::of(effect.id);
            Weighed {
                name: tree::subject(model, node),
                node: Some(node),
                effect,
            }
        });
        let mut rows: Vec<Weighed> = rows.collect();
        let size = |row: &Weighed| effects.effect(&row.effect).map_or(-1.0, f64::abs);
        rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
        effects.rows = rows;
        effects
    }

    /// Follows the rows of the tree of a changed model.
    pub(in crate::tui::app) fn follow(&mut self, moves: &Moves) {
        for row in &mut self.rows {
            row.node = row.node.and_then(|node| node.moved(moves));
        }
        let places = self.rows.iter().enumerate();
        self.places = places
            .filter_map(|(place, row)| Some((row.node?, place)))
            .collect();
    }

    /// What the bars show: of a mode its frequency in Hz, else the level in dB; for e times the parameter.
    pub fn effect(&self, one: &Sensitivity) -> Option<f64> {
        match self.sensed {
            Sensed::Mode => one.frequency,
            Sensed::Cursor | Sensed::Peak | Sensed::Band => one.level,
        }
    }

    /// The effect of a row of the tree, and its share of the largest.
    pub fn of(&self, node: Node) -> Option<(f64, f64)> {
        let row = self.rows.get(*self.places.get(&node)?)?;
        Some((self.effect(&row.effect)?, self.share(row)))
    }

    /// The share of a row in the largest effect, from -1 to 1.
    pub fn share(&self, row: &Weighed) -> f64 {
        let of = |row: &Weighed| self.effect(&row.effect);
        match (of(row), self.rows.first().and_then(of)) {
            (Some(effect), Some(largest)) if largest != 0.0 => effect / largest.abs(),
            _ => 0.0,
        }
    }
}
