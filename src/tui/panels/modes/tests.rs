//! Modes, peaks, shapes and finite elements: effects of keys and answers.

use std::sync::Arc;

use crossterm::event::KeyCode;
use num_complex::Complex64;

use crate::solve::modes::{Completeness, Gap, Mode, ModeKind, Modes, Shape, Shares};
use crate::solve::peaks::Peak;
use crate::solve::{Column, ColumnKind, Frf};
use crate::tui::app::tests::{app, keys, number, press, said, select};
use crate::tui::app::{App, BeamView, Effect, FemOverlay, Message, Sensed, Table};
use crate::tui::event::Event;
use crate::tui::keys::Scope;
use crate::worker::{
    self, Answer, CurvesAnswer, Difference, ModalModel, Request, ShapeAnswer, ShapeRequest, Stage,
    WitnessAnswer, WitnessMember,
};

/// A model with modes at some frequencies (Hz), of which those in the sweep are peaks of the first response.
struct Bench {
    app: App,
    effects: Vec<Effect>,
}

impl Bench {
    /// fig05a sweeps from 1 to 400 Hz.
    fn new(frequencies: &[f64]) -> Self {
        let mut bench = Self {
            app: app("fig05a"),
            effects: Vec::new(),
        };
        bench.resolve(frequencies);
        bench
    }

    fn resolve(&mut self, frequencies: &[f64]) {
        self.answer_modes(frequencies, Completeness::Certain);
    }

    fn answer_modes(&mut self, frequencies: &[f64], completeness: Completeness) {
        let answer = Answer::Curves(resolved(&self.app, frequencies, completeness));
        self.effects = self.app.update(Event::Answer(answer));
    }

    fn keys(&mut self, text: &str) -> &mut Self {
        self.effects = keys(&mut self.app, text);
        self
    }

    fn press(&mut self, code: KeyCode) -> &mut Self {
        self.effects = press(&mut self.app, code);
        self
    }

    fn shape_asked_for(&self) -> Option<&ShapeRequest> {
        self.effects.iter().find_map(|effect| match effect {
            Effect::Solve(Request::Shape(request)) => Some(request),
            _ => None,
        })
    }

    fn answer_shape(&mut self, generation: u64, index: usize) {
        let ones = || vec![Complex64::ONE; 3];
        let shape = Shape {
            positions: vec![0.0, 1.6, 3.2],
            w: ones(),
            psi: ones(),
            v: ones(),
            masses: vec![[Complex64::ONE; 3]; 3],
            shares: Shares::default(),
        };
        self.app.update(Event::Answer(Answer::Shape(ShapeAnswer {
            generation,
            index,
            result: Ok(shape),
        })));
    }
}

fn mode(frequency: f64) -> Mode {
    let omega = std::f64::consts::TAU * frequency;
    Mode {
        omega: Complex64::from_polar(omega, 0.01),
        kind: match frequency {
            0.0 => ModeKind::RigidBody,
            _ => ModeKind::Oscillating,
        },
    }
}

fn resolved(app: &App, frequencies: &[f64], completeness: Completeness) -> CurvesAnswer {
    let modes = Modes {
        unstable: 0,
        to: app.model().sweep.to,
        undamped: frequencies.len(),
        modes: frequencies.iter().map(|f| mode(*f)).collect(),
        beyond: Vec::new(),
        completeness,
    };
    let peak = |(mode, frequency): (usize, &f64)| Peak {
        frequency: *frequency,
        height: 1e-5,
        phase: Some(-90.0),
        half_power_damping: Some(0.01),
        mode: Some(mode),
        overlaps: false,
        pole: false,
    };
    let column = Column {
        name: app.model().responses[0].name.clone(),
        kind: ColumnKind::Complex,
        values: vec![Complex64::ONE; 2],
    };
    let sweep = app.model().sweep;
    let in_sweep = |(_, f): &(usize, &f64)| (sweep.from..=sweep.to).contains(*f);
    let peaks = frequencies.iter().enumerate().filter(in_sweep).map(peak);
    CurvesAnswer {
        generation: app.curves.generation,
        stage: match modes.completeness {
            Completeness::Uncounted => Stage::Resolved,
            _ => Stage::Counted,
        },
        result: Ok(worker::Curves {
            members: vec![worker::Member {
                label: None,
                model: Arc::clone(app.model()),
                frf: Frf {
                    frequencies: vec![sweep.from, sweep.to],
                    columns: vec![column],
                },
                peaks: vec![peaks.collect()],
                damping_ratios: vec![0.01; frequencies.len()],
            }],
            modes: Some(ModalModel {
                shares: vec![Shares::default(); modes.modes.len()],
                modes: Arc::new(modes),
            }),
        }),
        elapsed: std::time::Duration::ZERO,
    }
}

/// The cursor to a hundredth of a hertz.
fn cursor(bench: &Bench) -> Option<f64> {
    let cursor = bench.app.curves.cursor?;
    Some((100.0 * cursor).round() / 100.0)
}

#[test]
fn the_cursor_jumps_from_mode_to_mode_in_the_sweep() {
    let mut bench = Bench::new(&[0.0, 0.0, 20.0, 50.0, 50.0, 120.0]);
    assert_eq!(cursor(bench.keys(")")), Some(20.0));
    assert_eq!(said(&bench.app), "mode 3 of 6: 20 Hz");
    // Both of two modes at one frequency.
    assert_eq!(cursor(bench.keys(")")), Some(50.0));
    assert_eq!(bench.app.tables.modes.row, 3);
    assert_eq!(cursor(bench.keys(")")), Some(50.0));
    assert_eq!(bench.app.tables.modes.row, 4);
    bench.keys(")");
    bench.keys(")");
    assert_eq!(said(&bench.app), "there is no next mode in the sweep");
    assert_eq!(cursor(bench.keys("((((")), Some(20.0));
    bench.keys("(");
    assert!(matches!(bench.app.message, Some(Message::Refused(_))));
    // From the cursor's position.
    bench.keys("]]]]]]]]]]]]]]]]]");
    assert_eq!(cursor(bench.keys("))")), Some(120.0));
}

#[test]
fn what_cannot_be_done_without_modes_says_why() {
    let mut waiting = app("fig05a");
    for key in [")", "(", "A"] {
        keys(&mut waiting, key);
        assert_eq!(said(&waiting), "the modes are not solved yet");
    }
    let mut none = Bench::new(&[]);
    none.keys(")");
    assert_eq!(said(&none.app), "there is no mode below 400 Hz");
    none.keys("A");
    assert_eq!(said(&none.app), "there is no mode to animate");
    let mut rigid = Bench::new(&[0.0]);
    rigid.keys("A");
    assert_eq!(said(&rigid.app), "the selected mode does not oscillate");
    assert!(!rigid.app.moves());
}

#[test]
fn a_table_takes_the_arrows_and_leaves_the_other_keys() {
    let mut bench = Bench::new(&[0.0, 20.0, 50.0]);
    select(&mut bench.app, "beam.length");
    let row = bench.app.selection.cursor();
    bench.keys("m");
    assert_eq!(bench.app.scope(), Scope::Table);
    bench.press(KeyCode::Down).press(KeyCode::Down);
    assert_eq!(cursor(&bench), Some(50.0));
    // A mode that is not on the axis has no cursor.
    assert_eq!(cursor(bench.press(KeyCode::Home)), None);
    assert_eq!(bench.app.selection.cursor(), row);
    bench.keys("+");
    assert!(number(&bench.app, "beam.length") > 3.2);
    bench.keys("P").press(KeyCode::End);
    assert_eq!(bench.app.tables.open, Some(Table::Peaks));
    assert_eq!(
        (bench.app.tables.peaks.row, cursor(&bench)),
        (1, Some(50.0))
    );
    bench.press(KeyCode::Esc);
    assert_eq!((bench.app.tables.open, cursor(&bench)), (None, Some(50.0)));
    bench.press(KeyCode::Esc);
    assert_eq!(cursor(&bench), None);
}

#[test]
fn the_cursor_stays_with_its_mode_while_a_parameter_is_turned() {
    let mut bench = Bench::new(&[20.0, 50.0, 120.0]);
    bench.keys("))");
    select(&mut bench.app, "beam.length");
    bench.keys("+").resolve(&[19.0, 48.5, 115.0]);
    assert_eq!(cursor(&bench), Some(48.5));
    // One more below it: the selection stays with the nearest.
    bench.keys("+").resolve(&[5.0, 19.0, 48.0, 114.0]);
    assert_eq!(
        (bench.app.tables.modes.row, cursor(&bench)),
        (2, Some(48.0))
    );
    // A moved cursor stays.
    bench.keys("]");
    let before = cursor(&bench);
    bench.keys("+").resolve(&[5.0, 18.0, 47.0, 113.0]);
    assert_eq!(cursor(&bench), before);
}

#[test]
fn the_selection_stays_on_its_mode_when_the_count_arrives() {
    let uncounted = |frequencies: &[f64], keys: &str| {
        let mut bench = Bench::new(&[]);
        bench.answer_modes(frequencies, Completeness::Uncounted);
        bench.keys(keys);
        bench
    };
    let selected = |bench: &Bench| (bench.app.tables.modes.row, cursor(bench));
    // No mode was missing.
    let mut bench = uncounted(&[20.0, 50.0, 120.0], "))");
    bench.resolve(&[20.0, 50.0, 120.0]);
    assert_eq!(selected(&bench), (1, Some(50.0)));
    // One more below it.
    let mut bench = uncounted(&[20.0, 50.0, 120.0], "))");
    bench.resolve(&[5.0, 20.0, 50.0, 120.0]);
    assert_eq!(selected(&bench), (2, Some(50.0)));
    // One more below it, and a mode that was none above it: the number is unchanged.
    let mut bench = uncounted(&[20.0, 50.0, 120.0], "))");
    bench.resolve(&[5.0, 20.0, 50.0]);
    assert_eq!(selected(&bench), (2, Some(50.0)));
    // The second of two at one place.
    let mut bench = uncounted(&[20.0, 50.0, 50.0, 120.0], ")))");
    bench.resolve(&[5.0, 20.0, 50.0, 50.0, 120.0]);
    assert_eq!(selected(&bench), (3, Some(50.0)));
}

#[test]
fn what_the_count_finds_is_no_change_of_the_model() {
    let change = |bench: &Bench| bench.app.modes.list.as_ref().unwrap().change;
    let mut bench = Bench::new(&[20.0, 50.0, 120.0]);
    select(&mut bench.app, "beam.length");
    // One mode is lost on the way, and found by the count.
    bench
        .keys("+")
        .answer_modes(&[20.0, 120.0], Completeness::Uncounted);
    assert_eq!(change(&bench), Some(-1));
    bench.resolve(&[20.0, 50.0, 120.0]);
    assert_eq!(change(&bench), Some(0));
    // One mode is new, before and after the count.
    bench
        .keys("+")
        .answer_modes(&[20.0, 50.0, 120.0, 390.0], Completeness::Uncounted);
    assert_eq!(change(&bench), Some(1));
    bench.resolve(&[20.0, 50.0, 120.0, 390.0]);
    assert_eq!(change(&bench), Some(1));
}

#[test]
fn a_shape_is_solved_again_only_where_the_count_found_other_modes() {
    let mut bench = Bench::new(&[20.0, 50.0]);
    bench.keys("M");
    select(&mut bench.app, "beam.length");
    bench
        .keys("+")
        .answer_modes(&[20.0, 50.0], Completeness::Uncounted);
    assert_eq!(bench.shape_asked_for().unwrap().index, 0);
    bench.resolve(&[20.0, 50.0]);
    assert!(bench.shape_asked_for().is_none());
    bench
        .keys("+")
        .answer_modes(&[20.0, 50.0], Completeness::Uncounted);
    assert_eq!(bench.shape_asked_for().unwrap().index, 0);
    // Another mode is its neighbour.
    bench.resolve(&[20.0, 20.1, 50.0]);
    let asked = bench.shape_asked_for().unwrap();
    assert_eq!((asked.index, asked.modes.modes.len()), (0, 3));
}

#[test]
fn sensitivities_of_a_mode_and_of_a_band_wait_for_the_count() {
    for (sensed, keys) in [(Sensed::Mode, "))~~~"), (Sensed::Band, ")c)_~~~~")] {
        let asked = |bench: &Bench| {
            let wanted = |effect: &Effect| matches!(effect, Effect::Solve(Request::Sensitivity(_)));
            bench.effects.iter().any(wanted)
        };
        let mut bench = Bench::new(&[20.0, 50.0]);
        bench.keys(keys);
        assert_eq!(bench.app.sensitivities.sensed, Some(sensed));
        assert!(asked(&bench));
        select(&mut bench.app, "beam.length");
        bench
            .keys("+")
            .answer_modes(&[20.0, 50.0], Completeness::Uncounted);
        assert!(!asked(&bench));
        bench.resolve(&[20.0, 50.0]);
        assert!(asked(&bench));
    }
}

#[test]
fn what_is_exported_says_that_a_peak_may_be_missing() {
    let notes = |bench: &Bench| crate::tui::export::provenance(&bench.app).notes.join("\n");
    let mut bench = Bench::new(&[20.0, 50.0]);
    assert!(!notes(&bench).contains("a peak may be missing"));
    let uncounted = "a peak may be missing: the modes are not counted yet";
    let gap = Gap {
        from: 40.0,
        to: 60.0,
        found: 1,
        counted: Some(2),
    };
    let open =
        "a peak may be missing: the modes are not certain between 40 and 60 Hz: 2 counted, 1 found";
    for (completeness, wanted) in [
        (Completeness::Uncounted, uncounted),
        (Completeness::Open(vec![gap]), open),
    ] {
        bench.answer_modes(&[20.0, 50.0], completeness);
        assert!(notes(&bench).contains(wanted), "{}", notes(&bench));
    }
}

#[test]
fn curves_that_are_frozen_before_the_count_are_solved_with_it() {
    let asked = |bench: &Bench| {
        let wanted = |effect: &Effect| matches!(effect, Effect::Solve(Request::Reference(_)));
        bench.effects.iter().any(wanted)
    };
    let mut bench = Bench::new(&[20.0, 50.0]);
    assert!(!asked(bench.keys("f")));
    select(&mut bench.app, "beam.length");
    bench
        .keys("+")
        .answer_modes(&[20.0, 50.0], Completeness::Uncounted);
    assert!(asked(bench.keys("f")));
}

#[test]
fn the_count_says_whether_a_mode_was_lost_or_won() {
    let change = |bench: &Bench| bench.app.modes.list.as_ref().unwrap().change;
    let mut bench = Bench::new(&[20.0, 50.0]);
    assert_eq!(change(&bench), None);
    select(&mut bench.app, "beam.length");
    bench.keys("+").resolve(&[20.0, 50.0, 390.0]);
    assert_eq!(change(&bench), Some(1));
    bench.keys("-").resolve(&[20.0, 50.0]);
    assert_eq!(change(&bench), Some(-1));
    bench.keys("+").resolve(&[20.0, 50.0]);
    assert_eq!(change(&bench), Some(0));
    // Another range has other modes: they cannot be compared.
    select(&mut bench.app, "sweep.to");
    bench.keys("-").resolve(&[20.0]);
    assert_eq!(change(&bench), None);
}

#[test]
fn a_shape_is_asked_for_once_and_for_what_shows() {
    let mut bench = Bench::new(&[20.0, 50.0]);
    assert!(bench.shape_asked_for().is_none());
    bench.keys("M");
    let (generation, index) = {
        let asked = bench.shape_asked_for().unwrap();
        (asked.generation, asked.index)
    };
    assert_eq!((generation, index), (1, 0));
    bench.keys("d");
    assert!(bench.shape_asked_for().is_none());
    bench.answer_shape(generation, index);
    assert_eq!(bench.app.modes.shape.as_ref().unwrap().places.len(), 3);
    bench.keys("))");
    assert_eq!(bench.shape_asked_for().unwrap().index, 1);
    // An answer to an older request is not shown.
    bench.answer_shape(1, 0);
    bench.answer_shape(1, 1);
    bench.answer_shape(1, 0);
    assert_eq!(bench.app.modes.shape.as_ref().unwrap().mode, 1);
    // A changed model's shape waits for its modes.
    select(&mut bench.app, "beam.length");
    bench.keys("+");
    assert!(bench.shape_asked_for().is_none());
    bench.resolve(&[20.0, 50.0]);
    assert_eq!(bench.shape_asked_for().unwrap().generation, 2);
}

#[test]
fn a_shape_moves_only_while_it_can_be_seen() {
    let mut bench = Bench::new(&[20.0]);
    bench.keys("A");
    assert!(!bench.app.moves(), "nothing is there to move yet");
    bench.answer_shape(1, 0);
    assert!(bench.app.moves());
    let angle = bench.app.beam_view.moment.angle();
    bench.app.update(Event::Tick);
    assert!(bench.app.beam_view.moment.angle() > angle);
    bench.keys("?");
    assert!(!bench.app.moves(), "help covers it");
    bench.press(KeyCode::Esc);
    assert!(bench.app.moves());
    bench.keys("A");
    assert_eq!(bench.app.beam_view.shown, Some(BeamView::Mode));
    assert!(!bench.app.moves());
    bench.keys("AM");
    assert_eq!(bench.app.beam_view.shown, None);
    assert!(!bench.app.moves());
}

#[test]
fn finite_elements_wait_for_the_exact_curves_and_follow_the_model() {
    let asked = |bench: &Bench| {
        let wanted = |effect: &Effect| matches!(effect, Effect::Solve(Request::Witness(_)));
        bench.effects.iter().any(wanted)
    };
    let answer = |bench: &mut Bench, generation| {
        let answer = WitnessAnswer {
            generation,
            result: Ok(vec![WitnessMember {
                elements: 40,
                frf: Frf {
                    frequencies: vec![1.0],
                    columns: Vec::new(),
                },
                differences: vec![Some(Difference {
                    decibels: 0.1,
                    frequency: 1.0,
                })],
            }]),
        };
        bench.app.update(Event::Answer(Answer::Witness(answer)));
    };
    let mut bench = Bench::new(&[20.0]);
    assert!(asked(bench.keys("w")));
    assert!(!asked(bench.keys("d")));
    answer(&mut bench, 1);
    assert!(matches!(bench.app.fem_overlay, FemOverlay::Shown(_)));
    select(&mut bench.app, "beam.length");
    assert!(!asked(bench.keys("+")));
    assert!(matches!(
        bench.app.fem_overlay,
        FemOverlay::Waiting(Some(_))
    ));
    bench.resolve(&[20.0]);
    assert!(asked(&bench));
    // The answer for the older model is too late.
    answer(&mut bench, 1);
    assert!(matches!(bench.app.fem_overlay, FemOverlay::Waiting(_)));
    bench.keys("w");
    answer(&mut bench, 2);
    assert!(matches!(bench.app.fem_overlay, FemOverlay::Off));
}
