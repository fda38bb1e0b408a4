//! Presses keys, answers requests at once, and reads the screen.

use std::fmt::Write as _;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use beamtune::model::{self, Model, path};
use beamtune::tui::app::{App, Effect, Reply};
use beamtune::tui::event::Event;
use beamtune::tui::keys::SECTIONS;
use beamtune::tui::theme::Theme;
use beamtune::tui::{Opened, Source, tree, view};
use beamtune::worker::{Answer, Curves, Member, Request, Stage};
use beamtune::{presets, solve};
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::style::Style;

/// The designer with somebody at its keys.
pub struct Driver {
    pub app: App,
    theme: Theme,
    answers: bool,
    /// The code or signal with which it ended.
    pub ended: bool,
}

impl Driver {
    pub fn preset(name: &str) -> Self {
        let preset = presets::find(name).expect("a preset");
        let model = model::read(preset.text).expect("a possible model");
        Self::opened(model, preset.text.to_owned(), Source::Preset(preset.name))
    }

    pub fn opened(model: Model, text: String, source: Source) -> Self {
        let app = App::new(Opened {
            model,
            text,
            source,
        });
        let mut driver = Self {
            app,
            theme: Theme::new(true),
            answers: true,
            ended: false,
        };
        let effects = driver.app.start();
        driver.perform(effects);
        driver
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
        self.theme = Theme::new(false);
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
        let effects = self.app.update(Event::Key(key));
        self.perform(effects);
    }

    /// Selects the row of a parameter.
    pub fn select(&mut self, path: &str) -> &mut Self {
        let model = self.app.model().clone();
        let path = path::expand(&model, path).expect("a path").remove(0);
        let row = tree::all_rows(&model)
            .into_iter()
            .find(|row| tree::parameter_path(&model, row.node).as_deref() == Some(&path))
            .expect("a row");
        self.app.selection.select(&model, row.node);
        self
    }

    /// Answers the last request as changed by `change`.
    pub fn answered(&mut self, change: impl FnOnce(&mut Answer)) -> &mut Self {
        let (generation, model) = (self.app.curves.generation, self.app.model().clone());
        let mut answer = solved(&Request {
            generation,
            model,
            study: None,
        });
        change(&mut answer);
        self.app.update(Event::Answer(answer));
        self
    }

    /// A model with a thousand subsystems, all open.
    pub fn thousand_subsystems(&mut self) {
        let mut model = Model::clone(self.app.model());
        let first = model.subsystems[0].clone();
        model.subsystems = (0..1000)
            .map(|i| {
                let mut one = first.clone();
                one.name = format!("S{}", i + 1);
                one.position = model.beam.length * f64::from(i) / 999.0;
                one
            })
            .collect();
        *self = Self::opened(model, String::new(), Source::Stdin).without_answers_at_all();
    }

    fn perform(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Solve(request) if self.answers => {
                    let answer = Event::Answer(solved(&request));
                    let more = self.app.update(answer);
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
                Effect::Quit(_) => self.ended = true,
                Effect::Solve(_) | Effect::Rescue { .. } | Effect::Redraw | Effect::Complete(_) => {
                }
            }
        }
    }

    /// The screen: its symbols, then a letter for each cell's style, then what the letters mean.
    pub fn screen(&mut self, width: u16, height: u16) -> String {
        let mut terminal = Terminal::new(TestBackend::new(width, height)).expect("a screen");
        terminal
            .draw(|frame| view::draw(frame, &mut self.app, self.theme))
            .expect("a frame");
        in_words(terminal.backend().buffer())
    }
}

/// Solves a request as the worker does, in no time.
fn solved(request: &Request) -> Answer {
    let models = match request
        .study
        .map(|study| &request.model.studies[study].family)
    {
        None => vec![(None, Model::clone(&request.model))],
        Some(family) => path::family_labels(family)
            .into_iter()
            .enumerate()
            .map(|(i, label)| {
                (
                    Some(label),
                    path::apply(&request.model, family, i).expect("a possible member"),
                )
            })
            .collect(),
    };
    let members = models.into_iter().map(|(label, model)| {
        let frequencies = solve::frequencies(&model.sweep);
        let frf =
            solve::sweep(&model, &frequencies, &AtomicBool::new(false)).expect("not cancelled");
        Member { label, frf }
    });
    Answer {
        generation: request.generation,
        stage: Stage::Full,
        result: Ok(Curves {
            members: members.collect(),
        }),
        elapsed: Duration::from_millis(4),
    }
}

/// The key with this name in help.
fn named(name: &str) -> KeyEvent {
    let keys = SECTIONS
        .iter()
        .flat_map(|section| section.bindings)
        .flat_map(|binding| binding.keys);
    let key = keys
        .copied()
        .find(|key| key.name() == name)
        .unwrap_or_else(|| panic!("no key is named {name}"));
    let modifiers = if key.control {
        KeyModifiers::CONTROL
    } else {
        KeyModifiers::NONE
    };
    KeyEvent::new(key.code, modifiers)
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
        let _ = writeln!(symbols, "|{line}|");
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
