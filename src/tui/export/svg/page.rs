//! The text of an SVG file.

use std::fmt::Write as _;

use crate::escape::escape;

/// The CSS of the element classes.
const STYLE: &str = "\
text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;font-size:12px;fill:#000}\
.title{font-size:16px;font-weight:bold;text-anchor:middle}\
.sub{text-anchor:middle;fill:#333}\
.print{font-size:9px;fill:#444}\
.mark{font-size:10px;fill:#222}\
.frame{fill:none;stroke:#000;stroke-width:1}\
.tick{stroke:#000;stroke-width:1}\
.grid{stroke:#d4d4d4;stroke-width:0.8}\
.zero{stroke:#808080;stroke-width:0.8}\
.band{fill:#eeeeee;stroke:#909090;stroke-width:0.8}\
.cursor{stroke:#000;stroke-width:0.8}\
.second{stroke:#000;stroke-width:0.8;stroke-dasharray:7 4}\
.harmonic{stroke:#000;stroke-width:0.7;stroke-dasharray:1 3}\
.mode{fill:#000;stroke:#000;stroke-width:1}\
.spot{fill:none;stroke:#000;stroke-width:1.4}";

/// An SVG page under construction.
#[derive(Debug)]
pub(super) struct Page {
    width: f64,
    body: String,
    clips: usize,
}

/// A length in px with at most two decimals.
pub(super) fn px(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" {
        "0".to_owned()
    } else {
        short.to_owned()
    }
}

/// A text for XML 1.0: hidden characters escaped, markup characters replaced, invalid characters removed.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in escape(&text.replace(['\n', '\r', '\t'], " ")).chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => {}
            _ => safe.push(letter),
        }
    }
    safe
}

impl Page {
    pub(super) const fn new(width: f64) -> Self {
        Self {
            width,
            body: String::new(),
            clips: 0,
        }
    }

    /// Writes an element; writing to a string has no errors.
    fn push(&mut self, element: std::fmt::Arguments<'_>) {
        let _ = self.body.write_fmt(element);
        self.body.push('\n');
    }

    /// The title, centred.
    pub(super) fn heading(&mut self, title: &str, y: f64) {
        self.text([self.width / 2.0, y], title, "class=\"title\"");
    }

    pub(super) fn text(&mut self, [x, y]: [f64; 2], text: &str, attributes: &str) {
        let (x, y, text) = (px(x), px(y), escaped(text));
        self.push(format_args!(
            "<text x=\"{x}\" y=\"{y}\" {attributes}>{text}</text>"
        ));
    }

    /// A text and a superscript power.
    pub(super) fn power(&mut self, [x, y]: [f64; 2], text: (&str, Option<&str>), anchor: &str) {
        let (x, y, digits) = (px(x), px(y), escaped(text.0));
        let power = text.1.map_or_else(String::new, |power| {
            let power = escaped(power);
            format!("<tspan dy=\"-5\" font-size=\"9\">{power}</tspan>")
        });
        self.push(format_args!(
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">{digits}{power}</text>"
        ));
    }

    /// A text rotated upward, centred at a point.
    pub(super) fn upward(&mut self, [x, y]: [f64; 2], text: &str) {
        let (x, y, text) = (px(x), px(y), escaped(text));
        self.push(format_args!(
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" transform=\"rotate(-90 {x} {y})\">{text}</text>"
        ));
    }

    pub(super) fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], attributes: &str) {
        let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(px);
        self.push(format_args!(
            "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {attributes}/>"
        ));
    }

    pub(super) fn rectangle(&mut self, [x, y]: [f64; 2], size: [f64; 2], attributes: &str) {
        let [x, y, width, height] = [x, y, size[0], size[1]].map(px);
        self.push(format_args!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" {attributes}/>"
        ));
    }

    pub(super) fn circle(&mut self, [x, y]: [f64; 2], radius: f64, attributes: &str) {
        let [x, y, radius] = [x, y, radius].map(px);
        self.push(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {attributes}/>"
        ));
    }

    pub(super) fn path(&mut self, data: &str, attributes: &str) {
        self.push(format_args!("<path d=\"{data}\" {attributes}/>"));
    }

    /// Clips the following elements to a rectangle, until [`Page::end_clip`].
    pub(super) fn begin_clip(&mut self, [left, top]: [f64; 2], [width, height]: [f64; 2]) {
        let id = self.clips;
        self.clips += 1;
        let [left, top, width, height] = [left, top, width, height].map(px);
        self.push(format_args!(
            "<clipPath id=\"plot{id}\"><rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\"/></clipPath>"
        ));
        self.push(format_args!("<g clip-path=\"url(#plot{id})\">"));
    }

    pub(super) fn end_clip(&mut self) {
        self.push(format_args!("</g>"));
    }

    /// The whole file.
    pub(super) fn finish(self, height: f64, title: &str, description: &str) -> String {
        let (width, height) = (px(self.width), px(height));
        let (title, description) = (escaped(title), escaped(description));
        let body = self.body;
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
             <title>{title}</title>\n<desc>{description}</desc>\n\
             <style>{STYLE}</style>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }
}
