//! The designer: a terminal program in which a parameter is turned and its curves follow.
//!
//! A key becomes a command by the one table of [`keys`], a command changes the state of [`app`], the state is drawn
//! by `view`. What is to be done outside of the state (solving, files) are effects, performed by `effects` here; the
//! program waits on one channel of [`event::Event`]s and draws only when one has arrived. There is no clock but while a
//! shape moves.

pub mod app;
mod effects;
pub mod event;
pub mod keys;
pub mod plot;
pub mod terminal;
pub mod theme;
pub mod tree;
pub mod view;

use std::io::{self, Write as _};
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use app::App;
use effects::Performer;
use event::Event;
use theme::Theme;

use crate::model::Model;

/// From one frame of what moves to the next.
const FRAME: Duration = Duration::from_millis(100);

/// Where a model came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// A file, to which it is saved.
    File(PathBuf),
    /// An embedded preset.
    Preset(&'static str),
    /// Standard input.
    Stdin,
}

impl Source {
    /// The name on the status line: a file's name without its folder, or a preset's.
    pub fn name(&self) -> String {
        match self {
            Self::File(path) => path.file_name().map_or_else(
                || path.display().to_string(),
                |name| name.to_string_lossy().into_owned(),
            ),
            Self::Preset(name) => (*name).to_owned(),
            Self::Stdin => "standard input".to_owned(),
        }
    }

    /// The file for unsaved changes when the program is ended from outside: beside the model's own, with `.rescue`
    /// before the extension.
    pub fn rescue_path(&self) -> PathBuf {
        match self {
            Self::File(path) => path.with_extension("rescue.toml"),
            Self::Preset(name) => PathBuf::from(format!("{name}.rescue.toml")),
            Self::Stdin => PathBuf::from("beamtune.rescue.toml"),
        }
    }
}

/// A model that was opened.
#[derive(Debug, Clone)]
pub struct Opened {
    /// The model; it may differ from the text by values set on the command line.
    pub model: Model,
    /// The text it was read from.
    pub text: String,
    /// Where that came from.
    pub source: Source,
}

/// Runs the designer until it is left; the signal that ended it, if one did.
///
/// # Errors
/// Where the terminal cannot be set up or written to.
pub fn run(opened: Opened) -> io::Result<Option<u8>> {
    let (sender, events) = mpsc::channel();
    let mut session = terminal::Session::start()?;
    terminal::events(&sender)?;
    let performer = Performer::new(sender);
    // crossterm would drop bold and reversed together with the colours; the theme knows better.
    crossterm::style::force_color_output(true);
    let theme = Theme::from_environment();
    let mut app = App::new(opened);
    let mut effects = app.start();
    let mut rescued = None;
    let mut next_frame = Instant::now();
    loop {
        for effect in effects.drain(..) {
            match performer.perform(effect, &mut app) {
                effects::Outcome::Done => {}
                effects::Outcome::Rescued(sentence) => rescued = Some(sentence),
                effects::Outcome::Redraw => session.repaint()?,
                effects::Outcome::Quit(signal) => {
                    drop(session);
                    tell(rescued.as_deref());
                    return Ok(signal);
                }
            }
        }
        session.draw(|frame| view::draw(frame, &mut app, theme))?;
        let Some(event) = wait(&events, &app, &mut next_frame) else {
            return Ok(None);
        };
        effects = take(&mut app, event, &events);
    }
}

/// Waits for the next event: without a clock, but while something moves. `None` where no event can come any more.
fn wait(events: &Receiver<Event>, app: &App, next_frame: &mut Instant) -> Option<Event> {
    if !app.moves() {
        // An idle program waits here.
        return events.recv().ok();
    }
    let now = Instant::now();
    // A frame that was missed is not made up for.
    *next_frame = (*next_frame).clamp(now, now + FRAME);
    match events.recv_timeout(*next_frame - now) {
        Ok(event) => Some(event),
        Err(RecvTimeoutError::Timeout) => {
            *next_frame += FRAME;
            Some(Event::Tick)
        }
        Err(RecvTimeoutError::Disconnected) => None,
    }
}

/// Says, when the terminal has been given back, where to find what was not saved.
fn tell(rescued: Option<&str>) {
    if let Some(sentence) = rescued {
        // Whoever ended the program may have closed standard error too.
        let _ = writeln!(io::stderr(), "{sentence}");
    }
}

/// Takes an event and all that wait behind it, so that a burst is drawn once; the effects of all.
fn take(app: &mut App, first: Event, events: &Receiver<Event>) -> Vec<app::Effect> {
    let mut effects = app.update(first);
    while let Ok(event) = events.try_recv() {
        effects.extend(app.update(event));
    }
    effects
}
