//! The appearance of the designer: the user's options, and the capabilities of the terminal from the environment.

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};

use crate::words::words;

/// An enum of choices, each with its word on the command line and in the configuration file.
macro_rules! choices {
    (
        $(#[$meta:meta])*
        $name:ident { $($(#[doc = $doc:literal])+ $choice:ident = $word:literal,)+ }
    ) => {
        words! {
            $(#[$meta])*
            pub enum $name { $($(#[doc = $doc])+ $choice = $word,)+ }
        }

        impl ValueEnum for $name {
            fn value_variants<'a>() -> &'a [Self] {
                &Self::ALL
            }

            fn to_possible_value(&self) -> Option<PossibleValue> {
                let help = match self {
                    $(Self::$choice => concat!($($doc),+).trim().trim_end_matches('.'),)+
                };
                Some(PossibleValue::new(self.key()).help(help))
            }
        }
    };
}

choices! {
    /// How many colours are used.
    Colours {
        /// As many as the terminal reports; none if `NO_COLOR` is set.
        Auto = "auto",
        /// The same, regardless of `NO_COLOR`.
        Always = "always",
        /// None: bold, dim, underlined and reversed instead.
        Never = "never",
        /// The terminal's own sixteen.
        Sixteen = "16",
        /// The fixed palette of 256.
        TwoFiftySix = "256",
        /// Red, green and blue, one byte each.
        Truecolor = "truecolor",
    }
}

choices! {
    /// The background of the terminal.
    Ground {
        /// As the environment says, otherwise unknown.
        Auto = "auto",
        /// Light text on a dark background.
        Dark = "dark",
        /// Dark text on a light background.
        Light = "light",
    }
}

choices! {
    /// The characters that draw curves.
    Marker {
        /// Dots, eight per cell.
        Braille = "braille",
        /// Eighths of a cell; few fonts have them.
        Octant = "octant",
        /// Quarters of a cell.
        Block = "block",
        /// A bullet per cell.
        Dot = "dot",
        /// ASCII letters and signs.
        Ascii = "ascii",
    }
}

/// Appearance options; `None` is not set.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Options {
    /// How many colours.
    pub colours: Option<Colours>,
    /// The background.
    pub ground: Option<Ground>,
    /// Only ASCII on the whole screen.
    pub ascii: Option<bool>,
    /// The characters of curves.
    pub marker: Option<Marker>,
    /// Whether the program captures the mouse.
    pub mouse: Option<bool>,
}

impl Options {
    /// These options, with defaults from `beneath`.
    #[must_use]
    pub fn over(self, beneath: Self) -> Self {
        Self {
            colours: self.colours.or(beneath.colours),
            ground: self.ground.or(beneath.ground),
            ascii: self.ascii.or(beneath.ascii),
            marker: self.marker.or(beneath.marker),
            mouse: self.mouse.or(beneath.mouse),
        }
    }
}

/// Appearance options on the command line.
#[derive(Debug, Clone, Copy, Default, Args)]
#[command(next_help_heading = "Look")]
pub struct AppearanceArguments {
    /// How many colours to use.
    #[arg(long, value_name = "WHEN")]
    pub color: Option<Colours>,
    /// The background of the terminal; sets which colours are used.
    #[arg(long, value_name = "BACKGROUND")]
    pub theme: Option<Ground>,
    /// Draws with ASCII characters only; `--ascii=false` with all, regardless of the locale.
    #[arg(long, value_name = "BOOL", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    pub ascii: Option<bool>,
    /// The characters that draw curves.
    #[arg(long, value_name = "KIND")]
    pub marker: Option<Marker>,
    /// Leaves the mouse to the terminal.
    #[arg(long)]
    pub no_mouse: bool,
}

impl AppearanceArguments {
    /// As options; a missing flag is not set.
    pub fn options(self) -> Options {
        Options {
            colours: self.color,
            ground: self.theme,
            ascii: self.ascii,
            marker: self.marker,
            mouse: self.no_mouse.then_some(false),
        }
    }
}

/// What the environment variables say about the terminal.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Environment {
    /// `NO_COLOR` is set and not empty (no-color.org).
    pub no_color: bool,
    /// `COLORTERM`.
    pub colorterm: Option<String>,
    /// `TERM`.
    pub term: Option<String>,
    /// `COLORFGBG`: the numbers of the foreground and the background colour, such as `15;0`.
    pub colorfgbg: Option<String>,
    /// `LC_ALL`, `LC_CTYPE` or `LANG`: the first that is set and not empty (POSIX.1-2017, 8.2).
    pub locale: Option<String>,
}

impl Environment {
    /// The environment of this process.
    pub fn of_process() -> Self {
        let variable = |name: &str| {
            let value = std::env::var_os(name)?;
            (!value.is_empty()).then(|| value.to_string_lossy().into_owned())
        };
        Self {
            no_color: variable("NO_COLOR").is_some(),
            colorterm: variable("COLORTERM"),
            term: variable("TERM"),
            colorfgbg: variable("COLORFGBG"),
            locale: ["LC_ALL", "LC_CTYPE", "LANG"]
                .into_iter()
                .find_map(variable),
        }
    }

    /// Whether the terminal shows more than ASCII: the locale is UTF-8, and the terminal is not a console whose font
    /// lacks braille and box drawing.
    pub fn is_unicode(&self) -> bool {
        let locale = self.locale.as_deref().unwrap_or("C").to_ascii_lowercase();
        // The code set follows the full stop; Darwin also accepts a bare `UTF-8`.
        let unicode = locale.contains("utf-8") || locale.contains("utf8");
        unicode && !self.is_plain()
    }

    /// Whether a screen can be drawn: `TERM` is set, and the terminal is not line-only.
    pub fn has_screen(&self) -> bool {
        self.term.as_deref().is_some_and(|term| term != "dumb")
    }

    /// Whether the terminal is a console, a hardware terminal or unknown.
    fn is_plain(&self) -> bool {
        let term = self.term.as_deref().unwrap_or("unknown");
        term == "linux" || term == "unknown" || term.starts_with("vt")
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        look: AppearanceArguments,
    }

    fn options(arguments: &[&str]) -> Options {
        let line = std::iter::once(&"beamtune").chain(arguments);
        Line::try_parse_from(line).unwrap().look.options()
    }

    #[test]
    fn every_word_names_one_choice() {
        for colours in Colours::ALL {
            let expected = Options {
                colours: Some(colours),
                ..Options::default()
            };
            assert_eq!(options(&["--color", colours.key()]), expected);
        }
        for marker in Marker::ALL {
            assert_eq!(options(&["--marker", marker.key()]).marker, Some(marker));
        }
        for ground in Ground::ALL {
            assert_eq!(options(&["--theme", ground.key()]).ground, Some(ground));
        }
    }

    #[test]
    fn flags_that_were_not_given_say_nothing() {
        assert_eq!(options(&[]), Options::default());
        let given = options(&["--ascii", "--no-mouse", "--marker=dot", "--theme=light"]);
        let expected = Options {
            colours: None,
            ground: Some(Ground::Light),
            ascii: Some(true),
            marker: Some(Marker::Dot),
            mouse: Some(false),
        };
        assert_eq!(given, expected);
    }

    #[test]
    fn what_is_asked_for_last_lies_above() {
        assert_eq!(options(&["--ascii=false"]).ascii, Some(false));
        let above = options(&["--ascii", "--color", "16"]);
        let beneath = Options {
            colours: Some(Colours::Never),
            ground: Some(Ground::Dark),
            ascii: Some(false),
            marker: None,
            mouse: Some(true),
        };
        let expected = Options {
            colours: Some(Colours::Sixteen),
            ground: Some(Ground::Dark),
            ascii: Some(true),
            marker: None,
            mouse: Some(true),
        };
        assert_eq!(above.over(beneath), expected);
    }

    #[test]
    fn only_a_unicode_terminal_in_a_unicode_locale_shows_more_than_ascii() {
        let shows = |locale: Option<&str>, term: Option<&str>| {
            let environment = Environment {
                locale: locale.map(str::to_owned),
                term: term.map(str::to_owned),
                ..Environment::default()
            };
            environment.is_unicode()
        };
        assert!(shows(Some("de_DE.UTF-8"), Some("xterm")));
        assert!(shows(Some("C.utf8"), Some("tmux-256color")));
        assert!(!shows(Some("de_DE.ISO-8859-1"), Some("xterm")));
        assert!(!shows(Some("C"), Some("xterm")));
        assert!(!shows(None, Some("xterm")));
        assert!(!shows(Some("en_US.UTF-8"), Some("linux")));
        assert!(!shows(Some("en_US.UTF-8"), Some("vt220")));
        assert!(!shows(Some("en_US.UTF-8"), None));
    }

    #[test]
    fn a_terminal_that_only_writes_lines_has_no_screen() {
        let has_screen = |term: Option<&str>| {
            let environment = Environment {
                term: term.map(str::to_owned),
                ..Environment::default()
            };
            environment.has_screen()
        };
        assert!(has_screen(Some("xterm")) && has_screen(Some("vt100")));
        assert!(!has_screen(Some("dumb")) && !has_screen(None));
    }
}
