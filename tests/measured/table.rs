//! Tables.

use std::fmt::Write as _;

use super::*;

/// H of [`ROWS`], m/s2/N.
const VALUES: [Complex64; 3] = [
    Complex64::new(1.5, -0.25),
    Complex64::new(-2e-3, 4.0),
    Complex64::new(0.0, -7.125),
];

/// Magnitude and phase (rad) as in a file.
type Cells = fn(f64, f64) -> (f64, f64);

fn accelerance() -> Kind {
    motion(Moves::Length, Measure::Acceleration, Some(Load::Force))
}

#[track_caller]
fn is_the_curve(curve: &Curve) {
    assert_eq!(curve.frequencies, [10.0, 20.0, 40.5]);
    for (found, expected) in curve.values.iter().zip(VALUES) {
        near(*found, expected, 1e-12);
    }
    assert!(curve.phase_known);
}

#[test]
fn separators_headers_and_comments_of_all_kinds_are_understood() {
    let tables = [
        "Frequency [Hz],Re [m/s2/N],Im [m/s2/N]\n10,1.5,-0.25\n20,-2e-3,4\n40.5,0,-7.125\n",
        "Frequency [Hz];Re [m/s2/N];Im [m/s2/N]\r\n10;1,5;-0,25\r\n20;-2e-3;4\r\n40,5;0;-7,125\r\n",
        "f (Hz)\treal(H) (m/s^2/N)\timag(H) (m/s^2/N)\n10\t1.5\t-0.25\n20\t-2e-3\t4.\n40.5\t0\t-7.125",
        "% freq[Hz] Re[m/s2/N] Im[m/s2/N]\n  10  1.5   -0.25\n  20 -2D-3 4\n! between\n\n  40.5 0 -7.125\n",
        "# made by hand\n#\n# Frequency [Hz]   Re [m/(N s2)]   Im [m/(N s2)]\n10 1.5 -0.25\n20 -2e-3 4\n40.5 0 -7.125\n",
        "\u{feff}\"Frequency, Hz\",\"Real part [m/s2/N]\",\"Imaginary part [m/s2/N]\"\n\"10\",1.5,-0.25\n20,-2e-3,4\n\
         40.5,0,-7.125\n",
        "Test,7\nDate,none\n\nFrequency,Real,Imag\nHz,m/s2/N,m/s2/N\n10,1.5,-0.25\n20,-2e-3,4\n40.5,0,-7.125\n",
        "omega [rad/s],Re [m/s2/N],Im [m/s2/N]\n62.83185307179586,1.5,-0.25\n125.66370614359172,-2e-3,4\n\
         254.46900494077323,0,-7.125\n",
        "freq [kHz],Im [mm/s2/N],Re [mm/s2/N],Coherence\n0.01,-250,1500,1\n0.02,4000,-2,1\n0.0405,-7125,0,1\n",
        "rpm  re[m/s2/kN]  im[m/s2/kN]\n600 1500 -250\n1200 -2 4000\n2430 0 -7125\n",
    ];
    for table in tables {
        let found = curves(table, None);
        assert_eq!(found.len(), 1, "{table}");
        let mut curve = found[0].clone();
        for (frequency, expected) in curve.frequencies.iter_mut().zip([10.0, 20.0, 40.5]) {
            assert!(
                (*frequency / expected - 1.0).abs() < 1e-15,
                "{table}: {frequency}"
            );
            *frequency = expected;
        }
        is_the_curve(&curve);
        assert_eq!(curve.kind, Some(accelerance()), "{table}");
        let missing = inspect(table.as_bytes(), &hint("", None)).unwrap().missing;
        assert!(missing.is_empty(), "{table}: {missing:?}");
    }
}

#[test]
fn magnitudes_phases_and_decibels_become_complex_numbers() {
    let of = |value: Complex64, angle: f64| (value.norm(), value.arg() * angle);
    let decibels = |value: f64| 20.0 * value.log10();
    let kinds: [(&str, f64, Cells); 4] = [
        (
            "f [Hz],Magnitude [m/s2/N],Phase [deg]",
            1.0,
            |size, angle| (size, angle.to_degrees()),
        ),
        ("f [Hz],abs [m/s2/N],arg", 1.0, |size, angle| {
            (size, angle.to_degrees())
        }),
        (
            "f [Hz],Amplitude [m/s2/N],Phase [rad]",
            1.0,
            |size, angle| (size, angle),
        ),
        (
            "f [Hz],H [dB re 1e-6 m/s2/N],Phase (°)",
            1e6,
            |size, angle| (size, angle.to_degrees()),
        ),
    ];
    for (header, scale, cells) in kinds {
        let mut table = header.to_owned();
        for (frequency, value) in [10.0, 20.0, 40.5].into_iter().zip(VALUES) {
            let (size, angle) = of(value, 1.0);
            let (size, angle) = cells(size * scale, angle);
            let size = if header.contains("dB") {
                decibels(size)
            } else {
                size
            };
            write!(table, "\n{frequency},{size:?},{angle:?}").unwrap();
        }
        let found = curves(&table, None);
        is_the_curve(&found[0]);
        assert_eq!(found[0].kind, Some(accelerance()));
    }
}

#[test]
fn what_a_table_does_not_say_is_asked_and_answered() {
    let bare = "10 1.5 -0.25\n20 -2e-3 4\n40.5 0 -7.125\n";
    let seen = inspect(bare.as_bytes(), &hint("run 7.txt", None)).unwrap();
    assert_eq!(seen.format, Format::Csv);
    assert_eq!(seen.columns, ["column 1", "column 2", "column 3"]);
    assert_eq!(seen.first_rows[1], ["20", "-2e-3", "4"]);
    assert_eq!(
        seen.missing,
        [Question::Frequency, Question::Values, Question::Unit]
    );
    assert_eq!(seen.proposal.to_string(), "hz; re im; ?");
    assert_eq!(seen.curves, ["run 7"]);
    let refused = fault(bare);
    assert_eq!((refused.line, refused.column), (Some(1), Some(1)));
    assert!(refused.message.contains("re im"), "{refused}");
    let found = curves(bare, Some("hz; re im; m/s2/N"));
    is_the_curve(&found[0]);
    assert_eq!(
        (found[0].name.as_str(), found[0].kind),
        ("run 7", Some(accelerance()))
    );
    let answered = inspect(bare.as_bytes(), &hint("", Some("hz; re im; m/s2/N"))).unwrap();
    assert!(answered.missing.is_empty());

    // Only the unit is missing: the values are unchanged.
    let half = "Frequency [Hz],Re,Im\n10,1.5,-0.25\n20,-2e-3,4\n40.5,0,-7.125\n";
    assert_eq!(
        inspect(half.as_bytes(), &hint("", None)).unwrap().missing,
        [Question::Unit]
    );
    let found = curves(half, None);
    is_the_curve(&found[0]);
    assert_eq!(found[0].kind, None);
    let found = curves(half, Some("khz; re im; g/N"));
    assert_eq!(found[0].frequencies, [10e3, 20e3, 40.5e3]);
    near(found[0].values[0], VALUES[0] * 9.80665, 1e-15);

    // Closed form: 40 dB at 90 degrees is 100 i; the inverse of 100 i kN/mm is -1e-8 i m/N.
    let polar = "5 40 90\n6 40 -90\n";
    let found = curves(polar, Some("rad/s; dB deg; kN/mm"));
    assert_eq!(
        found[0].kind,
        Some(motion(
            Moves::Length,
            Measure::Displacement,
            Some(Load::Force)
        ))
    );
    near(found[0].values[0], Complex64::new(0.0, -1e-8), 1e-12);
    assert!((found[0].frequencies[0] - 5.0 / std::f64::consts::TAU).abs() < 1e-15);
    // The decibels of an energy are 10 log10.
    let found = curves("5 40\n6 20\n", Some("hz; dB; kg m2"));
    assert_eq!(found[0].kind, Some(Kind::Energy));
    near(found[0].values[0], 1e4.into(), 1e-12);
}

#[test]
fn several_curves_are_distinguished() {
    let table = "frequency_hz,P1 w.re,P1 w.im,E_V,P2 w.re,P2 w.im\n1,1,2,3,4,5\n2,6,7,8,9,10\n";
    let found = curves(table, None);
    let names: Vec<&str> = found.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["P1 w", "E_V", "P2 w"]);
    assert_eq!(found[1].values, [3.0.into(), 8.0.into()]);
    assert_eq!(
        found
            .iter()
            .map(|curve| curve.phase_known)
            .collect::<Vec<_>>(),
        [true, false, true]
    );
    // An energy alone, and a study.
    let energy = curves("frequency_hz,E_V\n1,3\n2,8\n", None);
    assert_eq!(
        (energy[0].name.as_str(), energy[0].phase_known),
        ("E_V", false)
    );
    let study = "curve,frequency_hz,w.re,w.im\n0.5,1,1,2\n0.5,2,3,4\nsoft spring,1,5,6\nsoft spring,2,7,8\n";
    let found = curves(study, None);
    let names: Vec<&str> = found.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["w, 0.5", "w, soft spring"]);
    assert_eq!(found[1].values[1], Complex64::new(7.0, 8.0));
    // Without text there is a curve for each pair, and no name twice.
    let found = curves("1 1 2 3 4\n2 5 6 7 8\n", Some("hz; re im; m"));
    let names: Vec<&str> = found.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["run 7", "run 7 (2)"]);
    assert_eq!(
        found[1].values,
        [Complex64::new(3.0, 4.0), Complex64::new(7.0, 8.0)]
    );
}

#[test]
fn what_is_left_out_is_said() {
    let table = "f [Hz],Re [m],Im [m]\n0,1,0\n3,1,1\n2,nan,1\n1,1,1\n3,5,5\n4,,\n";
    let curve = &curves(table, None)[0];
    assert_eq!(curve.frequencies, [1.0, 3.0]);
    assert_eq!(
        curve.notes,
        [
            "1 point at 0 Hz or below skipped",
            "2 points without a finite number skipped",
            "frequencies sorted in ascending order",
            "1 point with a repeated frequency skipped"
        ]
    );
    let curve = &curves("frequency,Re [m],Im [m]\n1,1,0\n2,1,1\n", None)[0];
    assert_eq!(curve.notes, ["the frequency unit is not given: Hz assumed"]);
    let found = curves("f [Hz],Re [m],Im [m],Force [N]\n1,1,0,7\n2,1,1,8\n", None);
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].notes,
        ["column 4 skipped: its quantity is not given"]
    );
}

#[test]
fn what_is_wrong_with_a_table_has_its_place() {
    let cases: [(&[u8], usize, usize, &str); 15] = [
        (b"", 1, 1, "no row of two or more numbers"),
        (
            b"\n\n# only words\nfrequency,re\n",
            4,
            1,
            "no row of two or more numbers",
        ),
        (b"\xff\xfe1\0", 1, 1, "no row of two or more numbers"),
        (
            b"f [Hz],re,im\n1,2,3\n2,3,4\n\n# hm\n3,x,5\n",
            6,
            2,
            "\"x\" is not a number",
        ),
        (
            b"f [Hz],re,im\r\n1,2,3\r\n2,3,4\r\n3,4\r\n",
            4,
            2,
            "3 or more would be accepted",
        ),
        (
            b"f [Hz];re;im\n1;2;3\n2;3;4\n3;4.000,5;5\n",
            4,
            2,
            "is not a number",
        ),
        (
            b"f re im\n1 2 3\n2 3 4\nend\n3 4 5\n",
            4,
            1,
            "is not a number",
        ),
        (
            b"f [Hz],re,im\r1,2,3\r2,3,4\r3,x,5\r",
            4,
            2,
            "\"x\" is not a number",
        ),
        (
            b"Re [m/N],Im [m/N]\n1,2\n2,3\n",
            1,
            1,
            "no column of frequencies",
        ),
        (
            b"f [Hz],Re [m/N],Im [mm/N]\n1,2,3\n2,3,4\n",
            1,
            1,
            "column 2 (Re [m/N]) is in m/N and column 3 (Im [mm/N]) in mm/N",
        ),
        (b"f [Hz],re,im\n0,2,3\n-2,3,4\n", 2, 1, "frequency above 0"),
        (b"f [Hz],re,im\n1,nan,3\n2,,4\n", 2, 1, "finite value"),
        (b"1,2,3,4\n5,6,7,8\n", 1, 1, "what its columns are"),
        (b"f,H1,H2\n1,2,3\n5,6,7\n", 2, 1, "what its columns are"),
        (
            b"f [Hz],re,re\n1,2,3\n5,6,7\n",
            2,
            1,
            "what its columns are",
        ),
    ];
    for (bytes, line, column, message) in cases {
        let found = fault(bytes);
        let text = String::from_utf8_lossy(bytes).into_owned();
        assert_eq!(
            (found.line, found.column),
            (Some(line), Some(column)),
            "{text}: {found}"
        );
        assert!(found.message.contains(message), "{text}: {found}");
    }
    let odd = read(b"1 2 3 4\n5 6 7 8\n", &hint("", Some("hz; re im"))).unwrap_err();
    assert!(odd.message.contains("3 columns"), "{odd}");
    let wide = "1,".repeat(1001) + "1\n";
    assert!(fault(wide).message.contains("up to 1000"));
}

#[test]
fn a_header_may_be_corrected() {
    // The text gives magnitude and phase without units.
    let table = "frequency_hz,mag,phase\n1,2,3.125\n2,2,0\n";
    let degrees = curves(table, None);
    near(
        degrees[0].values[0],
        Complex64::from_polar(2.0, 3.125_f64.to_radians()),
        1e-15,
    );
    let radians = curves(table, Some("hz; mag rad; m"));
    near(
        radians[0].values[0],
        Complex64::from_polar(2.0, 3.125),
        1e-15,
    );
    // The text is wrong altogether.
    let turned = curves(table, Some("hz; re im; m"));
    assert_eq!(turned[0].values[0], Complex64::new(2.0, 3.125));
    let seen = inspect(table.as_bytes(), &hint("", None)).unwrap();
    assert_eq!(
        seen.proposal.values,
        Values::MagnitudePhase {
            phase: beamtune::unit::PhaseUnit::Degree,
            decibels: false
        }
    );
}

/// Control characters do not get through.
#[test]
fn names_are_of_visible_letters() {
    let table = b"f [Hz],\x1b[2JGr\xf6\xdfe\x07.re,\x1b[2JGr\xf6\xdfe\x07.im\n1,2,3\n2,3,4\n";
    assert_eq!(curves(table, None)[0].name, "[2JGröße");
    let found = fault(b"f [Hz],re,im\n1,2,3\n2,3,4\n3,\x1b[2J,4\n");
    assert!(
        found.message.starts_with("\" [2J\" is not a number"),
        "{found}"
    );
}

#[test]
fn a_quote_in_a_comment_swallows_nothing() {
    let table = "# it's 5\" wide, \"so\nf [Hz],re [m],im [m]\n1,2,3\n# \"again\n2,3,4\n";
    assert_eq!(curves(table, None)[0].frequencies, [1.0, 2.0]);
}
