//! The event loop: waits for events, updates the state, performs its effects, and draws.

use std::io::{self, Write as _};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

use signal_hook::consts::SIGHUP;

use super::app::{App, Effect};
use super::effects::{Outcome, Performer};
use super::event::Event;
use super::frame_scheduler::{FrameScheduler, Reason};
use super::options::{Environment, Options};
use super::terminal::{self, Session};
use super::theme::Theme;
use super::user::config::Config;
use super::user::log;
use super::user::memory::{self, Memory};
use super::view;
use crate::escape::escape;
use crate::files::Folders;
use crate::files::Opened;

/// The time between two frames of an animation.
const FRAME: Duration = Duration::from_millis(100);

/// An animation stops if sending a frame takes longer: the connection is too slow.
const SLOWEST_FRAME: Duration = Duration::from_millis(300);

/// Everything the designer starts with, except the model.
#[derive(Debug, Default)]
pub struct Setup {
    /// The options of the command line.
    pub options: Options,
    /// The user's configuration.
    pub config: Config,
    /// The folders of the user's files; none without a home folder.
    pub folders: Option<Folders>,
}

/// How the designer ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// The user quit.
    Left,
    /// A signal with this number ended it.
    Signal(u8),
    /// An internal error, which has been reported.
    Fault,
}

/// Runs the designer until it ends.
///
/// # Errors
/// The terminal cannot be set up or written to.
pub fn run(opened: Opened, setup: &Setup) -> io::Result<Ended> {
    let (sender, events) = mpsc::channel();
    let log_file = setup.folders.as_ref().map(Folders::log_file);
    terminal::set_panic_sink(log_file.clone());
    let mut app = App::new(opened);
    let troubles = configure(&mut app, setup);
    let mut session = Session::start(app.mouse.captured)?;
    terminal::events(&sender)?;
    let recovery = setup.folders.as_ref().map(Folders::recovery_folder);
    let mut performer = Performer::new(&sender, recovery);
    app.offer(performer.lost(app.document.source()));
    for sentence in troubles {
        if let Some(file) = &log_file {
            log::append(file, &sentence);
        }
        tell_app(&sender, sentence);
    }
    let mut stage = Stage {
        app: &mut app,
        performer: &mut performer,
        session: &mut session,
        events: &events,
    };
    // The hook reports a panic and restores the terminal; unsaved changes are stored in the recovery file all the same.
    let ended = catch_unwind(AssertUnwindSafe(|| stage.play()));
    drop(session);
    let ended = match ended.unwrap_or(Ok(Ended::Fault)) {
        // Drawing may detect the closed terminal before the signal arrives.
        Err(_) if terminal::is_gone() => Ok(Ended::Signal(SIGHUP as u8)),
        ended => ended,
    };
    let unsaved = match ended {
        Ok(Ended::Left) if !app.recovery.stays => None,
        _ => app.document.unsaved(),
    };
    if let Some(sentence) = performer.finish(unsaved) {
        // Standard error may be closed, too.
        let _ = writeln!(io::stderr(), "{}", escape(&sentence));
    }
    // Last, because it may wait for another program; not after an internal error, which may leave the state half
    // changed.
    if let (Some(folders), Ok(Ended::Left | Ended::Signal(_))) = (&setup.folders, &ended) {
        store_memory(&app, folders);
    }
    ended
}

/// Options, keys and the stored view state; messages about what could not be read.
fn configure(app: &mut App, setup: &Setup) -> Vec<String> {
    let mut troubles = Vec::new();
    let folders = setup.folders.as_ref();
    let memory = match folders.map(|folders| Memory::load(&folders.memory_file())) {
        Some(Ok(memory)) => memory,
        Some(Err(sentence)) => {
            troubles.push(sentence);
            Memory::default()
        }
        None => Memory::default(),
    };
    let asked = setup.options.over(setup.config.options);
    app.theme = Theme::resolve(asked, &Environment::of_process());
    if asked.colours.is_none() && asked.ground.is_none() {
        app.theme = app.theme.recalled(memory.options.theme.as_deref());
    }
    app.mouse.captured = asked.mouse.or(memory.options.mouse).unwrap_or(true);
    app.keys = setup.config.keys.clone();
    app.recall(memory);
    troubles
}

fn tell_app(sender: &Sender<Event>, sentence: String) {
    // The receiver lives as long as the loop.
    let _ = sender.send(Event::Trouble(sentence));
}

/// Stores options and views. A failure costs only convenience, so it goes to the log.
fn store_memory(app: &App, folders: &Folders) {
    let stored = memory::store(&folders.memory_file(), &app.remembered());
    if let Err(sentence) = stored {
        log::append(&folders.log_file(), &sentence);
    }
}

/// The result of a wait.
enum Waited {
    /// An event.
    Event(Event),
    /// It is time to draw.
    Long,
    /// All senders are gone.
    InVain,
}

/// The parts of the running program.
struct Stage<'a> {
    app: &'a mut App,
    performer: &'a mut Performer,
    session: &'a mut Session,
    events: &'a Receiver<Event>,
}

impl Stage<'_> {
    /// Runs until the program ends.
    fn play(&mut self) -> io::Result<Ended> {
        let effects = self.app.start();
        if let Some(ended) = self.perform(effects)? {
            return Ok(ended);
        }
        let mut pace = FrameScheduler::new();
        // Draw the first picture with curves, unless they take long.
        pace.wants(Reason::Awaits, Instant::now());
        let mut next_frame = Instant::now();
        loop {
            if pace.due().is_some_and(|due| due <= Instant::now()) {
                self.draw(&mut pace)?;
            }
            let ended = match self.wait(pace.due(), &mut next_frame) {
                Waited::Event(event) => self.take(event, &mut pace)?,
                Waited::Long => None,
                Waited::InVain => Some(Ended::Left),
            };
            if let Some(ended) = ended {
                return Ok(ended);
            }
        }
    }

    fn draw(&mut self, pace: &mut FrameScheduler) -> io::Result<()> {
        let began = Instant::now();
        let app = &mut *self.app;
        let mut drawn = None;
        self.session
            .draw(|frame| drawn = Some(view::draw(frame, app)))?;
        if let Some(screen) = drawn {
            app.drawn(screen);
        }
        let ended = Instant::now();
        pace.drew(began, ended);
        if app.moves() && ended - began > SLOWEST_FRAME {
            app.stop_moving();
            pace.wants(Reason::Shows, ended);
        }
        Ok(())
    }

    /// Waits for the next event or the next drawing. An idle program waits without a timeout.
    fn wait(&self, due: Option<Instant>, next_frame: &mut Instant) -> Waited {
        let now = Instant::now();
        let moves = self.app.moves();
        if moves {
            // Missed frames are skipped.
            *next_frame = (*next_frame).clamp(now, now + FRAME);
        }
        let until = match (due, moves) {
            (None, false) => return self.events.recv().map_or(Waited::InVain, Waited::Event),
            (Some(due), false) => due,
            (None, true) => *next_frame,
            (Some(due), true) => due.min(*next_frame),
        };
        match self
            .events
            .recv_timeout(until.saturating_duration_since(now))
        {
            Ok(event) => Waited::Event(event),
            Err(RecvTimeoutError::Timeout) if moves && until == *next_frame => {
                *next_frame += FRAME;
                Waited::Event(Event::Tick)
            }
            Err(RecvTimeoutError::Timeout) => Waited::Long,
            Err(RecvTimeoutError::Disconnected) => Waited::InVain,
        }
    }

    /// Handles an event and all that wait after it, so that a burst is drawn once.
    fn take(&mut self, first: Event, pace: &mut FrameScheduler) -> io::Result<Option<Ended>> {
        let mut next = Some(first);
        while let Some(event) = next {
            let reason = Reason::of(&event);
            // A check of the file without a change draws nothing.
            let silent = matches!(event, Event::Touched).then(|| self.app.message.clone());
            let is_answer = matches!(event, Event::Answer(_));
            let shows_peaks = self.app.curves.shows_peaks();
            let effects = self.app.update(event);
            let solves = effects
                .iter()
                .any(|effect| matches!(effect, Effect::Solve(_)));
            if let Some(ended) = self.perform(effects)? {
                return Ok(Some(ended));
            }
            // Readings that arrive meanwhile wait for their curves.
            let solves = solves || (is_answer && self.app.curves.is_stale());
            if silent.is_none_or(|said| self.app.message != said) {
                // Only visible peaks can vanish and come back.
                let reason = if is_answer && !shows_peaks {
                    Reason::Shows
                } else {
                    reason.asking(solves)
                };
                pace.wants(reason, Instant::now());
            }
            next = self.events.try_recv().ok();
        }
        self.performer.watch(self.app.document.source());
        Ok(None)
    }

    /// Reports that there is no shell to return to.
    fn say_alone(&mut self) {
        let words = "the terminal runs only this program: there is no shell to continue it";
        self.app.update(Event::Trouble(words.to_owned()));
    }

    fn perform(&mut self, effects: Vec<Effect>) -> io::Result<Option<Ended>> {
        for effect in effects {
            match self.performer.perform(effect, self.app) {
                Outcome::Done => {}
                Outcome::Redraw => self.session.repaint()?,
                Outcome::Suspend if terminal::can_suspend() => self.session.suspend()?,
                Outcome::Suspend => self.say_alone(),
                Outcome::Resume => self.session.resume()?,
                Outcome::Mouse(taken) => self.session.set_mouse(taken)?,
                Outcome::Copy(text) => Session::copy(&text)?,
                Outcome::Quit(None) => return Ok(Some(Ended::Left)),
                Outcome::Quit(Some(signal)) => return Ok(Some(Ended::Signal(signal))),
            }
        }
        Ok(None)
    }
}
