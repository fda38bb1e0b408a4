//! The search for better parameters: variables, objectives, tolerances, and progress.

mod commands;
mod objective;
mod tolerance;
mod variable;
pub(crate) mod view;

use std::collections::HashSet;
use std::sync::Arc;
use std::time::Duration;

use crate::model::Checked;
use crate::tui::app::last_request::LastRequest;
use crate::tui::panels::chart::Member;
use crate::tui::tree::Node;
use crate::tune::{Status, Tuned};
use crate::worker::Pause;

/// The state of a search.
#[derive(Debug)]
pub enum Progress {
    /// Running.
    Searching,
    /// Paused.
    Paused,
    /// Finished.
    Found(Box<Tuned>),
    /// Failed, and why.
    Failed(String),
}

/// A search for better parameters.
#[derive(Debug)]
pub struct Run {
    serial: u64,
    /// The model at the start.
    pub from: Arc<Checked>,
    /// The progress.
    pub progress: Progress,
    /// The best candidate so far; none before the first report.
    pub status: Option<Box<Status>>,
    /// The time spent.
    pub elapsed: Duration,
    pause: Arc<Pause>,
    /// The id of the reference that shows the best so far.
    reference: u64,
}

impl Run {
    /// The best model so far, if there is one.
    pub fn best(&self) -> Option<&Checked> {
        match &self.progress {
            Progress::Found(tuned) => Some(&tuned.model),
            _ => self.status.as_ref().map(|status| &status.model),
        }
    }

    /// Whether it is running.
    pub fn goes_on(&self) -> bool {
        matches!(self.progress, Progress::Searching | Progress::Paused)
    }

    /// The estimated time for the remaining evaluations.
    pub fn left(&self) -> Option<Duration> {
        let status = self.status.as_ref().filter(|one| one.evaluations > 0)?;
        let each = self.elapsed.as_secs_f64() / status.evaluations as f64;
        let rest = status.budget.saturating_sub(status.evaluations);
        Some(Duration::from_secs_f64(each * rest as f64))
    }
}

/// The state of searches and tolerances.
#[derive(Debug, Default)]
pub struct Tuning {
    /// The search, until it is accepted or discarded.
    pub run: Option<Run>,
    /// A discarded search is to be cancelled.
    ends: bool,
    /// A search is to be started.
    starts: bool,
    /// The limit of evaluations of the next search, if typed.
    pub(crate) budget: Option<usize>,
    /// The effect of tolerances on the curves.
    pub tolerances: Tolerances,
    /// The rows of the tree that a search may change.
    pub moving: MovableRows,
}

/// The band that contains nine of ten curves.
#[derive(Debug, Default)]
pub struct Tolerances {
    /// Whether it is visible.
    pub shown: bool,
    /// The 5 %, 50 % and 95 % quantiles of the curves, for the model with this generation.
    pub curves: Option<(u64, [Member; 3])>,
    /// The last request, by generation of the model.
    asked: LastRequest<u64>,
}

/// The rows of the tree that a search may change.
#[derive(Debug, Default)]
pub struct MovableRows {
    /// Their model.
    model: Option<Arc<Checked>>,
    nodes: HashSet<Node>,
}

impl MovableRows {
    /// Whether a search may change the parameter of a row.
    pub fn has(&self, node: Node) -> bool {
        self.nodes.contains(&node)
    }

    /// Follows a changed model.
    pub(crate) fn refresh(&mut self, model: &Arc<Checked>) {
        let known = self.model.as_ref();
        if known.is_some_and(|known| Arc::ptr_eq(known, model)) {
            return;
        }
        self.model = Some(Arc::clone(model));
        self.nodes.clear();
        let Some(tune) = &model.tune else {
            return;
        };
        let patterns = tune.variables.iter().flat_map(|variable| &variable.paths);
        let found = patterns.filter_map(|pattern| pattern.parameters(model).ok());
        self.nodes.extend(found.flatten().map(Node::of));
    }
}
