use super::*;
use crate::tui::app::BeamView;
use crate::tui::panels::beam_view::animated::stage::{self, looking, pinned, preset, screen};

#[test]
fn a_slow_force_bends_the_beam_to_its_side_when_it_is_largest() {
    // Closed form: w = F L^3 / (48 E Iy) = 1.955e-8 m for 1 N; the force leads by 90 deg, so it is largest at omega t =
    // 270 deg. 1 is the upper label; the middle of 3.2 m is the middle column of the plot.
    let app = looking(pinned(90.0), 0.01, BeamView::Deflection);
    let lines = screen(&app, Theme::new(false), draw, [80, 16]);
    assert!(
        lines[0].contains("Deflection at 0.01 Hz, phase 270 deg"),
        "{lines:#?}"
    );
    assert!(lines[0].ends_with("1 is 2.0e-8 m"), "{lines:#?}");
    let top = lines
        .iter()
        .find(|line| line.trim_start().starts_with("1┤"))
        .unwrap();
    let plot = 5..80;
    let drawn: Vec<usize> = (plot.clone())
        .filter(|column| top.chars().nth(*column).is_some_and(|c| !c.is_whitespace()))
        .collect();
    let middle = drawn[0].midpoint(drawn[drawn.len() - 1]);
    assert!(
        middle.abs_diff(plot.start.midpoint(plot.end)) <= 1,
        "{drawn:?}"
    );
    assert!(
        !lines.join("").contains("psi"),
        "nothing twists: {lines:#?}"
    );
}

#[test]
fn masses_are_letters_and_the_scale_shows_at_any_width() {
    let app = looking(preset("fig05a"), 35.0, BeamView::Deflection);
    let wide = screen(&app, Theme::new(false), draw, [90, 14]);
    assert!(
        wide[0].contains(" 1 is ") && wide[0].ends_with(" rad"),
        "{wide:#?}"
    );
    assert!(wide[1].contains("z t masses"), "{wide:#?}");
    let narrow = screen(&app, Theme::new(false), draw, [44, 10]);
    assert!(
        narrow[1].contains("1 is ") && narrow[1].contains(" rad"),
        "{narrow:#?}"
    );
    // Three masses, each with its letters; they may cover each other.
    let letters = |letter| {
        wide[2..]
            .iter()
            .map(|line| line.matches(letter).count())
            .sum::<usize>()
    };
    assert_eq!(letters("z"), 3, "{wide:#?}");
}

#[test]
fn half_a_period_later_all_is_on_the_other_side() {
    // Closed form: the real part changes its sign.
    let app = looking(preset("fig05a"), 35.0, BeamView::Deflection);
    let seen = |angle| Seen {
        model: app.model(),
        operating: app.beam_view.operating().unwrap(),
        at: "",
        angle,
        stale: false,
        theme: Theme::new(false),
    };
    let reach = Reach::of(app.beam_view.operating().unwrap());
    for number in 0..3 {
        let now = Motion::new(seen(0.4), reach, number);
        let later = Motion::new(seen(0.4 + std::f64::consts::PI), reach, number);
        let pairs = now
            .beam
            .iter()
            .zip(&later.beam)
            .chain(now.masses.iter().zip(&later.masses));
        for (a, b) in pairs {
            assert!((a + b).abs() < 1e-12);
            assert!(a.abs() <= 1.0 + 1e-12);
        }
    }
}

#[test]
fn what_is_not_there_is_said() {
    let mut app = looking(pinned(90.0), 20.0, BeamView::Deflection);
    app.beam_view.operating = None;
    let text = screen(&app, Theme::new(false), draw, [60, 9]).join("\n");
    assert!(text.contains("computing the beam's motion"), "{text}");
    app.curves.cursor = None;
    let text = screen(&app, Theme::new(false), draw, [60, 9]).join("\n");
    assert!(text.contains("there is no cursor on the chart"), "{text}");
    let mut resonant = looking(pinned(90.0), 20.0, BeamView::Deflection);
    let mut found = resonant.beam_view.operating().unwrap().clone();
    found.motion[0][3] = num_complex::Complex64::new(f64::NAN, 0.0);
    let model = std::sync::Arc::clone(resonant.model());
    resonant.beam_view.operating = Some((model, std::sync::Arc::new(found)));
    let text = screen(&resonant, Theme::new(false), draw, [60, 9]).join("\n");
    assert!(
        text.contains("no finite answer: a resonance without damping"),
        "{text}"
    );
}

#[test]
fn it_fits_any_size_and_set_of_characters() {
    stage::draws_at_any_size(draw, BeamView::Deflection);
}
