//! The stored view state: options, and the last view of each model.

use std::collections::HashMap;
use std::sync::Arc;

use super::{App, MOTION, Table};
use crate::files::Source;
use crate::model::Model;
use crate::tui::scene::ChartView;
use crate::tui::tree::{self, Node};
use crate::tui::user::memory::{Memory, ViewState};
use crate::unit::{Form, FrequencyUnit};

/// The most open groups that are stored.
const MOST_OPEN: usize = 200;

impl App {
    /// Restores the stored options and view.
    pub fn recall(&mut self, memory: Memory) {
        if let Some(decibels) = memory.options.decibels {
            self.curves.decibels = decibels;
        }
        let unit = memory.options.frequency_unit.as_deref();
        let mut units = FrequencyUnit::SHOWN.into_iter();
        self.display.unit = units
            .find(|known| Some(known.symbol()) == unit)
            .unwrap_or_default();
        self.stored.memory = memory;
        self.recall_view();
    }

    /// The state to be stored, with this model's view.
    pub fn remembered(&self) -> Memory {
        let mut memory = self.stored.memory.clone();
        memory.options = self.stored.changed.clone();
        if let Some(view) = self.view() {
            memory.remember(view);
        }
        memory
    }

    /// Selects the next theme.
    pub(crate) fn next_theme(&mut self) {
        self.theme = self.theme.next();
        self.stored.changed.theme = Some(self.theme.word().to_owned());
        self.done(format!("theme: {}", self.theme.name()));
    }

    /// Stores the view of the model, before another one is opened.
    pub(crate) fn store_view(&mut self) {
        if let Some(view) = self.view() {
            self.stored.memory.remember(view);
        }
    }

    /// The view of the model; none if its source has no identity.
    fn view(&self) -> Option<ViewState> {
        let source = key(self.document.source())?;
        let model = Arc::clone(self.document.model());
        let study = self.curves.study.and_then(|study| model.studies.get(study));
        Some(ViewState {
            source,
            selected: trail(&model, self.selection.node()),
            open: self
                .selection
                .open()
                .take(MOST_OPEN)
                .map(|node| trail(&model, node))
                .collect(),
            visible: self.curves.visible.clone(),
            study: study.map(|study| study.name.clone()),
            log_frequency: self.curves.log_frequency,
            cursor: self.curves.cursor,
            window: self.curves.window,
            table: self.tables.open.map(|table| table.key().to_owned()),
            view: Some(self.display.view.name().to_owned()),
            form: match self.display.form {
                Some(form) => Some(form.name().to_owned()),
                None => self.display.motion.then(|| MOTION.to_owned()),
            },
            second_cursor: self.reading.second,
            band: self.curves.band,
            decibel_references: self.display.decibel_references.clone(),
        })
    }

    /// Restores the last view of the model.
    pub(crate) fn recall_view(&mut self) {
        let view = key(self.document.source()).and_then(|source| self.stored.memory.view(&source));
        let Some(view) = view.cloned() else {
            return;
        };
        let model = Arc::clone(self.document.model());
        let has = |name: &String| {
            model
                .responses
                .iter()
                .any(|one| one.name == *name && one.enabled)
        };
        let visible: Vec<String> = view.visible.into_iter().filter(has).collect();
        if !visible.is_empty() {
            self.curves.visible = visible;
        }
        let study = view.study.as_ref();
        self.curves.study =
            study.and_then(|name| model.studies.iter().position(|one| one.name == *name));
        self.curves.log_frequency = view.log_frequency;
        let sweep = model.sweep.from..=model.sweep.to;
        self.curves.cursor = view.cursor.filter(|cursor| sweep.contains(cursor));
        self.curves.window = view
            .window
            .filter(|[low, high]| low < high && sweep.contains(low) && sweep.contains(high));
        let inside =
            |band: &[f64; 2]| band[0] < band[1] && band.iter().all(|end| sweep.contains(end));
        self.curves.band = view.band.filter(inside);
        self.reading.second = view.second_cursor.filter(|cursor| sweep.contains(cursor));
        let possible = |(_, value): &(String, f64)| value.is_normal() && *value > 0.0;
        let references = view.decibel_references.into_iter();
        self.display.decibel_references = references.filter(possible).collect();
        // A new session has no reference for a difference.
        let mut views = ChartView::ALL.into_iter();
        self.display.view = views
            .find(|known| view.view.as_deref() == Some(known.name()))
            .filter(|view| *view != ChartView::Difference)
            .unwrap_or_default();
        let mut forms = Form::ALL.into_iter();
        self.display.form = forms.find(|known| view.form.as_deref() == Some(known.name()));
        self.display.motion = view.form.as_deref() == Some(MOTION);
        self.tables.open = view.table.as_deref().and_then(Table::of_word);
        let rows = tree::all_rows(&model);
        let trails: HashMap<Vec<String>, Node> = rows
            .iter()
            .map(|row| (trail(&model, row.node), row.node))
            .collect();
        let open = view
            .open
            .iter()
            .filter_map(|trail| trails.get(trail).copied());
        let selected = trails.get(&view.selected).copied();
        self.selection.restore(&model, open.collect(), selected);
    }
}

/// The identity of a source; a pipe has none.
fn key(source: &Source) -> Option<String> {
    match source.absolute() {
        Source::File(path) => Some(path.to_str()?.to_owned()),
        Source::Preset(name) => Some(format!("preset:{name}")),
        Source::Stdin => None,
    }
}

/// The labels of a row and of its parents, outermost first.
fn trail(model: &Model, node: Node) -> Vec<String> {
    let mut trail = node
        .parent()
        .map_or_else(Vec::new, |parent| trail(model, parent));
    trail.push(tree::label(model, node).into_owned());
    trail
}
