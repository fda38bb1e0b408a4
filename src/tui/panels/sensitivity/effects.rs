//! The solved sensitivities; they keep the model of the request.

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
    /// The figure.
    pub sensed: Sensed,
    /// The response.
    pub response: String,
    /// Hz: the frequency, or the ends of the band.
    pub at: [f64; 2],
    /// The largest effect first.
    pub rows: Vec<Weighed>,
    /// Why some effects are missing, if so.
    pub lack: Option<String>,
    /// The index of each row of the tree.
    pub(super) places: HashMap<Node, usize>,
}

/// The effect of a parameter.
#[derive(Debug)]
pub struct Weighed {
    /// The name of the parameter in the solved model.
    pub name: String,
    /// Its row in the current tree; none if the parameter was removed.
    pub node: Option<Node>,
    /// Its effect.
    pub effect: Sensitivity,
}

impl Effects {
    /// The effects in the solved model, the largest first.
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

    /// Follows the rows of a changed model.
    pub(crate) fn follow(&mut self, moves: &Moves) {
        for row in &mut self.rows {
            row.node = row.node.and_then(|node| node.moved(moves));
        }
        let places = self.rows.iter().enumerate();
        self.places = places
            .filter_map(|(place, row)| Some((row.node?, place)))
            .collect();
    }

    /// The value of the bars: for a mode its frequency in Hz, else the level in dB; for e times the parameter.
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

    /// The effect of a row relative to the largest, from -1 to 1.
    pub fn share(&self, row: &Weighed) -> f64 {
        let of = |row: &Weighed| self.effect(&row.effect);
        match (of(row), self.rows.first().and_then(of)) {
            (Some(effect), Some(largest)) if largest != 0.0 => effect / largest.abs(),
            _ => 0.0,
        }
    }
}
