//! `beamtune measured`. Expected: the closed form of the files in `tests/data/measured/tables`, see its README.

use super::*;

fn file(name: &str) -> String {
    format!("tests/data/measured/tables/{name}")
}

/// H = 1/(160e3 - 4 w^2 + 40 i w), m/N.
fn exact(frequency: f64) -> [f64; 2] {
    let w = std::f64::consts::TAU * frequency;
    let (re, im) = (160e3 - 4.0 * w * w, 40.0 * w);
    let square = re.mul_add(re, im * im);
    [re / square, -im / square]
}

#[test]
fn what_is_read_is_a_row_a_curve_with_notes() {
    let header = "curve,values,quantity,unit,points,from_hz,to_hz,notes\n";
    assert_eq!(
        output(&["measured", &file("status.csv")]),
        format!(
            "{header}status,complex,receptance,m/N,39,10.0,200.0,column 4 skipped: it has no numbers\n"
        )
    );
    assert_eq!(
        output(&["measured", "tests/data/measured/example.csv"]),
        format!("{header}P1 w,complex,displacement,m,799,1.0,400.0,\n")
    );
    let two = output(&[
        "measured",
        &file("analyze.dat"),
        "--columns",
        "hz; mag 6 2; rad 7 3; g",
    ]);
    let expected =
        "Z,complex,acceleration,m/s2,39,10.0,200.0,\nU,complex,acceleration,m/s2,39,10.0,200.0,\n";
    assert_eq!(two, format!("{header}{expected}"));
}

#[test]
fn curves_are_written_in_si_as_frf_writes_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("si.csv");
    let path = path.to_str().unwrap();
    for (name, columns, curve, tolerance) in [
        ("betrag.csv", None, "betrag", 1e-5),
        ("analyze.dat", Some("hz 1; re 8; im 9; m/N"), "Z", 1e-5),
        ("pandas.csv", Some("hz; re im; m/N"), "H", 1e-9),
    ] {
        let file = file(name);
        let mut arguments = vec!["measured", &file, "-o", path];
        arguments.extend(columns.iter().flat_map(|columns| ["--columns", columns]));
        let shown = output(&arguments);
        assert!(shown.contains(",39,10.0,200.0,"), "{shown}");
        let written = std::fs::read_to_string(path).unwrap();
        let rows = rows(&written);
        assert_eq!(
            rows[0].join(","),
            format!("frequency_hz,{curve}.re,{curve}.im")
        );
        assert_eq!(rows.len(), 40);
        for row in &rows[1..] {
            let [frequency, re, im] =
                [row[0], row[1], row[2]].map(|cell| cell.parse::<f64>().unwrap());
            let [a, b] = exact(frequency);
            assert!(
                (re - a).hypot(im - b) < tolerance * a.hypot(b),
                "{name} {row:?}"
            );
        }
        // The kind of table is recognised: no question is necessary.
        let again = output(&["measured", path]);
        assert!(
            again.contains(&format!("\n{curve},complex,,,39,10.0,200.0,")),
            "{again}"
        );
    }
}

/// A cell is empty where a curve has no value: a magnitude has one column, and the bool says how many points.
#[test]
fn curves_at_different_frequencies_share_a_table() {
    let folder = tempfile::tempdir().unwrap();
    let (input, path) = (folder.path().join("in.csv"), folder.path().join("out.csv"));
    let table = "f [Hz],a [dB re 1 m],b re [mm],b im [mm]\n30,,5,6\n10,20,1,2\n20,40,,\n";
    std::fs::write(&input, table).unwrap();
    output(&[
        "measured",
        input.to_str().unwrap(),
        "-o",
        path.to_str().unwrap(),
    ]);
    let expected =
        "frequency_hz,a,b.re,b.im\n10.0,10.0,0.001,0.002\n20.0,100.0,,\n30.0,,0.005,0.006\n";
    assert_eq!(std::fs::read_to_string(&path).unwrap(), expected);
    let again = output(&["measured", path.to_str().unwrap()]);
    assert!(
        again.contains("\na,magnitude,,,2,10.0,20.0,")
            && again.contains("\nb,complex,,,2,10.0,30.0,"),
        "{again}"
    );
}

#[test]
fn what_has_to_be_asked_exits_2_with_the_question_and_a_preview() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("none.csv");
    let (code, said) = failure(&[
        "measured",
        &file("two_words.txt"),
        "-o",
        path.to_str().unwrap(),
    ]);
    assert_eq!(code, 2);
    for part in [
        "It does not say in which unit its frequencies are: hz, khz, rad/s or rpm",
        "nor what its values are",
        "1: Excitation frequency | 2: Real | 3: Imag",
        "10.0000 | 6.932292021e-06 | -1.208162770e-07",
        "--columns \"hz; re im; ?\"",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert!(!path.exists());
    let cases = [
        (
            vec!["status.csv", "--columns", "hz; re"],
            "accepted is re im, mag deg",
        ),
        (
            vec!["points.txt", "--columns", "hz 2; re 3; im 9; m/N"],
            "column 9 is not there: the table has 4 columns",
        ),
        (vec!["nothing.csv"], "cannot be read"),
    ];
    for (mut arguments, part) in cases {
        let path = file(arguments[0]);
        arguments[0] = &path;
        let (code, said) = failure(&[&["measured"], &arguments[..]].concat());
        assert_eq!(code, 2, "{said}");
        assert!(said.contains(part), "{said}");
    }
}

#[test]
fn standard_input_and_universal_files_are_read() {
    let text = std::fs::read(file("minus_im.csv")).unwrap();
    let assert = beamtune(&["measured", "-"])
        .write_stdin(text)
        .assert()
        .success();
    let shown = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert!(
        shown.contains("standard input,complex,receptance,m/N,39,"),
        "{shown}"
    );
    let shown = output(&["measured", "tests/data/measured/complex_double_even.uff"]);
    assert!(
        shown.contains(",complex,receptance,m/N,7,1.0,4.0,"),
        "{shown}"
    );
}
