//! Enums whose values have words in files.

/// A choice whose values have words in files; in a model file, the first is the default.
macro_rules! words {
    ($(#[$doc:meta])* pub enum $name:ident { $($(#[$of:meta])* $value:ident = $word:literal,)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $name { $($(#[$of])* $value,)* }

        impl $name {
            /// The words in files.
            pub const WORDS: &'static [&'static str] = &[$($word),*];
            /// All of them, in the order of the words.
            pub const ALL: [Self; Self::WORDS.len()] = [$(Self::$value),*];

            /// The value of a word in files.
            pub fn of_word(word: &str) -> Option<Self> {
                let known = Self::WORDS.iter().position(|known| *known == word)?;
                Some(Self::ALL[known])
            }

            /// The word in files.
            pub const fn key(self) -> &'static str {
                Self::WORDS[self as usize]
            }
        }
    };
}
pub(crate) use words;
