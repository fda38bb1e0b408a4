use super::*;
use crate::model::Model;
use crate::tui::app::BeamView;
use crate::tui::panels::beam_view::animated::stage::{self, looking, preset, screen};

fn damped() -> Model {
    let mut model = preset("fig05a");
    model.beam.material.loss_factor = 0.01;
    model
}

fn seen(app: &App) -> Seen<'_> {
    Seen {
        model: app.model(),
        operating: app.beam_view.operating().unwrap(),
        at: "",
        angle: 0.0,
        stale: false,
        theme: Theme::new(false),
    }
}

#[test]
fn what_takes_most_out_comes_first_and_all_of_it_is_all_that_comes_in() {
    let app = looking(damped(), 35.0, BeamView::Power);
    let rows = rows(seen(&app));
    let labels: Vec<&str> = rows.iter().map(|row| row.label.as_str()).collect();
    assert_eq!(
        labels[..4],
        ["in left w", "in left psi", "in left v", "material"]
    );
    // 12 dampers at the masses, 4 at the supports, the material.
    assert_eq!(rows.len(), 3 + 12 + 4 + 1);
    assert!(rows[3..].is_sorted_by(|a, b| a.power >= b.power));
    let total = |loss: bool| -> f64 {
        rows.iter()
            .filter(|row| row.loss == loss)
            .map(|row| row.power)
            .sum()
    };
    assert!((total(true) / total(false) - 1.0).abs() < 1e-9);
    let few = fitted(rows.clone(), 6);
    assert_eq!(few.len(), 6);
    assert_eq!(few[5].label, "15 more");
    let all = |rows: &[Row]| -> f64 { rows.iter().map(|row| row.power).sum() };
    assert!((all(&few) - all(&rows)).abs() < 1e-12 * all(&rows));
}

#[test]
fn the_table_has_shares_bars_and_a_balance_and_the_flow_where_there_is_room() {
    let app = looking(damped(), 35.0, BeamView::Power);
    let lines = screen(&app, Theme::new(false), draw, [80, 14]);
    assert!(lines[0].contains("Power at 35 Hz"), "{lines:#?}");
    let (input, loss) = lines[0]
        .split_once("in ")
        .unwrap()
        .1
        .split_once(" W, out ")
        .unwrap();
    assert_eq!(loss, format!("{input} W"));
    assert!(lines[2].contains("flow to the right"), "{lines:#?}");
    assert!(lines[1].contains('W') && lines[1].contains('%'));
    let material = lines
        .iter()
        .find(|line| line.starts_with("material"))
        .unwrap();
    assert!(material.contains("█████"), "{lines:#?}");
    let narrow = screen(&app, Theme::new(false), draw, [44, 9]);
    assert!(!narrow.join("").contains("flow"), "{narrow:#?}");
    assert!(narrow[8].contains("more"), "{narrow:#?}");
}

#[test]
fn without_a_loss_there_is_no_share() {
    let mut model = preset("fig06");
    for support in [&mut model.supports.left, &mut model.supports.right] {
        *support = crate::model::Support::PINNED;
    }
    model.forces.truncate(1);
    model.forces[0].target = Target::Beam(Place::Position(1.0), crate::model::BeamMotion::V);
    let app = looking(model, 20.0, BeamView::Power);
    let lines = screen(&app, Theme::new(false), draw, [44, 9]);
    assert!(
        lines[0].contains("out 0 W") || lines.len() == 9,
        "{lines:#?}"
    );
    assert!(lines[2].starts_with("in 1 m v"), "{lines:#?}");
    assert!(lines[2].trim_end().ends_with('-'), "{lines:#?}");
}

#[test]
fn it_fits_any_size_and_set_of_characters() {
    stage::draws_at_any_size(draw, BeamView::Power);
}
