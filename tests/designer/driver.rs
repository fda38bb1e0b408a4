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

/// The designer with somebody at its keys.
pub struct Driver {
    pub app: App,
    answers: bool,
    /// Requests that wait for [`Driver::answer_next`], where answers come late.
    late: Option<VecDeque<Request>>,
    /// What a file holds that is read again.
    pub disk: Option<String>,
    /// The code or signal with which it ended.
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

    /// The designer with a preset whose first curves are still in work; what is asked for later is answered.
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

    /// A designer whose requests stay without answers.
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

    /// From now on an answer comes when it is asked for.
    pub fn with_late_answers(mut self) -> Self {
        self.late = Some(VecDeque::new());
        self
    }

    /// Lets the answer to the oldest request come, if one waits.
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

    /// As for the worker, a newer request for curves takes the place of older ones.
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

    /// Presses keys, named as in help, with spaces between.
    pub fn keys(&mut self, keys: &str) -> &mut Self {
        for name in keys.split_whitespace() {
            self.press(named(name));
        }
        self
    }

    /// Replaces what is in a prompt.
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

    /// Lets something happen.
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

    /// Answers the last request as changed by `change`.
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

    /// The time of the next frame has come.
    pub fn tick(&mut self) -> &mut Self {
        assert!(self.app.moves());
        self.app.update(Event::Tick);
        self
    }

    /// Does what is asked for outside, as far as it is answered here.
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

    /// The screen: its symbols, then a letter for each cell's style, then what the letters mean.
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

/// What the worker answers to a request at last, and the curves of the whole sweep before that.
fn solved(request: Request) -> Vec<Answer> {
    if matches!(request, Request::EndTuning) {
        return Vec::new();
    }
    let (sender, receiver) = channel();
    // Nobody listens to what comes after the last answer.
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
        // Whether there is a coarse one depends on the machine.
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

/// How many points peaks need depends on the last digit of everything: the number is left out.
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
