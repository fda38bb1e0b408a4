//! Single values of the text.

use super::super::path::Pattern;
use super::reader::{Reader, quoted};
use toml::Spanned;
use toml::de::DeValue;

/// A value with its position in the text.
pub(crate) type Node<'a> = &'a Spanned<DeValue<'a>>;

/// A value that must be a finite number, whole numbers included; NaN if it is not.
pub(super) fn number(path: &str, node: Node<'_>, expected: &str, reader: &mut Reader) -> f64 {
    let (value, text, wish) = match node.get_ref() {
        DeValue::Float(float) => (
            float.as_str().parse::<f64>().ok(),
            float.to_string(),
            "finite",
        ),
        DeValue::Integer(integer) => (
            whole(node).map(|value| value as f64),
            integer.to_string(),
            "below 2^63",
        ),
        _ => {
            reader.fault(node.span().start, path, wrong_type(node, expected));
            return f64::NAN;
        }
    };
    value.filter(|value| value.is_finite()).unwrap_or_else(|| {
        reader.fault(
            node.span().start,
            path,
            format!("is {text}; must be {wish}, {expected}"),
        );
        f64::NAN
    })
}

/// A whole number of 64 bits.
pub(super) fn whole(node: Node<'_>) -> Option<i64> {
    let integer = node.get_ref().as_integer()?;
    i64::from_str_radix(integer.as_str(), integer.radix()).ok()
}

/// A value that must be a text.
pub(super) fn text(path: &str, node: Node<'_>, reader: &mut Reader) -> Option<String> {
    let text = node.get_ref().as_str();
    if text.is_none() {
        reader.fault(
            node.span().start,
            path,
            wrong_type(node, "a text in quotes"),
        );
    }
    text.map(str::to_owned)
}

/// A path or pattern; empty if it is not a text.
pub(super) fn pattern(path: &str, node: Node<'_>, reader: &mut Reader) -> Pattern {
    text(path, node, reader).unwrap_or_default().into()
}

/// The message for a value of another type.
pub(crate) fn wrong_type(node: Node<'_>, expected: &str) -> String {
    let found = match node.get_ref() {
        DeValue::String(text) => format!("the text {}", quoted(text)),
        DeValue::Integer(integer) => integer.to_string(),
        DeValue::Float(float) => float.to_string(),
        DeValue::Boolean(flag) => flag.to_string(),
        DeValue::Datetime(time) => time.to_string(),
        DeValue::Array(_) => "an array".to_owned(),
        DeValue::Table(_) => "a table".to_owned(),
    };
    format!("is {found}; must be {expected}")
}
