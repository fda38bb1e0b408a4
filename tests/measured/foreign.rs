//! Tables as other programs write them: `tests/data/measured/tables`.
//!
//! Expected: the closed form of one mass on a spring, H = 1/(160e3 - 4 w^2 + 40 i w) m/N, at 10, 15 .. 200 Hz; to the
//! digits of the files, which are at least five.

use super::*;

fn exact(frequency: f64) -> Complex64 {
    let w = std::f64::consts::TAU * frequency;
    Complex64::new(160e3 - 4.0 * w * w, 40.0 * w).inv()
}

fn receptance() -> Kind {
    motion(Moves::Length, Measure::Displacement, Some(Load::Force))
}

fn file(name: &str) -> Vec<u8> {
    data(&format!("tables/{name}"))
}

fn table(name: &str, layout: Option<&str>) -> Vec<Curve> {
    read(&file(name), &hint(name, layout)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn missing(name: &str) -> Vec<Question> {
    let seen =
        inspect(&file(name), &hint(name, None)).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    seen.missing
}

/// Checks that a curve is the exact one, within a tolerance relative to each value's magnitude.
#[track_caller]
fn is_exact(curve: &Curve, tolerance: f64) {
    let frequencies: Vec<f64> = (2..=40).map(|index| 5.0 * f64::from(index)).collect();
    assert_eq!(curve.frequencies, frequencies, "{}", curve.name);
    for (frequency, value) in frequencies.iter().zip(&curve.values) {
        near(*value, exact(*frequency), tolerance);
    }
    assert!(curve.phase_known);
}

#[track_caller]
fn is_read_without_a_question(name: &str, called: &str, tolerance: f64) -> Curve {
    assert_eq!(missing(name), [], "{name}");
    let mut found = table(name, None);
    assert_eq!(found.len(), 1, "{name}");
    is_exact(&found[0], tolerance);
    assert_eq!(found[0].kind, Some(receptance()), "{name}");
    assert_eq!(found[0].name, called, "{name}");
    found.remove(0)
}

#[test]
fn headers_of_all_kinds_are_read_without_a_question() {
    for (name, called, tolerance) in [
        ("tab.txt", "H", 1e-5),
        ("comma.txt", "H", 1e-5),
        ("blank.txt", "H", 1e-5),
        ("utf16_bom.txt", "utf16_bom", 1e-5),
        ("utf16.txt", "utf16", 1e-5),
        ("hxy.txt", "hxy", 1e-5),
        ("tool.frf", "tool", 1e-10),
        ("units_apart.txt", "units_apart", 1e-5),
        ("phi.csv", "x", 1e-8),
        ("betrag.csv", "betrag", 1e-5),
        ("frequence.csv", "frequence", 1e-6),
        ("points.txt", "points", 1e-9),
    ] {
        let curve = is_read_without_a_question(name, called, tolerance);
        assert_eq!(curve.notes, [""; 0], "{name}");
    }
}

#[test]
fn what_is_left_out_of_a_table_is_said() {
    for (name, called, tolerance, note) in [
        (
            "status.csv",
            "status",
            1e-5,
            "column 4 skipped: it has no numbers",
        ),
        (
            "footer.txt",
            "H",
            1e-5,
            "2 lines after the numbers skipped, from \"saved 2024-05-05 10:10\" on",
        ),
        (
            "minus_im.csv",
            "minus_im",
            1e-5,
            "column 3 (-Im [m/N]) is taken with the opposite sign",
        ),
    ] {
        let curve = is_read_without_a_question(name, called, tolerance);
        assert_eq!(curve.notes, [note], "{name}");
    }
}

/// A header that is longer than the table has columns is matched, not cut.
#[test]
fn words_of_a_header_belong_to_the_columns_by_their_meaning() {
    for (name, layout, tolerance) in [
        ("two_words.txt", "hz; re im; m/N", 1e-9),
        ("double_slash.txt", "hz; re im; m/N", 1e-5),
    ] {
        assert_eq!(
            missing(name),
            [Question::Frequency, Question::Unit],
            "{name}"
        );
        let found = table(name, Some(layout));
        assert_eq!(found.len(), 1, "{name}");
        is_exact(&found[0], tolerance);
        assert_eq!(found[0].kind, Some(receptance()));
    }
    // The levels are 200 dB higher, so that they are above 0.
    assert_eq!(missing("star.frd"), [Question::Unit]);
    let mut found = table("star.frd", Some("hz; dB deg; m/N"));
    for value in &mut found[0].values {
        *value *= 1e-10;
    }
    is_exact(&found[0], 1e-4);
    assert_eq!(found[0].name, "SPL");
}

#[test]
fn columns_are_chosen_by_number() {
    for layout in [
        "hz 1; re 8; im 9; m/N",
        "hz; im 9; re 8; m/N",
        "hz 1; mag 6; deg 7; m/N",
    ] {
        let found = table("analyze.dat", Some(layout));
        assert_eq!((found.len(), found[0].name.as_str()), (1, "Z"), "{layout}");
        is_exact(&found[0], 1e-5);
        assert_eq!(found[0].kind, Some(receptance()));
    }
    let twice = table("analyze.dat", Some("hz; mag 6 2; deg 7 3; m/N"));
    assert_eq!((twice.len(), twice[1].name.as_str()), (2, "U"));
    assert_eq!(twice[1].values[5], Complex64::ONE);
    let found = table("points.txt", Some("hz 2; re 3; im 4; m/N"));
    is_exact(&found[0], 1e-9);
    // Without a header, too.
    let bare = "1 10 2 -3 OK\n2 20 4 -5 OK\n";
    let found = curves(bare, Some("hz 2; re 3; -im 4; m/N"));
    assert_eq!(found[0].frequencies, [10.0, 20.0]);
    assert_eq!(found[0].values[1], Complex64::new(4.0, 5.0));
    for (layout, message) in [
        (
            "hz 2; re 3; im 6; m/N",
            "column 6 is not there: the table has 5 columns",
        ),
        ("hz 9; re 3; im 4; m/N", "column 9 is not there"),
        ("hz 2; re 3; im 5; m/N", "column 5 has no numbers"),
        ("hz 5; re 3; im 4; m/N", "column 5 has no real numbers"),
        ("hz 2; re 3; im 3; m/N", "column 3 has no complex numbers"),
        ("hz; re im; m/N", "as hz 1; re 2; im 3"),
    ] {
        let fault = read(bare.as_bytes(), &hint("run 7.csv", Some(layout))).unwrap_err();
        assert!(fault.message.contains(message), "{layout}: {fault}");
    }
}

#[test]
fn complex_numbers_in_one_cell_are_one_curve() {
    for name in ["matlab.csv", "pandas.csv"] {
        let frequency = if name == "matlab.csv" {
            Some(Question::Frequency)
        } else {
            None
        };
        let expected: Vec<Question> = frequency.into_iter().chain([Question::Unit]).collect();
        assert_eq!(missing(name), expected, "{name}");
        let found = table(name, Some("hz; re im; m/N"));
        assert_eq!((found.len(), found[0].name.as_str()), (1, "H"), "{name}");
        is_exact(&found[0], 1e-9);
        assert_eq!(found[0].kind, Some(receptance()));
    }
    is_exact(&table("pandas.csv", Some("hz 2; re 3; im 3; m/N"))[0], 1e-9);
    // Closed form: what the cells say.
    let values = [Complex64::new(1.5, -0.25), Complex64::new(-2e-3, 4.0)];
    for table in [
        "f [Hz],H [m/N]\n10,1.5 - 0.25i\n20,-2e-3+4i\n",
        "f [Hz];H [m/N]\n10,0;1,5-0,25i\n20,0;-2e-3+4i\n",
        "f [Hz] H [m/N]\n10 1.5 - 0.25i\n20 -2e-3 + 4i\n",
        "f [Hz] H [m/N]\n10 1.5 -0.25i\n20 -2e-3 +4i\n",
        "f [Hz]  H [m/N]\n10  (1.5, -0.25)\n20  (-2e-3,4)\n",
        "f [Hz]\tH [m/N]\n10\t1.5-i*0.25\n20\t-2e-3+i4\n",
        "# f [Hz] H [m/N]\n10 (1.5-0.25j)\n",
        "# f [Hz] H [m/N]\n (1.0e+01+0.0e+00j) (1.5e+00+-2.5e-01j)\n (2.0e+01+0.0e+00j) (-2.0e-03+4.0e+00j)\n",
        "f [Hz];H [m/N]\n10;1.5 - 0.25im\n20;-2e-3 + 4.0im\n",
    ] {
        let found = curves(table, None);
        for (found, expected) in found[0].values.iter().zip(values) {
            assert_eq!(*found, expected, "{table}");
        }
        assert_eq!(
            (found.len(), found[0].kind),
            (1, Some(receptance())),
            "{table}"
        );
    }
    // If the frequency column is ambiguous, the program asks.
    let bare = "0,10,1+2i\n1,20,3+4i\n";
    let seen = inspect(bare.as_bytes(), &hint("", None)).unwrap();
    assert!(seen.missing.contains(&Question::Values), "{seen:?}");
    let found = curves(bare, Some("hz 2; re im; ?"));
    assert_eq!(found[0].frequencies, [10.0, 20.0]);
}

/// Three points of [`exact`] in cells as a test writes them.
fn rows(cells: impl Fn(f64, Complex64) -> String) -> String {
    let points = [10.0, 15.0, 20.0].map(|frequency| cells(frequency, exact(frequency)));
    points.concat()
}

#[track_caller]
fn are_three(text: impl AsRef<[u8]>, called: &str) -> Curve {
    let text = text.as_ref();
    let shown = String::from_utf8_lossy(text);
    let seen = inspect(text, &hint("folder/run 7.csv", None)).unwrap();
    assert_eq!(seen.missing, [], "{shown}\n{seen:?}");
    let mut found = curves(text, None);
    assert_eq!(found.len(), 1, "{shown}\n{found:?}");
    let curve = found.remove(0);
    assert_eq!(curve.frequencies, [10.0, 15.0, 20.0], "{shown}");
    for (frequency, value) in curve.frequencies.iter().zip(&curve.values) {
        near(*value, exact(*frequency), 1e-12);
    }
    assert_eq!(
        (curve.name.as_str(), curve.kind),
        (called, Some(receptance())),
        "{shown}"
    );
    curve
}

#[test]
fn headers_in_other_languages_and_orders_are_known() {
    let parts = rows(|f, h| format!("{f};{:e};{:e}\n", h.re, h.im));
    for (header, called) in [
        ("Frequenz [Hz];Realteil [m/N];Imaginärteil [m/N]", "run 7"),
        (
            "Frequenz in Hz;Realteil in m/N;Imaginaerteil in m/N",
            "run 7",
        ),
        ("f / Hz;H Real / (m/N);H Imag / (m/N)", "H"),
        ("Anregungsfrequenz (Hz);Re{H11} (m/N);Im{H11} (m/N)", "H11"),
        (
            "Fréquence (Hz);Partie réelle (m/N);Partie imaginaire (m/N)",
            "run 7",
        ),
        (
            "Frecuencia (Hz);Parte real (m/N);Parte imaginaria (m/N)",
            "run 7",
        ),
        (
            "excitation frequency (Hz);Real part of H (m/N);Imaginary part of H (m/N)",
            "H",
        ),
        ("Freq.;Real;Imag.\nHz;m/N;m/N", "run 7"),
        ("Freq.;Real;Imag.\n\n[Hz];[(m)/(N)];", "run 7"),
    ] {
        are_three(format!("{header}\n{parts}"), called);
        are_three(format!("{header}\n{parts}").replace('\n', "\r\n"), called);
        are_three(format!("{header}\n{parts}").replace('\n', "\r"), called);
        let utf16: Vec<u8> = format!("{header}\n{parts}")
            .encode_utf16()
            .flat_map(u16::to_be_bytes)
            .collect();
        are_three(utf16, called);
    }
    let polar = rows(|f, h| format!("{f}\t{:e}\t{:e}\n", h.norm() * 1e6, h.arg().to_degrees()));
    for header in [
        "Frequenz [Hz]\tBetrag [µm/N]\tPhase [Grad]",
        "Frequenz [Hz]\tBetrag [µm/N]\tPhi [°]",
        "Fréquence [Hz]\tModule [µm/N]\tArgument [degrés]",
        "f [Hz]\tH [um/N]\tPhase [deg]",
        "f [Hz]\t|H| [um/N]\targ H [deg]",
    ] {
        let called = if header.contains("\tH") || header.contains("|H|") {
            "H"
        } else {
            "run 7"
        };
        are_three(format!("{header}\n{polar}"), called);
        let windows: Vec<u8> = format!("{header}\n{polar}")
            .chars()
            .map(|letter| u8::try_from(u32::from(letter)).unwrap())
            .collect();
        are_three(windows, called);
    }
}

#[test]
fn header_words_find_their_columns_among_blanks() {
    let parts = rows(|f, h| format!("{f:10.4} {:22.14e} {:22.14e}\n", h.re, h.im));
    for (header, called) in [
        ("Excitation frequency [Hz] Real [m/N] Imag [m/N]", "run 7"),
        (
            "Frequency (Hz) Real part (m/N) Imaginary part (m/N)",
            "run 7",
        ),
        ("Freq of test Hz Re of H (m/N) Im of H (m/N)", "H"),
        ("Freq Hz Real m/N Imag m/N", "run 7"),
        ("* Freq(Hz) Re(m/N) Im(m/N)", "run 7"),
        ("// f in Hz   Re H in m/N   Im H in m/N", "H"),
        (
            "      f Hz          H of tip (re) [m/N]    H of tip (im) [m/N]",
            "H of tip",
        ),
        ("# f,re,im\n# Hz,m/N,m/N", "run 7"),
        (
            "some words of the program\n\nFrequency Real Imag\n     (Hz) (m/N) (m/N)\n---- ---- ----",
            "run 7",
        ),
    ] {
        are_three(format!("{header}\n{parts}"), called);
    }
    // If no reading fits, the program asks, and reports what it found.
    let odd = format!("Frequency step Real Imag Phase\n{parts}");
    let seen = inspect(odd.as_bytes(), &hint("run 7.txt", None)).unwrap();
    assert!(seen.missing.contains(&Question::Values), "{seen:?}");
    assert!(
        seen.recognised
            .iter()
            .any(|one| one.starts_with("its header has 5 words for 3 columns")),
        "{seen:?}"
    );
    assert_eq!(seen.proposal.to_string(), "hz; re im; ?");
    assert!(
        seen.preview()[1].starts_with("10.0000 | 6.93"),
        "{:?}",
        seen.preview()
    );
    let found = curves(odd, Some("hz; re im; m/N"));
    near(found[0].values[0], exact(10.0), 1e-12);
    assert_eq!(found[0].name, "run 7");
}

/// Some programs write the text after the first row of numbers.
#[test]
fn a_header_behind_the_first_row_is_found() {
    let parts = rows(|f, h| format!("{f}\t{:e}\t{:e}\n", h.re, h.im));
    for words in [
        "Freq\tHz\tReal\tm/N\tImag\tReal\t",
        "Freq [Hz]\tReal [m/N]\tImag [m/N]",
        "# Freq Hz Real m/N Imag",
    ] {
        let text = parts.replacen('\n', &format!("\t{words}\n"), 1);
        assert_eq!(are_three(&text, "run 7").notes, [""; 0]);
        are_three(text.replace('\t', "  "), "run 7");
    }
}

#[test]
fn a_minus_of_the_header_is_undone() {
    let parts = rows(|f, h| format!("{f},{:e},{:e}\n", h.re, -h.im));
    for header in [
        "Frequency [Hz],Re [m/N],-Im [m/N]",
        "Frequency [Hz],Real (m/N),-Imag (m/N)",
        "Frequency [Hz],H real (m/N),H -imaginary (m/N)",
        "Frequency [Hz],Re(H) [m/N],-Im(H) [m/N]",
        "Frequency [Hz],H.re [m/N],-H.im [m/N]",
        "Frequency [Hz],Re [m/N],\u{2212} Im [m/N]",
        "Frequency [Hz],Re [m/N],minus Imag [m/N]",
    ] {
        let called = if header.contains('H') && header.matches('H').count() > 2 {
            "H"
        } else {
            "run 7"
        };
        let curve = are_three(format!("{header}\n{parts}"), called);
        assert!(
            curve.notes[0].ends_with("is taken with the opposite sign"),
            "{:?}",
            curve.notes
        );
    }
    let polar = rows(|f, h| format!("{f},{:e},{:e}\n", h.norm(), -h.arg().to_degrees()));
    for header in [
        "f [Hz],Mag [m/N],-Phase [deg]",
        "f [Hz],Abs(x) [m/N],-Phi(x) [deg]",
    ] {
        let called = if header.contains('x') { "x" } else { "run 7" };
        are_three(format!("{header}\n{polar}"), called);
    }
    // A dash between words is not a minus sign.
    let plain = rows(|f, h| format!("{f},{:e},{:e}\n", h.re, h.im));
    for header in [
        "f [Hz],H-Re [m/N],H-Im [m/N]",
        "f [Hz],H - Re [m/N],H - Im [m/N]",
    ] {
        assert_eq!(are_three(format!("{header}\n{plain}"), "H").notes, [""; 0]);
    }
    // One statement by the user is enough.
    let bare = curves(&parts, Some("hz; re -im; m/N"));
    near(bare[0].values[0], exact(10.0), 1e-12);
    let said = curves(format!("f [Hz],Re,-Im\n{parts}"), Some("hz; re -im; m/N"));
    near(said[0].values[0], exact(10.0), 1e-12);
}

#[test]
fn what_stands_behind_the_numbers_is_left_out_with_a_note() {
    let header = "f [Hz] Re [m/N] Im [m/N]\n";
    let parts = rows(|f, h| format!("{f} {:e} {:e}\n", h.re, h.im));
    for (behind, note) in [
        (
            "\n\nsaved 2024-05-05\npeak 31.8 Hz\n",
            "2 lines after the numbers skipped, from \"saved 2024-05-05\" on",
        ),
        ("end", "1 line after the numbers skipped, from \"end\" on"),
        (
            "3 points read\n",
            "1 line after the numbers skipped, from \"3 points read\" on",
        ),
        (
            "25 1.6e-5 -1.6e-",
            "the file is truncated in its last row, which is skipped",
        ),
        (
            "25 1.6e-5",
            "the file is truncated in its last row, which is skipped",
        ),
    ] {
        let curve = are_three(format!("{header}{parts}{behind}"), "run 7");
        assert_eq!(curve.notes, [note], "{behind}");
    }
    let words = parts.replacen('\n', " start\n", 1);
    let curve = are_three(format!("{header}{words}"), "run 7");
    assert_eq!(
        curve.notes,
        ["extra cells after the columns in 1 row skipped"]
    );
}

/// If a phase has no unit the program asks, except if its size shows that it is in degrees.
#[test]
fn the_unit_of_phases_is_not_guessed() {
    let question = |text: &str| {
        inspect(text.as_bytes(), &hint("run 7.csv", None))
            .unwrap()
            .missing
    };
    let header = "f [Hz],Mag [m/N],Phase\n";
    let radians = format!("{header}1,2,-0.5\n2,2,-3.1\n");
    assert_eq!(question(&radians), [Question::Phase]);
    assert_eq!(question(&format!("{header}1,2,-0.5\n2,2,-179\n")), []);
    let found = curves(&radians, Some("hz; mag rad; m/N"));
    near(found[0].values[1], Complex64::from_polar(2.0, -3.1), 1e-15);
    // An angle over a load is a response, not a phase.
    let found = curves(
        "f [Hz],phi re [rad/(N m)],phi im [rad/(N m)]\n1,2,3\n2,3,4\n",
        None,
    );
    assert_eq!(found[0].name, "phi");
    assert_eq!(
        found[0].kind,
        Some(motion(
            Moves::Angle,
            Measure::Displacement,
            Some(Load::Moment)
        ))
    );
}

#[test]
fn an_answer_wins_over_the_header() {
    // A column that does not fit it is ignored if its unit is unknown.
    let table = "f [Hz],U mag,U phase [deg],H re,H im\n1,1,0,2,3\n2,1,0,4,5\n";
    let found = curves(table, Some("hz; re im; m/N"));
    assert_eq!((found.len(), found[0].name.as_str()), (1, "H"));
    assert_eq!(found[0].values[1], Complex64::new(4.0, 5.0));
    assert_eq!(
        found[0].notes,
        ["column 2 (U mag) and column 3 (U phase [deg]) skipped: mag deg, which was not requested"]
    );
    // A single magnitude has the quantity of the header, and has no phase.
    let table = "f [Hz],Mag [m/N],Phase [deg]\n1,2,-90\n2,3,-170\n";
    let found = curves(table, Some("hz; mag; mm/N"));
    assert_eq!((found.len(), found[0].phase_known), (1, false));
    assert_eq!(
        found[0].notes,
        ["column 3 skipped: only magnitudes were requested"]
    );
    near(found[0].values[0], 2e-3.into(), 1e-15);
    // Its unit takes precedence over the header's, also if there is none.
    let table = "f [Hz],H re [furlong],H im [furlong]\n1,2,3\n2,4,5\n";
    let seen = inspect(table.as_bytes(), &hint("run 7.csv", None)).unwrap();
    assert_eq!(seen.missing, [Question::Unit]);
    assert!(
        seen.recognised
            .contains(&"its unit \"furlong\" is unknown".to_owned()),
        "{seen:?}"
    );
    let found = curves(table, Some("khz; re im; mm/N"));
    assert_eq!(found[0].frequencies, [1e3, 2e3]);
    near(found[0].values[0], Complex64::new(2e-3, 3e-3), 1e-15);
}
