//! Dispatch of keys to commands.

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use super::{App, Effect, List, Next, Overlay, Question, Search, Selection, Table};
use crate::model::{Model, counted};
use crate::tui::keys::{
    AnywhereCommand, BeamViewCommand, Command, CompareCommand, CurvesCommand, FileCommand, Key,
    ModelCommand, ModesCommand, Movement, ReaderCommand, ReadingCommand, Scope, TableCommand,
    TreeCommand, TuneCommand,
};
use crate::tui::panels::chart::Turn;
use crate::tui::tree;

/// The largest count before a command.
const MOST_TIMES: u32 = 9_999;

impl App {
    pub(crate) fn key(&mut self, key: &KeyEvent) -> Vec<Effect> {
        let scope = self.scope();
        let command = self.keys.command(scope, key);
        self.message = None;
        match command {
            Some(command) => self.command(command),
            None if matches!(scope, Scope::Main | Scope::Table) => {
                self.count_up(Key::of(key));
                Vec::new()
            }
            None => self.type_key(key),
        }
    }

    /// A key on a screen that is too small: only the commands of every scope work. There is no room for a dialog, so
    /// quitting leaves unsaved changes in the recovery file.
    pub(crate) fn key_unseen(&mut self, key: &KeyEvent) -> Vec<Effect> {
        match self.keys.command_in(Scope::Any, key) {
            Some(Command::Anywhere(AnywhereCommand::End)) => {
                self.recovery.stays = true;
                vec![Effect::Quit(None)]
            }
            Some(command) => self.command(command),
            None => Vec::new(),
        }
    }

    /// Takes a digit of a count before a command.
    fn count_up(&mut self, key: Key) {
        let digit = match key.code {
            KeyCode::Char(c) if key.is_typed() => c.to_digit(10),
            _ => None,
        };
        match (digit, self.repeat.count) {
            (Some(digit @ 1..), None) => self.repeat.count = Some(digit),
            (Some(digit), Some(count)) => {
                self.repeat.count = Some((count * 10 + digit).min(MOST_TIMES));
            }
            _ => {
                self.repeat.count = None;
                let help = self.keys.key_of(FileCommand::Help);
                self.refuse(format!(
                    "{} is not bound here: {help} shows every key",
                    key.name()
                ));
            }
        }
    }

    /// Runs the command of a key; returns the effects.
    pub fn command(&mut self, command: Command) -> Vec<Effect> {
        let count = self.repeat.count.take();
        match (command, count) {
            (Command::Tune(TuneCommand::Tune), _) => {
                self.tuning.budget = count.map(|count| count as usize);
            }
            // They only cancel a count.
            (
                Command::Reading(ReadingCommand::CursorOff) | Command::Table(TableCommand::Close),
                Some(_),
            ) => return Vec::new(),
            (Command::Anywhere(_) | Command::File(FileCommand::Quit), _) => {}
            (_, Some(count)) if !command.counts() => {
                let name = self.keys.name_of(command);
                self.refuse(format!(
                    "{name} takes no count: nothing is done {}",
                    counted(count as usize, "time", "times")
                ));
                return Vec::new();
            }
            _ => {}
        }
        self.repeated(command, count.unwrap_or(1))
    }

    /// Runs a command once. `count` is for commands that take it as one step.
    pub(crate) fn dispatch(&mut self, command: Command, count: u32) -> Vec<Effect> {
        match command {
            Command::Move(movement) => self.move_rows(movement),
            Command::Tree(command) => self.tree_command(command, count),
            Command::Model(command) => self.model_command(command, count),
            Command::Curves(command) => self.curves_command(command),
            Command::Reading(command) => self.reading_command(command),
            Command::Compare(command) => self.compare_command(command),
            Command::BeamView(command) => self.beam_view_command(command),
            Command::Modes(command) => self.modes_command(command),
            Command::Tune(command) => self.tune_command(command),
            Command::File(command) => return self.file_command(command),
            Command::Anywhere(AnywhereCommand::Redraw) => return vec![Effect::Redraw],
            Command::Anywhere(AnywhereCommand::Suspend) => return vec![Effect::Suspend],
            Command::Anywhere(AnywhereCommand::End) => return self.leave(Next::Quit),
            Command::Table(TableCommand::Close) => self.tables.open = None,
            Command::Prompt(command) => return self.prompt_command(command),
            Command::Palette(command) => return self.palette_command(command),
            Command::Search(command) => self.search_command(command),
            Command::Picker(command) => return self.picker_command(command),
            Command::Comparison(command) => self.comparison_command(command),
            Command::Reader(ReaderCommand::Cancel) => self.overlay = None,
            Command::Unsaved(answer) => return self.answer_unsaved(answer),
            Command::Replace(answer) => return self.answer_replace(answer),
            Command::Recovery(command) => return self.recovery_command(command),
        }
        Vec::new()
    }

    /// Moves the selection of the scope that has the keys: a dialog, a search, the table, or the tree.
    fn move_rows(&mut self, movement: Movement) {
        if let Some(list) = self.overlay.as_mut().and_then(Overlay::list) {
            list.go(movement);
        } else if self.is_searching() {
            self.seek_found(movement.is_forward());
        } else if let Some(table) = self.tables.open {
            self.move_in_table(table, movement);
        } else {
            self.change_selection(movement.at_end(), |selection, _| match movement {
                Movement::Up => selection.step(-1),
                Movement::Down => selection.step(1),
                Movement::PageUp => selection.page(false),
                Movement::PageDown => selection.page(true),
                Movement::First => selection.first(),
                Movement::Last => selection.last(),
            });
        }
    }

    fn tree_command(&mut self, command: TreeCommand, count: u32) {
        match command {
            TreeCommand::Expand => {
                self.change_selection("this row has no children", Selection::expand);
            }
            TreeCommand::Collapse => {
                self.change_selection("this row has no parent", Selection::collapse);
            }
            TreeCommand::ExpandAll => {
                self.change_selection("every group is open", Selection::expand_all);
            }
            TreeCommand::CollapseAll => {
                self.change_selection("every group is closed", Selection::collapse_all);
            }
            // Avoids a pass through the whole tree for each step of a count.
            TreeCommand::NextParameter => {
                self.change_selection("there is no next parameter", |selection, model| {
                    selection.next_parameter(model, true, count as usize);
                });
            }
            TreeCommand::PreviousParameter => {
                self.change_selection("there is no previous parameter", |selection, model| {
                    selection.next_parameter(model, false, count as usize);
                });
            }
            TreeCommand::NextAlike => self.go_alike(true),
            TreeCommand::PreviousAlike => self.go_alike(false),
            TreeCommand::Search => self.search = Some(Search::new(self.selection.node())),
        }
    }

    /// Changes the selected row or the open groups; says why nothing changed.
    fn change_selection(&mut self, unchanged: &str, change: impl FnOnce(&mut Selection, &Model)) {
        let model = Arc::clone(self.document.model());
        let before = self.selection.state();
        change(&mut self.selection, &model);
        if self.selection.state() == before {
            self.refuse(unchanged);
        }
    }

    /// Changes the model, or undoes a change.
    fn model_command(&mut self, command: ModelCommand, count: u32) {
        match command {
            ModelCommand::Edit => self.edit(),
            ModelCommand::NudgeUp => self.nudge(10, count),
            ModelCommand::NudgeDown => self.nudge(-10, count),
            ModelCommand::NudgeUpCoarse => self.nudge(100, count),
            ModelCommand::NudgeDownCoarse => self.nudge(-100, count),
            ModelCommand::NudgeUpFine => self.nudge(1, count),
            ModelCommand::NudgeDownFine => self.nudge(-1, count),
            ModelCommand::Cycle => self.cycle_or_toggle(),
            ModelCommand::Repeat => self.repeat(),
            ModelCommand::Revert => self.revert(),
            ModelCommand::Add => self.add(),
            ModelCommand::AddBranch => self.add_branch(),
            ModelCommand::Duplicate => self.duplicate(),
            ModelCommand::Rename => self.ask_name(),
            ModelCommand::Enable => self.switch(),
            ModelCommand::Delete => self.delete(),
            ModelCommand::Undo => self.travel(true),
            ModelCommand::Redo => self.travel(false),
        }
    }

    fn curves_command(&mut self, command: CurvesCommand) {
        match command {
            CurvesCommand::Show => self.show_response(),
            CurvesCommand::Solo => self.solo_response(),
            CurvesCommand::Freeze => self.freeze(),
            CurvesCommand::Unfreeze => self.unfreeze(),
            CurvesCommand::Study => self.next_study(),
            CurvesCommand::ZoomIn => self.zoom(0.5, self.curves.cursor),
            CurvesCommand::ZoomOut => self.zoom(2.0, self.curves.cursor),
            CurvesCommand::ZoomWhole => self.show_whole(),
            CurvesCommand::PanUp => self.pan(1.0),
            CurvesCommand::PanDown => self.pan(-1.0),
            CurvesCommand::LogFrequency => self.curves.log_frequency = !self.curves.log_frequency,
            CurvesCommand::LevelIn => self.zoom_levels(0.5),
            CurvesCommand::LevelOut => self.zoom_levels(2.0),
            CurvesCommand::LevelUp => self.pan_levels(1.0),
            CurvesCommand::LevelDown => self.pan_levels(-1.0),
            CurvesCommand::LevelFix => self.fix_levels(),
        }
    }

    fn reading_command(&mut self, command: ReadingCommand) {
        match command {
            ReadingCommand::NextView => self.next_view(),
            ReadingCommand::NextForm => self.turn_form(true),
            ReadingCommand::PreviousForm => self.turn_form(false),
            ReadingCommand::Decibels => self.toggle_decibels(),
            ReadingCommand::DecibelReference => self.ask_decibel_reference(),
            ReadingCommand::FrequencyUnit => self.next_frequency_unit(),
            ReadingCommand::Unwrap => self.toggle_unwrapping(),
            ReadingCommand::CursorRight => self.step_cursor(1.0),
            ReadingCommand::CursorLeft => self.step_cursor(-1.0),
            ReadingCommand::CursorOff => self.take_away(),
            ReadingCommand::NextPeak => self.seek(Turn::Peak, true),
            ReadingCommand::PreviousPeak => self.seek(Turn::Peak, false),
            ReadingCommand::NextDip => self.seek(Turn::Dip, true),
            ReadingCommand::PreviousDip => self.seek(Turn::Dip, false),
            ReadingCommand::GoTo => {
                let unit = self.display.unit;
                self.ask_question(Question::Frequency(unit), String::new());
            }
            ReadingCommand::Readings => self.tables.toggle(Table::Readings),
            ReadingCommand::SecondCursor => self.turn_second(),
            ReadingCommand::Harmonics => self.turn_harmonics(),
            ReadingCommand::Band => self.turn_band(),
        }
    }

    fn compare_command(&mut self, command: CompareCommand) {
        match command {
            CompareCommand::List => self.open_comparison(),
            CompareCommand::AddMeasured => {
                self.ask_question(Question::MeasuredFile, String::new());
            }
            CompareCommand::MakeStudy => self.ask_factors(),
            CompareCommand::Export => self.ask_question(Question::Export, self.export_name()),
        }
    }

    fn beam_view_command(&mut self, command: BeamViewCommand) {
        match command {
            BeamViewCommand::Operating => self.next_operating(),
            BeamViewCommand::PhaseStep => self.step_phase(),
            BeamViewCommand::Structure => self.beam_view.next_drawing(),
        }
    }

    fn modes_command(&mut self, command: ModesCommand) {
        match command {
            ModesCommand::ModeTable => self.tables.toggle(Table::Modes),
            ModesCommand::PeakTable => self.tables.toggle(Table::Peaks),
            ModesCommand::NextMode => self.seek_mode(true),
            ModesCommand::PreviousMode => self.seek_mode(false),
            ModesCommand::Shape => self.beam_view.toggle_shape(),
            ModesCommand::Animate => self.animate(),
            ModesCommand::FiniteElements => self.toggle_fem_overlay(),
        }
    }

    fn tune_command(&mut self, command: TuneCommand) {
        match command {
            TuneCommand::Sensitivities => self.next_sensitivities(),
            TuneCommand::TuneVariable => self.turn_variable(),
            TuneCommand::TuneObjective => self.ask_objective(),
            TuneCommand::Tune => self.go_on_tuning(),
            TuneCommand::TuneAccept => self.accept_tuning(),
            TuneCommand::TuneDiscard => self.discard_tuning(),
            TuneCommand::Tolerances => self.turn_tolerances(),
        }
    }

    fn file_command(&mut self, command: FileCommand) -> Vec<Effect> {
        match command {
            FileCommand::Save => return self.save(),
            FileCommand::SaveAs => self.ask_save_path(),
            FileCommand::Reload => return self.reload(),
            FileCommand::Open => return self.leave(Next::AskPath),
            FileCommand::Presets => self.overlay = Some(Overlay::presets(self.preset_row())),
            FileCommand::Palette => self.open_palette(),
            FileCommand::CopyValue => return self.copy_value(),
            FileCommand::CopyModel => return self.copy_model(),
            FileCommand::Theme => self.next_theme(),
            FileCommand::Mouse => return self.toggle_mouse(),
            FileCommand::Help => self.overlay = Some(Overlay::Help(List::default())),
            FileCommand::Guide => self.open_chapters(),
            FileCommand::Quit => return self.leave(Next::Quit),
        }
        Vec::new()
    }

    /// Goes to the corresponding row of the next or previous subsystem, force, response or support.
    fn go_alike(&mut self, forward: bool) {
        if self.search.is_some() {
            return self.seek_found(forward);
        }
        let model = Arc::clone(self.document.model());
        match tree::alike(&model, self.selection.node(), forward) {
            Some(node) => self.selection.select(&model, node),
            None if forward => self.refuse("there is no next one of this kind"),
            None => self.refuse("there is no previous one of this kind"),
        }
    }

    /// Undoes or redoes a step.
    fn travel(&mut self, back: bool) {
        let before = Arc::clone(self.document.model());
        let step = if back {
            self.document.undo()
        } else {
            self.document.redo()
        };
        match (step, back) {
            (Some(name), true) => self.done(format!("undo: {name}")),
            (Some(name), false) => self.done(format!("redo: {name}")),
            (None, true) => self.refuse("nothing to undo"),
            (None, false) => self.refuse("nothing to redo"),
        }
        self.follow(&before);
    }
}
