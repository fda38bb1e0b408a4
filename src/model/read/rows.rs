//! Reads the keys of a table of the schema.

use super::super::schema::{Access, FEWEST_POINTS, Key, Kind, MOST_POINTS, Rows};
use super::reader::Reader;
use super::table::Table;
use super::value::{whole, wrong_type};

/// The inner tables so far, each with its key; none if the text has none.
type Inner<'a> = Vec<(&'static str, Option<Table<'a>>)>;

/// For tables in which no key has its own rules.
pub(super) fn no_own<T>(_: &mut Table<'_>, _: &mut T, _: Kind, _: &mut Reader) {}

impl<'a> Table<'a> {
    /// Every key of a table of the schema and of its inner tables; `own` reads the keys with their own rules.
    pub(super) fn rows<T>(
        &mut self,
        of: &mut T,
        rows: &Rows<T>,
        reader: &mut Reader,
        own: impl FnMut(&mut Self, &mut T, Kind, &mut Reader),
    ) {
        for (_, table) in self.open_rows(of, rows, reader, own) {
            table.finish(reader);
        }
    }

    /// The same, with the inner tables unfinished: each with its key, if the text has it.
    pub(super) fn open_rows<T>(
        &mut self,
        of: &mut T,
        rows: &Rows<T>,
        reader: &mut Reader,
        mut own: impl FnMut(&mut Self, &mut T, Kind, &mut Reader),
    ) -> Vec<(&'static str, Self)> {
        let mut inner = Vec::new();
        for (key, access) in rows.iter() {
            match access {
                Access::Number(_, set) => {
                    set(of, self.number_below(key, &mut inner, reader));
                }
                Access::OptionalNumber(_, set) => {
                    let number = self.take(key.key, reader);
                    set(
                        of,
                        number.map(|_| self.number(key.key, key.range, None, reader)),
                    );
                }
                Access::Count(_, set) => {
                    if let Some(count) = self.count(key.key, reader) {
                        set(of, count);
                    }
                }
                Access::Flag(_, set) => {
                    set(
                        of,
                        self.flag(key.key, reader).unwrap_or(key.is_on_by_default()),
                    );
                }
                Access::Word(_, set) => {
                    if let Some(index) = self.word(key.key, key.words, Some(0), reader) {
                        set(of, index);
                    }
                }
                Access::Text(_, place) => {
                    let default = (key.kind == Kind::Text).then_some("");
                    *place(of) = self.text(key.key, default, reader).unwrap_or_default();
                }
                Access::Optional(_, set) => {
                    let absent =
                        matches!(key.kind, Kind::Optional | Kind::Over) && !self.has(key.key);
                    self.accept(key.key);
                    let text = (!absent).then(|| self.text(key.key, None, reader));
                    set(of, text.flatten());
                }
                Access::Own => own(self, of, key.kind, reader),
            }
        }
        let there = |(key, table): (_, Option<Self>)| Some((key, table?));
        inner.into_iter().filter_map(there).collect()
    }

    /// A number of this table or of an inner one, which remains the current one for the next number.
    fn number_below(
        &mut self,
        key: &'static Key,
        inner: &mut Inner<'a>,
        reader: &mut Reader,
    ) -> f64 {
        let Some((head, last)) = key.key.split_once('.') else {
            return self.number(key.key, key.range, key.default, reader);
        };
        if inner.last().is_none_or(|(open, _)| *open != head) {
            inner.push((head, self.table(head, reader)));
        }
        match inner.last_mut() {
            Some((_, Some(table))) => table.number(last, key.range, key.default, reader),
            _ => key.default.unwrap_or(f64::NAN),
        }
    }

    /// A whole number of points.
    fn count(&mut self, key: &'a str, reader: &mut Reader) -> Option<usize> {
        let expected = format!("a whole number, {FEWEST_POINTS} to {MOST_POINTS}");
        let (path, node) = self.need(key, &expected, reader)?;
        let count = whole(node).map(usize::try_from);
        if let Some(Ok(count)) = count {
            return Some(count);
        }
        let message = match node.get_ref().as_integer() {
            Some(integer) => format!("is {integer}; must be {expected}"),
            None => wrong_type(node, &expected),
        };
        reader.fault(node.span().start, &path, message);
        None
    }
}
