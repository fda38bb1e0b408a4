//! The cross-section, looking along x: axis of the beam, shear centre, centroid, radii of gyration, and where the springs
//! of a subsystem meet the beam.
//!
//! A point (y, z) of the section moves by w + z psi along y and by v - y psi along z, from the beam's axis at (0, 0),
//! which is the shear centre of a span without offset (Chen & Liu 2022, Section 2). A left spring along z meets v - `y_u` psi, so it is at y = +`y_u`; with y to the left
//! it is on the left. Second moments: `I_y` of y squared (bending along y), `I_z` of z squared about the centroid. The
//! model does not contain the position of the mass or the lengths of its springs: the mass is drawn below everything.

mod mass;
mod plane;

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::Line;

use self::plane::{Extent, Plane};
use crate::model::{At, Group, Model, Point, Section, Subsystem, UniformPart};
use crate::tui::app::App;
use crate::tui::sketch::{Board, Signs, width};
use crate::tui::theme::Theme;
use crate::tui::tree::Node;
use crate::tui::view::frame;
use crate::tui::view::text::cut;

/// From this number of rows on, the top row is reserved for text.
const HEADED: u16 = 10;

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let model = app.model();
    let signs = Signs::of(theme);
    let subsystem = subsystem(model, app.selection.node());
    let parts = model.uniform_parts();
    let shown = shown_part(&parts, app.selection.node(), subsystem);
    let span = (!model.spans.is_empty()).then_some(shown);
    let title = frame::rule(&heading(span, subsystem, usize::from(area.width)), theme);
    let room = usize::from(area.width).saturating_sub(title.width() + 3);
    let notes = notes(&parts[shown], subsystem, signs);
    let fitting = notes
        .into_iter()
        .find(|note| crate::tui::view::text::width(note) <= room);
    let note = Line::styled(format!(" {} ", fitting.unwrap_or_default()), theme.dim());
    let block = frame::panel(title, note, area.width).border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    if inside.is_empty() {
        return;
    }
    let picture = Picture::new(&parts[shown], subsystem, theme, inside);
    let mut board = Board::new(frame.buffer_mut(), inside);
    picture.draw(&mut board);
}

/// The selected subsystem, or the one whose mass has the selected force or response; otherwise the first enabled one.
fn subsystem(model: &Model, node: Node) -> Option<&Subsystem> {
    let named = |at: At<'_>| match at {
        At::Subsystem(name) => model.subsystems.iter().find(|one| one.name == name),
        At::Beam(_) | At::Support(_) | At::Ground => None,
    };
    let selected = match node.item() {
        Some(Group::Subsystem(i)) => model.subsystems.get(i),
        Some(Group::Force(i)) => named(model.forces[i].target.at()),
        Some(Group::Response(i)) => model.responses[i].quantity.at().and_then(named),
        _ => None,
    };
    selected
        .or_else(|| model.attached().next())
        .or_else(|| model.subsystems.first())
}

/// The part of the beam whose section is shown: the selected span, or that at the subsystem, the left one where two meet;
/// otherwise the first.
fn shown_part(parts: &[UniformPart], node: Node, subsystem: Option<&Subsystem>) -> usize {
    if let Some(Group::Span(i)) = node.item() {
        return i;
    }
    let last = parts.len() - 1;
    subsystem.map_or(0, |subsystem| {
        parts[..last].partition_point(|part| part.end < subsystem.position)
    })
}

fn heading(span: Option<usize>, subsystem: Option<&Subsystem>, columns: usize) -> String {
    let section = match span {
        None => "Section".to_owned(),
        Some(i) => format!("Section of span {}", i + 1),
    };
    match subsystem {
        None => section,
        Some(subsystem) => {
            let off = if subsystem.enabled { "" } else { ", off" };
            let room = columns.saturating_sub(section.len() + 13);
            let name = cut(&subsystem.name, room.max(4));
            format!("{section} at {name}{off}")
        }
    }
}

/// The numbers of the section and the mounts, the longest texts first.
fn notes(part: &UniformPart, subsystem: Option<&Subsystem>, signs: &Signs) -> Vec<String> {
    let section = &part.beam.section;
    let along_z = format!("z_c {} mm", millimetres(section.centroid_offset));
    let centroid = if section.centroid_offset_y == 0.0 {
        along_z
    } else {
        format!("y_c {}, {along_z}", millimetres(section.centroid_offset_y))
    };
    let offset = if part.offset == Point::AXIS {
        String::new()
    } else {
        let [y, z] = [part.offset.y, part.offset.z].map(millimetres);
        format!("offset y {y}, z {z} mm, ")
    };
    let points = format!("{offset}{centroid}");
    let mut notes = Vec::new();
    if let Some(subsystem) = subsystem {
        let spacing = millimetres(subsystem.mount_y.abs());
        let spacing = format!("{}{spacing}", signs.plus_minus);
        let height = millimetres(subsystem.mount_z);
        notes.push(format!("{points}, mounts y {spacing} mm, z {height} mm"));
        notes.push(format!("{points}, mounts {spacing}, {height} mm"));
    }
    notes.extend([points, centroid]);
    notes
}

/// A length in mm with three significant digits.
fn millimetres(metres: f64) -> String {
    let rounded: f64 = format!("{:.2e}", metres * 1e3).parse().unwrap_or(f64::NAN);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        0.001..1e6 => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

/// What is drawn, and its position.
struct Picture<'a> {
    part: &'a UniformPart,
    subsystem: Option<&'a Subsystem>,
    theme: Theme,
    signs: &'static Signs,
    plane: Plane,
}

impl<'a> Picture<'a> {
    fn new(
        part: &'a UniformPart,
        subsystem: Option<&'a Subsystem>,
        theme: Theme,
        inside: Rect,
    ) -> Self {
        let mut extent = Extent::default();
        extent.take(part.offset.y, part.offset.z);
        let [across, up] = radii(&part.beam.section);
        let centroid = centroid(part);
        for side in [-1.0, 1.0] {
            extent.take(centroid.y + side * across, centroid.z + side * up);
        }
        let mut reserve = plane::Reserve::default();
        if let Some(subsystem) = subsystem {
            mass::take(subsystem, &mut extent);
            reserve = mass::reserve(subsystem, [inside.width, inside.height]);
        }
        reserve.head = i32::from(inside.height >= HEADED);
        Self {
            part,
            subsystem,
            theme,
            signs: Signs::of(theme),
            plane: Plane::new(&extent, reserve, [inside.width, inside.height]),
        }
    }

    fn draw(&self, board: &mut Board<'_>) {
        let cell = |point: Point| self.plane.cell(point.y, point.z);
        let bold = self.theme.accent();
        let axis = (Point::AXIS, self.signs.axis, 'O');
        let points = [
            (self.part.offset, self.signs.shear_centre, 'S'),
            (centroid(self.part), self.signs.centroid, 'C'),
        ];
        // Without an offset, the shear centre is on the axis.
        let apart = (self.part.offset != Point::AXIS).then_some(axis);
        let points = points.into_iter().chain(apart);
        for (point, sign, _) in points.clone() {
            board.sign_if_free(cell(point), sign, bold);
        }
        // Letters at the right, so that all can be read if points coincide.
        for (point, _, name) in points {
            letter(board, (cell(point), name), bold);
        }
        if let Some(subsystem) = self.subsystem {
            mass::draw(self, board, subsystem);
        }
        self.plane.draw(board, self.signs, self.theme.dim());
        self.draw_ellipse(board);
        self.draw_words(board);
    }

    /// The ellipse of inertia about the centroid, about one dot per column: its axes are the principal axes, with the radii of
    /// gyration.
    fn draw_ellipse(&self, board: &mut Board<'_>) {
        let section = &self.part.beam.section;
        let centroid = centroid(self.part);
        let [across, up] = radii(section);
        // (y, z) = (across cos, lean cos + rise sin) is the ellipse of the matrix of second moments over A.
        let lean = section.product_moment / (section.area * across);
        let rise = (up * up - lean * lean).max(0.0).sqrt();
        let scale = self.plane.metres_per_column();
        let columns = std::f64::consts::PI * (across + up) / scale;
        let count = if columns.is_finite() {
            columns.clamp(8.0, 2000.0) as u16
        } else {
            0
        };
        let points = (0..count).map(|i| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
            let (cosine, sine) = (angle.cos(), angle.sin());
            (
                centroid.y + across * cosine,
                centroid.z + lean * cosine + rise * sine,
            )
        });
        self.plane
            .draw_dots(board, points, self.theme.glyphs(), self.theme.curve(0));
    }

    fn draw_words(&self, board: &mut Board<'_>) {
        let [across, up] = radii(&self.part.beam.section).map(millimetres);
        let words = [
            format!("dots: radii of gyration {across} mm along y, {up} mm along z"),
            format!("dots: radii of gyration {across}, {up} mm"),
            format!("gyration {across}, {up} mm"),
            "dots: sqrt(I/A)".to_owned(),
        ];
        let rows = 0..board.rows();
        for (word, row) in words
            .iter()
            .flat_map(|word| rows.clone().map(move |row| (word, row)))
        {
            let columns = width(word);
            // At the right or at the left, outside the picture.
            for column in [board.columns() - columns, self.plane.first_column() + 1] {
                let free = board.is_free([column - 1, row], columns + 2);
                if free && board.word([column, row], word, self.theme.dim()) {
                    return;
                }
            }
        }
    }
}

/// From the axis of the beam.
fn centroid(part: &UniformPart) -> Point {
    let section = &part.beam.section;
    Point {
        y: part.offset.y + section.centroid_offset_y,
        z: part.offset.z + section.centroid_offset,
    }
}

/// The radii of gyration along y and along z, m: sqrt(`I_y` / A) and sqrt(`I_z` / A).
fn radii(section: &Section) -> [f64; 2] {
    [section.second_moment_y, section.second_moment_z].map(|moment| (moment / section.area).sqrt())
}

/// Puts a letter next to a point: at the right, or at another place with room.
fn letter(board: &mut Board<'_>, ([column, row], letter): ([i32; 2], char), style: Style) {
    let places = [
        [column + 1, row],
        [column + 2, row],
        [column - 1, row],
        [column, row - 1],
        [column, row + 1],
    ];
    for place in places {
        if board.sign_if_free(place, letter, style) {
            return;
        }
    }
}

#[cfg(test)]
mod tests;
