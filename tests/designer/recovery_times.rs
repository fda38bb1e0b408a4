//! From an edit to its place in the recovery file: run with
//! `cargo test --release --lib recovery_times -- --ignored --nocapture`.
//!
//! Models of 1, 1,000 and 10,000 subsystems while a key that turns a parameter is held: 30 edits a second, each of the
//! mass of one subsystem, and then each of all of them.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use beamtune::files::Source;
use beamtune::model::{self, Model};
use beamtune::presets;
use beamtune::tui::user::recovery::{Keeper, Kept, found};

/// From one edit to the next, the repeat rate of keys.
const REPEAT: Duration = Duration::from_millis(33);

/// Edits of each.
const EDITS: usize = 60;

/// fig08 with this many subsystems.
fn state(count: usize) -> Kept {
    let mut model = model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    let first = model.subsystems[0].clone();
    let step = model.beam.length / (count + 1) as f64;
    let numbered = (1..=count).map(|number| {
        let mut one = first.clone();
        one.name = format!("absorber {number}");
        one.position = step * number as f64;
        one
    });
    model.subsystems = numbered.collect();
    let name = first.name;
    let is_on_it =
        |target: &model::Target| matches!(target, model::Target::Mass(on, _) if *on == name);
    model.forces.retain(|force| !is_on_it(&force.target));
    model.responses.retain(|response| match &response.quantity {
        model::Quantity::Motion(target, _) => !is_on_it(target),
        model::Quantity::Energy => true,
    });
    model.studies.clear();
    model.tune = None;
    let base: Arc<str> = model::write(&model, "").into();
    let saved = Arc::new(model::read(&base).unwrap());
    Kept {
        source: Source::Stdin,
        model: Arc::clone(&saved),
        saved,
        base,
    }
}

/// The recovery file's length and modification time; they change if it is replaced or appended to.
fn stamp(folder: &Path) -> Option<(u64, std::time::SystemTime)> {
    let entries = std::fs::read_dir(folder).ok()?.flatten();
    let mut files = entries.filter(|one| one.path().extension().is_some_and(|end| end == "toml"));
    let found = files.next()?.metadata().ok()?;
    Some((found.len(), found.modified().ok()?))
}

/// Stores edits one after the other; returns the time of each, ms.
fn hold(state: &mut Kept, edit: impl Fn(&mut Model)) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    let keeper = Keeper::start(folder.path().to_owned(), |sentence| panic!("{sentence}"));
    let mut times = Vec::new();
    let mut due = Instant::now();
    for _ in 0..EDITS {
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        due += REPEAT;
        state.model = Arc::new(state.model.derived(&edit));
        let before = stamp(folder.path());
        let start = Instant::now();
        keeper.keep(state.clone());
        while stamp(folder.path()) == before {
            std::thread::sleep(Duration::from_micros(100));
        }
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    drop(keeper);
    let start = Instant::now();
    let model = found(folder.path())[0].model().unwrap();
    println!(
        "    replayed in {:.0} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    assert_eq!(model, *state.model);
    times
}

#[test]
#[ignore = "measures times"]
fn an_edit_is_on_disk_soon() {
    for count in [1, 1000, 10_000] {
        let mut state = state(count);
        println!("{count} subsystems, {} bytes", state.base.len());
        let one = hold(&mut state, |model| {
            model.subsystems[count / 2].mass *= 1.001;
        });
        let all = hold(&mut state, |model| {
            model
                .subsystems
                .iter_mut()
                .for_each(|one| one.mass *= 1.001);
        });
        for (what, mut times) in [("one", one), ("all", all)] {
            let first = times[0];
            times.sort_by(f64::total_cmp);
            let (median, worst) = (times[EDITS / 2], times[EDITS - 1]);
            println!(
                "    mass of {what}: first {first:.1} ms, median {median:.1} ms, worst {worst:.1} ms"
            );
        }
    }
}
