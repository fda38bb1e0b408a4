//! Byte offsets as lines and columns.

/// Walks once through a text, so that many rising offsets cost no more than one.
pub(super) struct Cursor<'a> {
    rest: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Cursor<'a> {
    /// At the start of the text.
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            rest: text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// Line and column, from 1 and in characters, of an offset not before the last one asked for.
    pub(super) fn advance(&mut self, offset: usize) -> (usize, usize) {
        let mut length = offset.saturating_sub(self.offset).min(self.rest.len());
        while !self.rest.is_char_boundary(length) {
            length -= 1;
        }
        let (passed, rest) = self.rest.split_at(length);
        match passed.rfind('\n') {
            Some(newline) => {
                self.line += passed.matches('\n').count();
                self.column = 1 + passed[newline + 1..].chars().count();
            }
            None => self.column += passed.chars().count(),
        }
        self.rest = rest;
        self.offset += length;
        (self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let mut cursor = Cursor::new("aé\nöb\n\nc");
        assert_eq!(cursor.advance(0), (1, 1));
        assert_eq!(cursor.advance(3), (1, 3));
        assert_eq!(cursor.advance(6), (2, 2));
        assert_eq!(cursor.advance(6), (2, 2));
        assert_eq!(cursor.advance(99), (4, 2));
    }

    #[test]
    fn an_offset_inside_a_character_is_that_character() {
        assert_eq!(Cursor::new("éb").advance(1), (1, 1));
    }
}
