use crate::model::checked;
use std::sync::atomic::AtomicBool;
use std::sync::mpsc::{Receiver, channel};

use super::*;
use crate::model::Checked;
use crate::model::Model;
use crate::presets;
use crate::solve::modes::Completeness;
use crate::solve::{frequencies, sweep};

fn model(preset: &str) -> Arc<Checked> {
    Arc::new(checked(
        &crate::model::read(presets::find(preset).unwrap().text)
            .unwrap()
            .into_inner(),
    ))
}

fn worker() -> (Worker, Receiver<Answer>) {
    let (sender, receiver) = channel();
    // Sending fails after the test has dropped the receiver.
    let worker = Worker::start(move |answer| drop(sender.send(answer)));
    (worker, receiver)
}

fn subject(generation: u64, model: &Arc<Checked>, study: Option<usize>) -> Subject {
    Subject {
        generation,
        model: Arc::clone(model),
        study,
    }
}

fn curves(receiver: &Receiver<Answer>, generation: u64, stage: Stage) -> Curves {
    let wanted = |answer: Answer| match answer {
        Answer::Curves(a) if a.generation == generation && a.stage == stage => Some(a.result),
        _ => None,
    };
    receiver.iter().find_map(wanted).unwrap().unwrap()
}

#[test]
fn the_newest_request_is_answered_in_full() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    for generation in 1..=20 {
        worker.request(Request::Curves(subject(generation, &model, None)));
    }
    let full = curves(&receiver, 20, Stage::Full);
    let expected = sweep(&model, &frequencies(&model.sweep), &AtomicBool::new(false)).unwrap();
    assert_eq!(full.members[0].frf, expected);
}

#[test]
fn resolved_curves_hold_every_frequency_of_the_sweep_and_more() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    worker.request(Request::Curves(subject(1, &model, None)));
    let full = curves(&receiver, 1, Stage::Full);
    let resolved = curves(&receiver, 1, Stage::Resolved);
    let [full, resolved_frf] = [&full, &resolved].map(|curves| &curves.members[0].frf);
    assert!(resolved_frf.frequencies.len() > full.frequencies.len());
    assert!(resolved_frf.frequencies.is_sorted_by(|a, b| a < b));
    for (row, f) in full.frequencies.iter().enumerate() {
        let place = resolved_frf
            .frequencies
            .iter()
            .position(|g| g == f)
            .unwrap();
        for (column, resolved) in full.columns.iter().zip(&resolved_frf.columns) {
            assert_eq!(column.values[row], resolved.values[place], "{f} Hz");
        }
    }
    let modal = resolved.modes.as_ref().unwrap();
    assert_eq!(modal.modes.to, model.sweep.to);
    assert_eq!(modal.shares.len(), modal.modes.modes.len());
    assert_eq!(resolved.members[0].peaks.len(), resolved_frf.columns.len());
}

#[test]
fn modes_come_before_their_count() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    worker.request(Request::Curves(subject(1, &model, None)));
    let [resolved, counted] =
        [Stage::Resolved, Stage::Counted].map(|stage| curves(&receiver, 1, stage));
    let [before, after] = [&resolved, &counted].map(|curves| &curves.modes.as_ref().unwrap().modes);
    assert_eq!(before.completeness, Completeness::Uncounted);
    assert_eq!(after.completeness, Completeness::Certain);
    // The count finds nothing missing, so nothing else changes.
    assert!(after.has_modes_of(before));
    assert_eq!(counted.members, resolved.members);
}

/// fig05a with a damper far above critical damping: only the count finds the overdamped modes.
fn overdamped() -> Arc<Checked> {
    let mut model = Model::clone(&model("fig05a"));
    model.subsystems[1].y_left.damping = 1e6;
    model.subsystems[1].y_right.damping = 1e6;
    Arc::new(checked(&model))
}

#[test]
fn what_the_count_finds_is_in_the_modes_and_the_curves() {
    let (worker, receiver) = worker();
    let model = overdamped();
    worker.request(Request::Curves(subject(1, &model, None)));
    let [resolved, counted] =
        [Stage::Resolved, Stage::Counted].map(|stage| curves(&receiver, 1, stage));
    let number = |curves: &Curves| curves.modes.as_ref().unwrap().modes.modes.len();
    assert!(number(&counted) > number(&resolved));
    let modal = counted.modes.as_ref().unwrap();
    assert_eq!(modal.modes.completeness, Completeness::Certain);
    assert_eq!(modal.shares.len(), number(&counted));
    assert_eq!(counted.members[0].damping_ratios.len(), number(&counted));
    // The next edit follows all of them.
    let mut longer = Model::clone(&model);
    longer.beam.length *= 1.001;
    worker.request(Request::Curves(subject(
        2,
        &Arc::new(checked(&longer)),
        None,
    )));
    let followed = curves(&receiver, 2, Stage::Resolved);
    assert_eq!(number(&followed), number(&counted));
}

/// The solved, unresolved curves of a model.
fn unresolved(generation: u64, model: &Arc<Checked>) -> Unresolved {
    let never = AtomicBool::new(false);
    let subject = subject(generation, model, None);
    curves::answer(subject, &CurveCache::default(), &never, &|_| ())
        .unwrap()
        .unwrap()
}

#[test]
fn the_next_edit_cancels_the_count_and_the_last_one_makes_it() {
    let model = model("fig08");
    let mut longer = Model::clone(&model);
    longer.beam.length *= 1.001;
    let longer = Arc::new(checked(&longer));
    let mut resolver = Resolver::default();
    // An edit arrives as soon as the modes are shown.
    for (generation, model) in [(1, &model), (2, &longer), (3, &model)] {
        let cancel = AtomicBool::new(false);
        let answers = std::sync::Mutex::new(Vec::new());
        resolver.answer(&unresolved(generation, model), &cancel, &|answer| {
            answers.lock().unwrap().push(answer.stage);
            cancel.store(true, std::sync::atomic::Ordering::Relaxed);
        });
        assert_eq!(*answers.lock().unwrap(), [Stage::Resolved]);
    }
    // No key is pressed; the same model again, as when a study is selected.
    let (sender, receiver) = channel();
    let never = AtomicBool::new(false);
    resolver.answer(&unresolved(4, &model), &never, &|answer| {
        drop(sender.send(answer));
    });
    let answers: Vec<CurvesAnswer> = receiver.try_iter().collect();
    let stages: Vec<Stage> = answers.iter().map(|answer| answer.stage).collect();
    assert_eq!(stages, [Stage::Resolved, Stage::Counted]);
    let counted = answers[1].result.as_ref().unwrap().modes.as_ref().unwrap();
    assert_eq!(counted.modes.completeness, Completeness::Certain);
    // The count is then verified.
    resolver.answer(&unresolved(5, &model), &never, &|answer| {
        drop(sender.send(answer));
    });
    let answers: Vec<Stage> = receiver.try_iter().map(|answer| answer.stage).collect();
    assert_eq!(answers, [Stage::Counted]);
}

#[test]
fn a_model_to_compare_with_has_its_modes_counted() {
    let (worker, receiver) = worker();
    worker.request(Request::Reference(subject(1, &overdamped(), None)));
    let found = receiver.iter().find_map(|answer| match answer {
        Answer::Reference(answer) => Some(answer.result.unwrap()),
        _ => None,
    });
    let modes = found.unwrap().modes.unwrap().modes;
    assert_eq!(modes.completeness, Completeness::Certain);
}

#[test]
fn followed_modes_equal_those_of_a_full_search() {
    let before = model("fig08");
    let mut changed = Model::clone(&before);
    changed.beam.length *= 1.01;
    let changed = Arc::new(checked(&changed));
    let modes_of = |models: &[&Arc<Checked>]| {
        let (worker, receiver) = worker();
        let mut modes = None;
        for (generation, model) in (1..).zip(models) {
            worker.request(Request::Curves(subject(generation, model, None)));
            modes = curves(&receiver, generation, Stage::Counted).modes;
        }
        modes.unwrap().modes
    };
    let (followed, fresh) = (modes_of(&[&before, &changed]), modes_of(&[&changed]));
    assert_eq!(followed.modes.len(), fresh.modes.len());
    assert_eq!(followed.completeness, fresh.completeness);
    for (a, b) in followed.modes.iter().zip(&fresh.modes) {
        // Both have a relative tolerance of 1e-10.
        assert!((a.omega - b.omega).norm() <= 1e-9 * b.omega.norm() + 1e-9);
    }
}

#[test]
fn a_study_gives_one_labelled_member_for_each_value_and_the_modes_of_the_model_itself() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    worker.request(Request::Curves(subject(6, &model, None)));
    let alone = curves(&receiver, 6, Stage::Counted);
    worker.request(Request::Curves(subject(7, &model, Some(0))));
    let study = curves(&receiver, 7, Stage::Counted);
    assert_eq!(study.members.len(), 4);
    assert!(study.members.iter().all(|member| member.label.is_some()));
    assert_ne!(study.members[0].frf, study.members[3].frf);
    assert_ne!(study.members[0].peaks, study.members[3].peaks);
    assert_eq!(study.modes, alone.modes);
}

#[test]
fn a_shape_has_its_places_and_every_mass() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    worker.request(Request::Curves(subject(1, &model, None)));
    let modal = curves(&receiver, 1, Stage::Resolved).modes.unwrap();
    worker.request(Request::Shape(ShapeRequest {
        generation: 1,
        model: Arc::clone(&model),
        modes: modal.modes,
        index: 2,
    }));
    let shape = receiver.iter().find_map(|answer| match answer {
        Answer::Shape(answer) => Some(answer.result.unwrap()),
        _ => None,
    });
    let shape = shape.unwrap();
    assert_eq!(shape.w.len(), SHAPE_POINTS);
    assert_eq!(shape.masses.len(), model.subsystems.len());
}

#[test]
fn every_member_has_finite_element_curves() {
    let (worker, receiver) = worker();
    let model = model("fig08");
    worker.request(Request::Witness(subject(3, &model, Some(0))));
    let members = receiver.iter().find_map(|answer| match answer {
        Answer::Witness(answer) => Some(answer.result.unwrap()),
        _ => None,
    });
    let members = members.unwrap();
    assert_eq!(members.len(), 4);
    for member in members {
        assert_eq!(member.frf.frequencies, frequencies(&model.sweep));
        assert_eq!(member.differences.len(), member.frf.columns.len());
    }
}

#[test]
fn dropping_the_worker_ends_its_threads() {
    let (worker, receiver) = worker();
    let model = model("hundred_absorbers");
    worker.request(Request::Curves(subject(1, &model, None)));
    worker.request(Request::Witness(subject(1, &model, None)));
    drop(worker);
    // The threads hold the only senders: the channel closes when they end.
    assert!(receiver.iter().count() <= 5);
}

#[test]
fn a_prepared_edit_is_solved_from_the_cache() {
    let never = AtomicBool::new(false);
    let cache = CurveCache::default();
    let model = hundred_without_energy();
    let edited = [1.01, 1.02].map(|factor| {
        let mut model = Model::clone(&model);
        model.subsystems[50].mass *= factor;
        Arc::new(checked(&model))
    });
    cache.sweep(0, &model, &never).unwrap();
    assert_eq!(cache.last(0), Some(Arc::clone(&model)));
    let solved = [(None, Arc::clone(&edited[0]))];
    let edit = cache.edit_to_prepare(cache.last(0), &solved).unwrap();
    cache.expect(&edit, &never).unwrap();
    // Another edit of the same parameter, not prepared.
    assert!(cache.has_curves(0, &edited[1]));
    assert!(cache.edit_to_prepare(Some(model), &solved).is_none());
    let (all, _) = cache.sweep(0, &edited[1], &never).unwrap();
    let few = cache.few(0, &edited[1], &never).unwrap().unwrap();
    assert!(few.frequencies.len() < all.frequencies.len() / 4);
    // Solved without the cache, by the same equations; 1e-12 of the largest value of each response.
    for found in [all, few] {
        let expected = sweep(&edited[1], &found.frequencies, &never).unwrap();
        for (one, other) in found.columns.iter().zip(&expected.columns) {
            let sizes = other.values.iter().map(|value| value.norm());
            let largest = sizes.fold(0.0, f64::max);
            let pairs = one.values.iter().zip(&other.values);
            let worst = pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            assert!(worst <= 1e-12 * largest, "{}: {worst}", one.name);
        }
    }
    // Another sweep has other frequencies.
    let mut other = Model::clone(&edited[1]);
    other.sweep.to *= 1.1;
    assert!(cache.few(0, &checked(&other), &never) == Ok(None));
}

#[test]
fn curves_know_their_last_peaks_once() {
    let never = AtomicBool::new(false);
    let cache = CurveCache::default();
    let model = hundred_without_energy();
    let mut resolved = sweep(&model, &frequencies(&model.sweep), &never).unwrap();
    // An invented peak between two frequencies of the sweep, and one at a frequency of the sweep.
    let [low, high] = [resolved.frequencies[10], resolved.frequencies[11]];
    let peak = 0.5 * (low + high);
    let mut near = sweep(&model, &[low, peak], &never).unwrap();
    for column in &mut near.columns {
        column.values[1] *= 1e6;
    }
    resolved = resolved.merged(&near);
    assert_eq!(resolved.frequencies.len(), model.sweep.points + 1);
    cache.store_peaks(0, &model, &resolved);
    assert_eq!(cache.peaks_between(0, &model), [peak]);
    let (base, shown) = cache.sweep(0, &model, &never).unwrap();
    assert_eq!(base.frequencies, frequencies(&model.sweep));
    assert_eq!(shown.unwrap().frequencies, resolved.frequencies);
}

/// The preset of a hundred absorbers, with responses of motions only.
fn hundred_without_energy() -> Arc<Checked> {
    let mut model = Model::clone(&model("hundred_absorbers"));
    let is_motion = |one: &crate::model::Response| one.quantity != crate::model::Quantity::Energy;
    model.responses.retain(is_motion);
    Arc::new(checked(&model))
}

#[test]
fn a_preparation_that_fails_keeps_the_cache() {
    let never = AtomicBool::new(false);
    let cache = CurveCache::default();
    let model = hundred_without_energy();
    let mut edited = Model::clone(&model);
    edited.subsystems[50].mass *= 1.01;
    let expect = |edited: &Checked| {
        let edit = ExpectRequest {
            model: Arc::clone(&model),
            edited: Arc::new(edited.clone()),
        };
        cache.expect(&edit, &never).unwrap();
    };
    expect(&checked(&edited));
    assert!(cache.has_curves(0, &checked(&edited)));
    // The whole beam changes: nothing can be cached for that edit.
    let mut other = Model::clone(&model);
    other.beam.material.young_modulus *= 1.01;
    expect(&checked(&other));
    assert!(cache.has_curves(0, &checked(&edited)));
    assert!(!cache.has_curves(0, &checked(&other)));
}

#[test]
fn a_beam_with_too_many_modes_gets_its_curves_and_no_search() {
    // It has far more half waves than the modes that are listed.
    let (worker, receiver) = worker();
    let mut long = Model::clone(&model("fig06"));
    long.beam.length = 1e7;
    let long = Arc::new(checked(&long));
    worker.request(Request::Curves(subject(1, &long, None)));
    let resolved = curves(&receiver, 1, Stage::Counted);
    let modes = resolved.modes.unwrap().modes;
    assert_eq!(modes.completeness, Completeness::TooMany);
    assert!(modes.modes.is_empty());
    let columns = resolved.members[0].frf.columns.len();
    assert_eq!(resolved.members[0].peaks.len(), columns);
}
