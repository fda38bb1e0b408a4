use super::*;

/// The darkest and the lightest dark background in use (One Dark's is #282c34), and the lightest and the darkest
/// light one (Solarized's is #fdf6e3).
const DARK: [[u8; 3]; 2] = [[0x00, 0x00, 0x00], [0x28, 0x2c, 0x34]];
const LIGHT: [[u8; 3]; 2] = [[0xff, 0xff, 0xff], [0xfd, 0xf6, 0xe3]];

/// Colours seen with all cones, and without the long, the middle or the short ones: maps linear RGB to linear RGB
/// (Machado et al. 2009, table 1, severity 1).
const EYES: [[[f64; 3]; 3]; 4] = [
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [
        [0.152_286, 1.052_583, -0.204_868],
        [0.114_503, 0.786_281, 0.099_216],
        [-0.003_882, -0.048_116, 1.051_998],
    ],
    [
        [0.367_322, 0.860_646, -0.227_968],
        [0.280_085, 0.672_501, 0.047_413],
        [-0.011_820, 0.042_940, 0.968_881],
    ],
    [
        [1.255_528, -0.076_749, -0.178_779],
        [-0.078_411, 0.930_809, 0.147_602],
        [0.004_733, 0.691_367, 0.303_900],
    ],
];

fn environment(variables: &[(&str, &str)]) -> Environment {
    let of = |name: &str| {
        let found = variables.iter().find(|(key, _)| *key == name);
        found.map(|(_, value)| (*value).to_owned())
    };
    Environment {
        no_color: of("NO_COLOR").is_some(),
        colorterm: of("COLORTERM"),
        term: of("TERM"),
        colorfgbg: of("COLORFGBG"),
        locale: of("LANG"),
    }
}

fn resolve(options: Options, variables: &[(&str, &str)]) -> Theme {
    Theme::resolve(options, &environment(variables))
}

fn asking(colours: Colours) -> Options {
    Options {
        colours: Some(colours),
        ..Options::default()
    }
}

/// The RGB bytes of a colour; indexed colours by xterm's 6 x 6 x 6 cube and grey ramp.
fn bytes(colour: Color) -> [u8; 3] {
    match colour {
        Color::Rgb(r, g, b) => [r, g, b],
        Color::Indexed(n @ 232..) => [8 + 10 * (n - 232); 3],
        Color::Indexed(n @ 16..) => {
            let level = |digit: u8| [0, 95, 135, 175, 215, 255][usize::from(digit)];
            let n = n - 16;
            [level(n / 36), level(n / 6 % 6), level(n % 6)]
        }
        other => panic!("{other:?} is the terminal's own"),
    }
}

/// Linear RGB from gamma-encoded bytes (IEC 61966-2-1).
fn linear(bytes: [u8; 3]) -> [f64; 3] {
    bytes.map(|byte| {
        let x = f64::from(byte) / 255.0;
        if x <= 0.040_45 {
            x / 12.92
        } else {
            ((x + 0.055) / 1.055).powf(2.4)
        }
    })
}

fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The contrast ratio of the Web Content Accessibility Guidelines 2.1, from 1 to 21.
fn contrast(one: [u8; 3], other: [u8; 3]) -> f64 {
    let [a, b] = [one, other].map(|bytes| luminance(linear(bytes)) + 0.05);
    a.max(b) / a.min(b)
}

/// The difference of two colours for an eye: the distance in CIE 1976 L*a*b*, white D65.
fn difference(one: [u8; 3], other: [u8; 3], eye: &[[f64; 3]; 3]) -> f64 {
    let lab = |bytes: [u8; 3]| {
        let seen = linear(bytes);
        let [r, g, b] = eye.map(|row| {
            (0..3)
                .map(|k| row[k] * seen[k])
                .sum::<f64>()
                .clamp(0.0, 1.0)
        });
        let f = |t: f64| {
            if t > 216.0 / 24_389.0 {
                t.cbrt()
            } else {
                (24_389.0 / 27.0 * t + 16.0) / 116.0
            }
        };
        let x = f((0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b) / 0.950_47);
        let y = f(luminance([r, g, b]));
        let z = f((0.019_333_9 * r + 0.119_192 * g + 0.950_304_1 * b) / 1.088_83);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    };
    let (p, q) = (lab(one), lab(other));
    (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
}

/// A palette, its backgrounds, and the contrast of its text and of its curves.
type Fixed = (&'static ColourPalette, Vec<[u8; 3]>, [f64; 2]);

fn fixed() -> [Fixed; 6] {
    let both = || vec![DARK[0], LIGHT[0]];
    [
        (&palette::INDEXED_DARK, DARK.to_vec(), [4.5, 4.5]),
        (&palette::RGB_DARK, DARK.to_vec(), [4.5, 4.5]),
        (&palette::INDEXED_LIGHT, LIGHT.to_vec(), [4.5, 4.5]),
        (&palette::RGB_LIGHT, LIGHT.to_vec(), [4.5, 4.5]),
        // The guidelines require 3 for graphics (1.4.11); more is not possible on both backgrounds.
        (&palette::INDEXED, both(), [4.5, 3.0]),
        (&palette::RGB, both(), [4.5, 3.0]),
    ]
}

#[test]
fn the_contrast_is_enough_to_read() {
    // Black on white has 21, by definition.
    assert!((contrast(DARK[0], LIGHT[0]) - 21.0).abs() < 1e-12);
    for (palette, grounds, [text, line]) in fixed() {
        for ground in grounds {
            let words = [palette.accent, palette.changed, palette.refusal];
            for colour in words.into_iter().chain(palette.muted) {
                let found = contrast(bytes(colour), ground);
                assert!(found >= text, "{colour:?} on {ground:02x?}: {found}");
            }
            for colour in palette.curves {
                let found = contrast(bytes(*colour), ground);
                assert!(found >= line, "{colour:?} on {ground:02x?}: {found}");
            }
        }
    }
}

#[test]
fn curves_differ_for_every_kind_of_colour_vision() {
    // A difference of about 2 can just be seen side by side (Mahy et al. 1994).
    for (palette, ..) in fixed() {
        for (number, one) in palette.curves.iter().enumerate() {
            for (before, other) in palette.curves[..number].iter().enumerate() {
                for (eye, matrix) in EYES.iter().enumerate() {
                    let found = difference(bytes(*one), bytes(*other), matrix);
                    let least = if number < 4 { 24.0 } else { 15.0 };
                    assert!(
                        found >= least,
                        "{before} and {number} to eye {eye}: {found}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_terminals_own_colours_are_the_default() {
    for term in ["xterm", "xterm-256color", "screen", "tmux-256color"] {
        let theme = resolve(
            Options::default(),
            &[("TERM", term), ("COLORTERM", "truecolor")],
        );
        assert_eq!(theme.scheme, Scheme::Terminal, "{term}");
        assert_eq!(theme.curve(0).fg, Some(Color::Cyan));
    }
}

#[test]
fn a_known_background_gives_a_palette_of_the_terminals_depth() {
    let dark = [("COLORFGBG", "15;0"), ("TERM", "xterm-256color")];
    let theme = resolve(Options::default(), &dark);
    assert_eq!(theme.palette(), Some(&palette::INDEXED_DARK));
    let light = [("COLORFGBG", "0;default;15"), ("COLORTERM", "24bit")];
    let theme = resolve(Options::default(), &light);
    assert_eq!(theme.palette(), Some(&palette::RGB_LIGHT));
    // The options override the environment.
    let options = Options {
        ground: Some(Ground::Dark),
        ..Options::default()
    };
    let theme = resolve(options, &light);
    assert_eq!(theme.palette(), Some(&palette::RGB_DARK));
    assert_eq!(
        resolve(options, &[]).palette(),
        Some(&palette::SIXTEEN_DARK)
    );
    let unknown = [("COLORFGBG", "0;default")];
    let theme = resolve(Options::default(), &unknown);
    assert_eq!(theme.palette(), Some(&palette::SIXTEEN));
}

#[test]
fn a_requested_depth_is_used_on_any_background() {
    let theme = |colours| resolve(asking(colours), &[("TERM", "xterm")]).palette();
    assert_eq!(theme(Colours::Sixteen), Some(&palette::SIXTEEN));
    assert_eq!(theme(Colours::TwoFiftySix), Some(&palette::INDEXED));
    assert_eq!(theme(Colours::Truecolor), Some(&palette::RGB));
}

#[test]
fn no_color_applies_unless_colours_are_requested() {
    let variables = &[("NO_COLOR", "1")];
    assert_eq!(resolve(Options::default(), variables).palette(), None);
    assert_eq!(resolve(asking(Colours::Auto), variables).palette(), None);
    for colours in [Colours::Always, Colours::Sixteen] {
        assert!(resolve(asking(colours), variables).palette().is_some());
    }
    assert_eq!(resolve(asking(Colours::Never), &[]).palette(), None);
}

#[test]
fn the_next_theme_cycles() {
    let mut theme = Theme::new(true);
    let mut names = Vec::new();
    for _ in 0..4 {
        names.push(theme.name());
        theme = theme.next();
    }
    assert_eq!(theme, Theme::new(true));
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 4);
}

#[test]
fn without_unicode_everything_is_ascii_whatever_the_marker() {
    let glyphs = |marker, ascii, lang| {
        let options = Options {
            ascii,
            marker,
            ..Options::default()
        };
        let theme = resolve(options, &[("LANG", lang), ("TERM", "xterm")]);
        (theme.glyphs(), theme.is_ascii())
    };
    let unicode = "de_DE.UTF-8";
    assert_eq!(glyphs(None, None, unicode), (Glyphs::Braille, false));
    assert_eq!(
        glyphs(Some(Marker::Block), None, unicode),
        (Glyphs::Block, false)
    );
    assert_eq!(
        glyphs(Some(Marker::Ascii), None, unicode),
        (Glyphs::Ascii, false)
    );
    assert_eq!(
        glyphs(Some(Marker::Dot), Some(true), unicode),
        (Glyphs::Ascii, true)
    );
    assert_eq!(
        glyphs(Some(Marker::Block), None, "C"),
        (Glyphs::Ascii, true)
    );
    assert_eq!(
        glyphs(Some(Marker::Block), Some(false), "C"),
        (Glyphs::Block, false)
    );
}

#[test]
fn without_colours_everything_still_differs_from_plain_text() {
    let theme = Theme::new(false);
    let styles = [
        theme.accent(),
        theme.selection(),
        theme.selection_aside(),
        theme.dim(),
        theme.changed(),
        theme.refusal(),
        theme.key(),
    ];
    for style in styles {
        assert_eq!((style.fg, style.bg), (None, None));
        assert!(!style.add_modifier.is_empty());
    }
}
