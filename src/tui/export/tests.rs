//! Tests of exported files.

use super::*;
use crate::tui::plot::{Level, LineStyle};
use crate::tui::scene::sample::{curve, frequencies, receptance, scene};
use crate::tui::scene::{ChartView, SceneCurve};
use crate::unit::FrequencyUnit;

fn provenance() -> Provenance {
    Provenance {
        program: "beamtune 0.1.0".to_owned(),
        model: "An oscillator & <its> \"mass\"".to_owned(),
        source: "oscillator.toml".to_owned(),
        hash: "0123456789abcdef".repeat(4),
        method: "closed form".to_owned(),
        notes: vec!["made by\nhand".to_owned()],
    }
}

/// A reference, a study of three, finite elements and a measurement.
fn full(view: ChartView) -> Scene {
    let mut scene = scene(view);
    scene.title = "w at the right end, receptance".to_owned();
    let scaled = |factor: f64, label: &str, kind| {
        let mut one = curve(view, kind, frequencies());
        let scales = |panel: usize| view != ChartView::MagnitudePhase || panel == 0;
        for (panel, values) in one.values.iter_mut().enumerate() {
            if scales(panel) {
                for value in values {
                    *value *= factor;
                }
            }
        }
        label.clone_into(&mut one.label);
        one
    };
    let mut curves = vec![SceneCurve {
        line: LineStyle::Dotted,
        dim: true,
        ..scaled(0.3, "before", CurveKind::Reference)
    }];
    for (number, factor) in [1.0, 1.7, 2.5].into_iter().enumerate() {
        curves.push(SceneCurve {
            colour: number,
            marker: Some(number),
            ..scaled(factor, &format!("k × {factor}"), CurveKind::Model)
        });
    }
    curves.push(SceneCurve {
        line: LineStyle::Points { apart: 3 },
        ..scaled(1.0, "FEM", CurveKind::Fem)
    });
    let mut measured = scaled(1.2, "measured", CurveKind::Measured);
    let keep = |index: usize| index % 37 == 5;
    let mut index = 0..;
    measured.frequencies.retain(|_| keep(index.next().unwrap()));
    for values in &mut measured.values {
        let mut index = 0..;
        values.retain(|_| keep(index.next().unwrap()));
    }
    measured.colour = 4;
    curves.push(measured);
    scene.curves = curves;
    scene.marks.second = Some(45.0);
    scene.marks.harmonics = vec![60.0, 90.0];
    scene.marks.band = Some([20.0, 40.0]);
    scene
}

/// Whether a text is well-formed XML, as far as these files go: one root, elements closed in their order, attributes in
/// quotes, no bare `&` or `<`.
fn check_form(xml: &str) -> Result<(), String> {
    let body = xml.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let mut rest = body.ok_or("no declaration")?.trim_end();
    let mut open: Vec<&str> = Vec::new();
    while let Some(start) = rest.find('<') {
        check_text(&rest[..start])?;
        if open.is_empty() && !rest[..start].trim().is_empty() {
            return Err("text outside of the root".to_owned());
        }
        let end = start + rest[start..].find('>').ok_or("an element without an end")?;
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name) {
                return Err(format!("</{name}> closes nothing"));
            }
            if open.is_empty() && !rest.is_empty() {
                return Err("more than one root".to_owned());
            }
            continue;
        }
        let (tag, closed) = match tag.strip_suffix('/') {
            Some(tag) => (tag, true),
            None => (tag, false),
        };
        let (name, attributes) = tag.split_once(' ').unwrap_or((tag, ""));
        if name.is_empty() || !name.chars().all(|letter| letter.is_ascii_alphanumeric()) {
            return Err(format!("an element named {name:?}"));
        }
        check_attributes(attributes)?;
        if !closed {
            open.push(name);
        }
    }
    if open.is_empty() {
        Ok(())
    } else {
        Err(format!("{open:?} are not closed"))
    }
}

fn check_text(text: &str) -> Result<(), String> {
    if text
        .chars()
        .any(|letter| letter.is_control() && letter != '\n')
    {
        return Err(format!("a control character in {text:?}"));
    }
    for (place, _) in text.match_indices('&') {
        let entity = ["&amp;", "&lt;", "&gt;", "&quot;"];
        if !entity
            .iter()
            .any(|entity| text[place..].starts_with(entity))
        {
            return Err(format!("a bare & in {text:?}"));
        }
    }
    Ok(())
}

fn check_attributes(attributes: &str) -> Result<(), String> {
    let mut rest = attributes.trim();
    let mut names = Vec::new();
    while !rest.is_empty() {
        let (name, after) = rest
            .split_once("=\"")
            .ok_or("an attribute without a value")?;
        let (value, after) = after.split_once('"').ok_or("a value without an end")?;
        check_text(value)?;
        if name.trim() != name || name.is_empty() || names.contains(&name) {
            return Err(format!("an attribute named {name:?}"));
        }
        names.push(name);
        rest = after.trim_start();
    }
    Ok(())
}

#[test]
fn the_check_of_form_finds_faults() {
    let head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    for (body, good) in [
        ("<a b=\"1\"><c/>t &amp; u</a>", true),
        ("<a><b></a></b>", false),
        ("<a>", false),
        ("<a/>", true),
        ("<a b=1/>", false),
        ("<a b=\"1\" b=\"2\"/>", false),
        ("<a>&</a>", false),
        ("<a></a><b></b>", false),
    ] {
        assert_eq!(check_form(&format!("{head}{body}")).is_ok(), good, "{body}");
    }
}

#[test]
fn drawings_are_well_formed_and_the_same_each_time() {
    for view in ChartView::ALL {
        for unit in FrequencyUnit::SHOWN {
            for log in [false, true] {
                let mut scene = full(view);
                (scene.frequency.unit, scene.frequency.log) = (unit, log);
                scene.curves[1].label = "a & b < c > \"d\" \u{7}\n".to_owned();
                scene.curves[2].values[0][40] = f64::NAN;
                let drawing = svg(&scene, &provenance());
                check_form(&drawing).unwrap();
                assert_eq!(drawing, svg(&scene, &provenance()));
                assert!(!drawing.contains("NaN") && !drawing.contains("inf"));
                assert!(drawing.contains("a &amp; b &lt; c &gt; &quot;d&quot; \\u{7} "));
            }
        }
    }
}

#[test]
fn a_drawing_has_provenance_and_axis_labels() {
    let drawing = svg(&full(ChartView::MagnitudePhase), &provenance());
    let hash = &provenance().hash;
    for words in [
        "beamtune 0.1.0, oscillator.toml",
        hash,
        "closed form",
        "zero to peak",
        "An oscillator &amp; &lt;its&gt;",
        "frequency, Hz",
        "|H|, m/N",
        "phase, deg",
        "band 20 Hz to 40 Hz",
        "before",
        "FEM",
    ] {
        assert!(drawing.contains(words), "{words}");
    }
    assert!(drawing.contains("<desc>") && drawing.contains("<title>"));
    // The frequency label is below the lower plot only.
    assert_eq!(drawing.matches("frequency, Hz").count(), 1);
}

#[test]
fn powers_of_ten_are_raised() {
    let mut scene = scene(ChartView::RealImaginary);
    scene.panels[0].bounds = Some([-1e-6, 1e-6]);
    scene.panels[1].bounds = Some([-4e-6, 4e-6]);
    let drawing = svg(&scene, &provenance());
    let raised =
        |digits: &str| format!(">{digits}<tspan dy=\"-5\" font-size=\"9\">\u{2212}6</tspan>");
    for digits in ["10", "\u{2212}10", "2\u{b7}10", "\u{2212}4\u{b7}10"] {
        assert!(drawing.contains(&raised(digits)), "{digits}");
    }
    assert!(!drawing.contains("e-6"));
}

#[test]
fn curves_differ_without_colour() {
    let drawing = svg(&full(ChartView::Magnitude), &provenance());
    let curves = drawing
        .lines()
        .filter(|line| line.contains("stroke-linejoin"));
    let paths: Vec<&str> = curves.filter(|line| line.starts_with("<path")).collect();
    let dashes = paths.iter().map(|path| {
        let dashes = path.split_once("stroke-dasharray=\"");
        dashes.map_or("", |(_, after)| after.split('"').next().unwrap())
    });
    let mut dashes: Vec<&str> = dashes.collect();
    // A reference and three of the model; finite elements and few measured points have no line.
    assert_eq!(dashes.len(), 4);
    dashes.sort_unstable();
    dashes.dedup();
    assert_eq!(dashes.len(), 4);
}

/// The points of the paths of a drawing's curves.
fn points(drawing: &str) -> Vec<[f64; 2]> {
    let paths = drawing
        .lines()
        .filter(|line| line.starts_with("<path") && line.contains("stroke-linejoin"));
    let data = paths.map(|line| line.split('"').nth(1).unwrap());
    data.flat_map(|data| data.split(['M', 'L']).skip(1))
        .map(|point| {
            let (x, y) = point.split_once(' ').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        })
        .collect()
}

#[test]
fn curves_are_at_their_values() {
    let mut scene = scene(ChartView::RealImaginary);
    scene.panels.truncate(1);
    scene.panels[0].bounds = Some([-12.0, 12.0]);
    let drawing = svg(&scene, &provenance());
    let points = points(&drawing);
    // The frame gives the position of the plot.
    let frame = drawing
        .lines()
        .find(|line| line.contains("class=\"frame\""))
        .unwrap();
    let size: Vec<f64> = frame
        .split('"')
        .skip(1)
        .step_by(2)
        .take(4)
        .map(|n| n.parse().unwrap())
        .collect();
    let [left, top, width, height] = size[..] else {
        panic!("{frame}")
    };
    assert!(points.len() > 900);
    for [x, y] in points {
        let hertz = 1.0 + (x - left) / width * 99.0;
        let value = 12.0 - (y - top) / height * 24.0;
        // Within half a pixel of the curve, sideways where it is steep.
        let step = 99.0 / width / 2.0;
        let around = [hertz - step, hertz, hertz + step].map(|f| receptance(f).re);
        let low = around.iter().copied().fold(f64::INFINITY, f64::min) - 12.0 / height;
        let high = around.iter().copied().fold(f64::NEG_INFINITY, f64::max) + 12.0 / height;
        assert!((low..=high).contains(&value), "{hertz} {value}");
    }
}

#[test]
fn nothing_is_drawn_beyond_the_plot() {
    let mut scene = scene(ChartView::Magnitude);
    scene.curves[0].values[0] = vec![1e300; 1000];
    scene.curves[0].values[0][500] = 1.0;
    scene.panels[0].bounds = Some([0.1, 10.0]);
    let points = points(&svg(&scene, &provenance()));
    assert!(!points.is_empty());
    assert!(
        points
            .iter()
            .all(|[x, y]| (0.0..800.0).contains(x) && (0.0..700.0).contains(y))
    );
}

#[test]
fn no_scene_breaks_a_drawing() {
    for view in ChartView::ALL {
        let full = full(view);
        let mut none = full.clone();
        none.curves.clear();
        let mut empty = full.clone();
        for curve in &mut empty.curves {
            curve.frequencies.clear();
        }
        let mut short = full.clone();
        for curve in &mut short.curves {
            curve.values.truncate(1);
        }
        let mut bare = full.clone();
        bare.panels.clear();
        let mut gap = full;
        for curve in &mut gap.curves {
            curve
                .values
                .iter_mut()
                .for_each(|values| values.fill(f64::NAN));
        }
        for scene in [none, empty, short, bare, gap] {
            check_form(&svg(&scene, &provenance())).unwrap();
            csv(&scene, &provenance());
        }
    }
}

#[test]
fn numbers_parse_back() {
    let mut scene = full(ChartView::MagnitudePhase);
    scene.frequency.unit = FrequencyUnit::RadianPerSecond;
    scene.curves[1].values[1][30] = f64::NAN;
    scene.curves[3].label = "a, \"b\"".to_owned();
    let text = csv(&scene, &provenance());
    let mut reader = ::csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let titles: Vec<String> = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    assert_eq!(
        titles,
        ["curve", "angular_frequency_rad_s", "magnitude", "phase_deg"]
    );
    let rows: Vec<::csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let curve = &scene.curves[1];
    let own: Vec<_> = rows.iter().filter(|row| &row[0] == "k × 1").collect();
    // 1 to 100 Hz of 0.1 to 100 Hz.
    assert_eq!(own.len(), 991);
    for (row, index) in own.iter().zip(9..) {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        assert_eq!(number(1), curve.frequencies[index] * std::f64::consts::TAU);
        assert_eq!(number(2).to_bits(), curve.values[0][index].to_bits());
        if index == 30 {
            assert_eq!(&row[3], "nan");
        } else {
            assert_eq!(number(3).to_bits(), curve.values[1][index].to_bits());
        }
    }
    assert!(rows.iter().any(|row| &row[0] == "a, \"b\""));
    let comments: Vec<&str> = text
        .lines()
        .take_while(|line| line.starts_with("# "))
        .collect();
    for words in [
        "beamtune 0.1.0",
        "sha256 of the model as TOML: 0123",
        "zero to peak",
        "made by hand",
        "magnitude: |H|, m/N",
        "angular_frequency_rad_s: rad/s",
        "method: closed form",
        "cursor 188.496 rad/s",
    ] {
        assert!(comments.iter().any(|line| line.contains(words)), "{words}");
    }
    assert!(
        !text
            .lines()
            .skip(comments.len())
            .any(|line| line.starts_with('#'))
    );
}

#[test]
fn decibels_are_written_as_displayed() {
    let mut scene = scene(ChartView::Magnitude);
    scene.panels[0].level = Level::Decibel {
        factor: 20.0,
        reference: 1e-6,
    };
    "dB re 1e-6 m/N".clone_into(&mut scene.panels[0].unit);
    scene.curves[0].frequencies = vec![10.0, 20.0, 30.0];
    scene.curves[0].values[0] = vec![1e-3, 0.0, 1e-6];
    let text = csv(&scene, &provenance());
    let rows: Vec<&str> = text
        .lines()
        .skip_while(|line| line.starts_with('#'))
        .collect();
    // Closed form: a thousand times the reference is 60 dB; 0 has no level.
    assert_eq!(rows[0], "curve,frequency_hz,level_db");
    assert_eq!(rows[2..], ["w,20.0,nan", "w,30.0,0.0"]);
    let level: f64 = rows[1].strip_prefix("w,10.0,").unwrap().parse().unwrap();
    assert!((level - 60.0).abs() < 1e-12);
}

#[test]
fn every_curve_has_a_name_of_its_own() {
    let mut scene = full(ChartView::Magnitude);
    for curve in &mut scene.curves {
        curve.label.clear();
    }
    scene.curves[0].label = "measured".to_owned();
    let title = "w at the right end, receptance";
    assert_eq!(
        names(&scene),
        [
            "measured",
            title,
            &format!("{title} (2)"),
            &format!("{title} (3)"),
            "finite elements",
            "measured (2)"
        ]
    );
}

#[test]
fn frequencies_have_six_digits() {
    let mut scene = scene(ChartView::Magnitude);
    for (hertz, text) in [
        (30.0, "30 Hz"),
        (0.123_456_78, "0.123457 Hz"),
        (1_234_567.0, "1234567 Hz"),
        (99.999_99, "100 Hz"),
    ] {
        assert_eq!(frequency(&scene, hertz), text);
    }
    scene.frequency.unit = FrequencyUnit::RevolutionPerMinute;
    assert_eq!(frequency(&scene, 25.0), "1500 rpm");
}

/// Expected: the limit is named with the other marks, and only on the axis from 1 to 100 Hz.
#[test]
fn the_limit_of_euler_and_bernoulli_is_named_in_both_files() {
    let mut scene = scene(ChartView::Magnitude);
    for (validity, is_named) in [(None, false), (Some(54.5), true), (Some(545.0), false)] {
        scene.marks.validity = validity;
        for text in [svg(&scene, &provenance()), csv(&scene, &provenance())] {
            let named = text.contains("Euler-Bernoulli limit 54.5 Hz");
            assert_eq!(named, is_named, "{validity:?}");
            assert_eq!(text.contains("Euler-Bernoulli"), is_named);
        }
    }
}

#[test]
fn a_drawing_is_as_it_was() {
    let mut scene = scene(ChartView::MagnitudePhase);
    let coarse = (1..=12).map(|k| 8.0 * f64::from(k)).collect();
    scene.curves = vec![curve(ChartView::MagnitudePhase, CurveKind::Model, coarse)];
    scene.curves[0].label = "w".to_owned();
    // Golden.
    insta::assert_snapshot!(svg(&scene, &provenance()));
}

#[test]
fn references_and_measured_curves_have_unique_styles() {
    let view = ChartView::Magnitude;
    let marked = |number: usize, label: &str, kind| SceneCurve {
        label: label.to_owned(),
        colour: number,
        marker: Some(number),
        ..curve(view, kind, frequencies())
    };
    let mut scene = scene(view);
    // Numbered as on the screen: a study of four, two references, one of them with a second curve without a name.
    scene.curves = vec![
        marked(1, "before", CurveKind::Reference),
        marked(2, "", CurveKind::Reference),
        marked(2, "before 2", CurveKind::Reference),
    ];
    scene
        .curves
        .extend((0..4).map(|i| marked(i, &format!("x {i}"), CurveKind::Model)));
    scene.curves.extend((0..4).map(|i| SceneCurve {
        marker: None,
        ..marked(1 + i, &format!("measured {i}"), CurveKind::Measured)
    }));
    let text = svg(&scene, &provenance());
    // Only the legend is before the frame: a line with its colour, then its marker.
    let mut signs: Vec<(&str, &str)> = Vec::new();
    for (at, _) in text.match_indices("class=\"name\"") {
        let before = &text[..at];
        let path = &before[before.rfind("<path").unwrap()..];
        let attribute = |name: &str| {
            let from = path.find(name).unwrap() + name.len();
            &path[from..from + path[from..].find('"').unwrap()]
        };
        let shape = attribute(" d=\"");
        signs.push((attribute("stroke=\""), &shape[shape.find('m').unwrap()..]));
    }
    assert_eq!(signs.len(), 2 + 4 + 4);
    let colours: Vec<_> = signs.iter().map(|(colour, _)| colour).collect();
    for (index, sign) in signs.iter().enumerate() {
        assert!(
            !signs[..index].contains(sign),
            "{sign:?} twice in {signs:?}"
        );
    }
    // Eight colours: the references have none of the study's.
    assert!(
        colours[..2].iter().all(|one| !colours[2..6].contains(one)),
        "{colours:?}"
    );
}
