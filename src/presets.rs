//! The paper's figures and a few more models, embedded in the program.
//!
//! Each is a file of `presets/` and also an example of the format. Its `notes` name the source, list the assumptions
//! where the source is incomplete, and the differences of the curves from the source.
//! The figures are those of Chen & Liu, *Mathematics* 2022, 10(16), 2849; `tests/presets.rs` asserts what they show.
//!
//! # Example
//!
//! ```
//! use beamtune::{model, presets};
//!
//! for preset in presets::ALL {
//!     println!("{:24} {}", preset.name, preset.title());
//! }
//! let preset = presets::find("fig08").expect("an embedded preset");
//! assert_eq!(model::read(preset.text).expect("a possible model").subsystems.len(), 3);
//! ```

/// An embedded model file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Preset {
    /// Its name: that of its file, without the extension.
    pub name: &'static str,
    /// The text of the file, TOML.
    pub text: &'static str,
}

impl Preset {
    /// The model's title, read from the text; the name if the text has none.
    ///
    /// Fast enough to call at every frame: it finds the line and parses nothing else.
    pub fn title(&self) -> String {
        self.text
            .lines()
            .find_map(|line| line.strip_prefix("title = \"")?.strip_suffix('"'))
            .unwrap_or(self.name)
            .to_owned()
    }
}

/// The preset with this name.
pub fn find(name: &str) -> Option<&'static Preset> {
    ALL.iter().find(|preset| preset.name == name)
}

/// One line per preset, so that no name can differ from that of its file.
macro_rules! embed {
    ($($name:literal),+ $(,)?) => {
        &[$(Preset { name: $name, text: include_str!(concat!("../presets/", $name, ".toml")) }),+]
    };
}

/// All presets: the figures in the order of the paper, then the others.
pub const ALL: &[Preset] = embed![
    "fig05a",
    "fig05b",
    "fig05c",
    "fig06",
    "fig07a",
    "fig07b",
    "fig07c",
    "fig08",
    "fig09",
    "fig10",
    "fig11",
    "fig13",
    "fig14",
    "fig15",
    "fig16",
    "fig17",
    "cantilever",
    "symmetric_section",
    "purlin",
    "tie_rod",
    "stepped_shaft",
    "deep_beam",
    "hundred_absorbers",
    "semicircular_cantilever",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preset_is_found_by_its_name_only() {
        assert_eq!(find("fig08").map(|preset| preset.name), Some("fig08"));
        assert_eq!(find("fig12"), None);
        assert_eq!(find(""), None);
    }

    #[test]
    fn a_text_without_a_title_goes_by_its_name() {
        let preset = Preset {
            name: "bare",
            text: "format = \"beamtune/1\"\n",
        };
        assert_eq!(preset.title(), "bare");
    }
}
