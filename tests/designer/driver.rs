//! Presses keys, answers requests at once, and reads the screen.

use beamtune::model::Checked;
use std::collections::VecDeque;
use std::fmt::Write as _;
use std::sync::mpsc::channel;
use std::time::Duration;

use beamtune::files::{Opened, Source};
use beamtune::model::{self, Model, path};
use beamtune::presets;
use beamtune::tui::app::{App, Effect, Reply};
use beamtune::tui::event::Event;
use beamtune::tui::keys::Key;
use beamtune::tui::theme::Theme;
use beamtune::tui::{tree, view};
use beamtune::worker::{Answer, CurvesAnswer, Request, Stage, Subject, TuneStage, Worker};
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::style::Style;

/// `fig05a` with a thousand of its first subsystem, evenly along the beam.
pub fn thousand() -> Model {
    let preset = presets::find("fig05a").expect("a preset");
    let mut model = model::read(preset.text)
        .expect("a possible model")
        .into_inner();
    let first = model.subsystems[0].clone();
    model.subsystems = (0..1000)
        .map(|i| {
            let mut one = first.clone();
            one.name = format!("S{}", i + 1);
            one.position = model.beam.length * f64::from(i) / 999.0;
            one
        })
        .collect();
    model
}

/// The designer with a simulated user.
pub struct Driver {
    pub app: App,
    answers: bool,
    /// Requests that wait for [`Driver::answer_next`], for tests of late answers.
    late: Option<VecDeque<Request>>,
    /// The contents of a file that is read again.
    pub disk: Option<String>,
    /// The exit code or the signal.
    pub ended: bool,
}

impl Driver {
    pub fn preset(name: &str) -> Self {
        let preset = presets::find(name).expect("a preset");
        let model = model::read(preset.text)
            .expect("a possible model")
            .into_inner();
        Self::opened(model, preset.text.to_owned(), Source::Preset(preset.name))
    }

    pub fn opened(model: Model, text: String, source: Source) -> Self {
        let mut driver = Self::waiting(model, text, source);
        driver.answers = true;
        let effects = driver.app.start();
        driver.perform(effects);
        driver
    }

    /// A model with a thousand subsystems; nothing is solved.
    pub fn thousand() -> Self {
        Self::waiting(thousand(), String::new(), Source::Stdin)
    }

    /// The designer with a preset whose first curves are not solved yet; later requests are answered.
    pub fn begun(name: &str) -> Self {
        let preset = presets::find(name).expect("a preset");
        let model = model::read(preset.text)
            .expect("a possible model")
            .into_inner();
        let mut driver = Self::waiting(model, preset.text.to_owned(), Source::Preset(preset.name));
        let effects = driver.app.start();
        driver.perform(effects);
        driver.answers = true;
        driver
    }

    /// A designer whose requests are not answered.
    fn waiting(model: Model, text: String, source: Source) -> Self {
        let app = App::new(Opened {
            model: Checked::new(model).expect("a possible model"),
            text,
            source,
        });
        Self {
            app,
            answers: false,
            late: None,
            disk: None,
            ended: false,
        }
    }

    /// From now on, answers come only on demand.
    pub fn with_late_answers(mut self) -> Self {
        self.late = Some(VecDeque::new());
        self
    }

    /// Delivers the answer to the oldest request, if one waits.
    pub fn answer_next(&mut self) {
        if let Some(request) = self.late.as_mut().and_then(VecDeque::pop_front) {
            self.answer(request);
        }
    }

    fn answer(&mut self, request: Request) {
        for answer in solved(request) {
            let more = self.app.update(Event::Answer(answer));
            self.perform(more);
        }
    }

    /// As in the worker, a newer request for curves replaces older ones.
    fn put_off(&mut self, request: Request) {
        let Some(waiting) = &mut self.late else {
            return;
        };
        if matches!(request, Request::Curves(_)) {
            waiting.retain(|one| !matches!(one, Request::Curves(_)));
        }
        waiting.push_back(request);
    }

    pub fn without_answers(&mut self) -> &mut Self {
        self.answers = false;
        self
    }

    pub fn without_answers_at_all(mut self) -> Self {
        self.answers = false;
        self
    }

    pub fn without_colours(&mut self) -> &mut Self {
        self.app.theme = Theme::new(false);
        self
    }

    /// Presses keys, named as in the help, separated by spaces.
    pub fn keys(&mut self, keys: &str) -> &mut Self {
        for name in keys.split_whitespace() {
            self.press(named(name));
        }
        self
    }

    /// Replaces the text of a prompt.
    pub fn typed(&mut self, text: &str) -> &mut Self {
        self.press(KeyEvent::new(KeyCode::Char('u'), KeyModifiers::CONTROL));
        for c in text.chars() {
            self.press(KeyEvent::new(KeyCode::Char(c), KeyModifiers::NONE));
        }
        self
    }

    pub fn press(&mut self, key: KeyEvent) {
        self.happen(Event::Key(key));
    }

    /// Handles an event.
    pub fn happen(&mut self, event: Event) {
        let effects = self.app.update(event);
        self.perform(effects);
    }

    /// Selects the row of a parameter.
    pub fn select(&mut self, path: &str) -> &mut Self {
        let model = self.app.model().clone();
        let id = path::find(&model, path).expect("a path")[0];
        let row = tree::all_rows(&model)
            .into_iter()
            .find(|row| row.node.parameter() == Some(id))
            .expect("a row");
        self.app.selection.select(&model, row.node);
        self
    }

    /// Answers the last request, modified by `change`.
    pub fn answered(&mut self, change: impl FnOnce(&mut CurvesAnswer)) -> &mut Self {
        let (generation, model) = (self.app.curves.generation, self.app.model().clone());
        let request = Request::Curves(Subject {
            generation,
            model,
            study: None,
        });
        if let Some(Answer::Curves(mut answer)) = solved(request).pop() {
            change(&mut answer);
            self.happen(Event::Answer(Answer::Curves(answer)));
        }
        self
    }

    /// Triggers the next frame.
    pub fn tick(&mut self) -> &mut Self {
        assert!(self.app.moves());
        self.app.update(Event::Tick);
        self
    }

    /// Performs an effect, as far as the tests support it.
    pub fn perform(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Solve(Request::Expect(_)) => {}
                Effect::Solve(request) if self.late.is_some() => self.put_off(request),
                Effect::Solve(request) if self.answers => self.answer(request),
                Effect::Reload(path) => {
                    let text = self.disk.clone().expect("what the file holds");
                    let model = model::read(&text).expect("a possible model");
                    let source = Source::File(path);
                    let more = self.app.reply(Reply::Reloaded(Box::new(Opened {
                        model,
                        text,
                        source,
                    })));
                    self.perform(more);
                }
                Effect::Save { path, .. } => {
                    let more = self
                        .app
                        .reply(Reply::NotSaved(path, "the disk is full".to_owned()));
                    self.perform(more);
                }
                Effect::Open(path) => {
                    let more = self
                        .app
                        .reply(Reply::NotRead(path, "there is no such file".to_owned()));
                    self.perform(more);
                }
                Effect::CheckMatch {
                    model,
                    objective,
                    folder,
                } => {
                    let checked = beamtune::tune::check_match(&model, &objective, &folder);
                    let more = self.app.reply(Reply::MatchChecked(checked));
                    self.perform(more);
                }
                Effect::Quit(_) => self.ended = true,
                _ => {}
            }
        }
    }

    /// The screen: its symbols, then a letter for each cell's style, then the legend of the letters.
    pub fn screen(&mut self, width: u16, height: u16) -> String {
        let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a screen");
        let mut drawn = None;
        terminal
            .draw(|frame| drawn = view::draw(frame, &self.app))
            .expect("a frame");
        self.app.drawn(drawn);
        in_words(terminal.backend().buffer())
    }
}

/// The worker's final answer to a request, after the curves of the whole sweep.
fn solved(request: Request) -> Vec<Answer> {
    if matches!(request, Request::EndTuning) {
        return Vec::new();
    }
    let (sender, receiver) = channel();
    // The receiver may be closed after the last answer.
    let worker = Worker::start(move |answer| drop(sender.send(answer)));
    worker.request(request);
    let mut answers = Vec::new();
    for mut answer in receiver {
        let last = match &mut answer {
            Answer::Curves(curves) => {
                curves.elapsed = Duration::from_millis(4);
                curves.stage == Stage::Counted || curves.result.is_err()
            }
            Answer::Tune(tune) => {
                tune.elapsed = Duration::from_secs(2);
                matches!(tune.stage, TuneStage::Over(_))
            }
            _ => true,
        };
        // Whether there is a coarse answer depends on the machine.
        if !matches!(&answer, Answer::Curves(curves) if curves.stage == Stage::Coarse) {
            answers.push(answer);
        }
        if last {
            break;
        }
    }
    answers
}

/// The key with this name in help.
fn named(name: &str) -> KeyEvent {
    let key = Key::parse(name).unwrap_or_else(|| panic!("no key is named {name}"));
    key.event()
}

fn in_words(buffer: &Buffer) -> String {
    let mut styles: Vec<Style> = vec![Style::reset()];
    let (mut symbols, mut letters) = (String::new(), String::new());
    for y in 0..buffer.area.height {
        let (mut line, mut styled) = (String::new(), String::new());
        for x in 0..buffer.area.width {
            let cell = &buffer[(x, y)];
            line.push_str(cell.symbol());
            styled.push(letter(&mut styles, cell.style()));
        }
        let _ = writeln!(symbols, "|{}|", without_count(&line));
        let _ = writeln!(letters, "{}", styled.trim_end_matches('.'));
    }
    let mut text = format!("{symbols}{letters}");
    for (number, style) in styles.iter().enumerate().skip(1) {
        let fg = style.fg.map_or_else(String::new, |fg| format!("{fg:?} "));
        let _ = writeln!(
            text,
            "{} = {fg}{:?}",
            LETTERS[number] as char, style.add_modifier
        );
    }
    text
}

/// The number of points at peaks depends on the last digits of the platform's arithmetic: it is masked.
fn without_count(line: &str) -> String {
    let Some((before, after)) = line.split_once("solved ") else {
        return line.to_owned();
    };
    let count = after.find(" x ").unwrap_or(0);
    let masked = after[..count].replace(|c: char| c.is_ascii_digit(), "#");
    format!("{before}solved {masked}{}", &after[count..])
}

const LETTERS: &[u8] = b".abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

fn letter(styles: &mut Vec<Style>, style: Style) -> char {
    let plain = Style {
        underline_color: None,
        ..style
    };
    let plain = if plain
        == (Style {
            underline_color: None,
            ..Style::reset()
        }) {
        Style::reset()
    } else {
        plain
    };
    let number = styles
        .iter()
        .position(|known| *known == plain)
        .unwrap_or_else(|| {
            styles.push(plain);
            styles.len() - 1
        });
    LETTERS[number.min(LETTERS.len() - 1)] as char
}
