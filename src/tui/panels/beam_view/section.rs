//! The cross-section, looking along x: shear centre, centroid, radii of gyration, and where the springs of a subsystem
//! meet the beam.
//!
//! A point (y, z) of the section moves by w + z psi along y and by v - y psi along z, from the shear centre at (0, 0)
//! (Chen & Liu 2022, Section 2). A left spring along z meets v - `y_u` psi, so it is at y = +`y_u`; with y to the left
//! it is on the left. Second moments: `I_y` of y squared (bending along y), `I_z` of z squared about the centroid. The
//! model does not contain the position of the mass or the lengths of its springs: the mass is drawn below everything.

mod mass;
mod plane;

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::Line;

use self::plane::{Extent, Plane};
use crate::model::{Group, Model, Quantity, Section, Subsystem, Target};
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
    let title = frame::rule(&heading(subsystem, usize::from(area.width)), theme);
    let room = usize::from(area.width).saturating_sub(title.width() + 3);
    let notes = notes(&model.beam.section, subsystem, signs);
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
    let picture = Picture::new(&model.beam.section, subsystem, theme, inside);
    let mut board = Board::new(frame.buffer_mut(), inside);
    picture.draw(&mut board);
}

/// The selected subsystem, or the one whose mass has the selected force or response; otherwise the first enabled one.
fn subsystem(model: &Model, node: Node) -> Option<&Subsystem> {
    let named = |target: &Target| match target {
        Target::Mass(name, _) => model.subsystems.iter().find(|one| one.name == *name),
        Target::Beam(..) => None,
    };
    let selected = match node.item() {
        Some(Group::Subsystem(i)) => model.subsystems.get(i),
        Some(Group::Force(i)) => named(&model.forces[i].target),
        Some(Group::Response(i)) => match &model.responses[i].quantity {
            Quantity::Motion(target, _) => named(target),
            Quantity::Energy => None,
        },
        _ => None,
    };
    selected
        .or_else(|| model.attached().next())
        .or_else(|| model.subsystems.first())
}

fn heading(subsystem: Option<&Subsystem>, columns: usize) -> String {
    match subsystem {
        None => "Section".to_owned(),
        Some(subsystem) => {
            let off = if subsystem.enabled { "" } else { ", off" };
            let name = cut(&subsystem.name, columns.saturating_sub(20).max(4));
            format!("Section at {name}{off}")
        }
    }
}

/// The numbers of the section and the mounts, the longest texts first.
fn notes(section: &Section, subsystem: Option<&Subsystem>, signs: &Signs) -> Vec<String> {
    let along_z = format!("z_c {} mm", millimetres(section.centroid_offset));
    let centroid = if section.centroid_offset_y == 0.0 {
        along_z
    } else {
        format!("y_c {}, {along_z}", millimetres(section.centroid_offset_y))
    };
    let Some(subsystem) = subsystem else {
        return vec![centroid];
    };
    let spacing = format!(
        "{}{}",
        signs.plus_minus,
        millimetres(subsystem.mount_y.abs())
    );
    let height = millimetres(subsystem.mount_z);
    vec![
        format!("{centroid}, mounts y {spacing} mm, z {height} mm"),
        format!("{centroid}, mounts {spacing}, {height} mm"),
        centroid,
    ]
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
    section: &'a Section,
    subsystem: Option<&'a Subsystem>,
    theme: Theme,
    signs: &'static Signs,
    plane: Plane,
}

impl<'a> Picture<'a> {
    fn new(
        section: &'a Section,
        subsystem: Option<&'a Subsystem>,
        theme: Theme,
        inside: Rect,
    ) -> Self {
        let mut extent = Extent::default();
        let [across, up] = radii(section);
        for side in [-1.0, 1.0] {
            extent.take(
                section.centroid_offset_y + side * across,
                section.centroid_offset + side * up,
            );
        }
        let mut reserve = plane::Reserve::default();
        if let Some(subsystem) = subsystem {
            mass::take(subsystem, &mut extent);
            reserve = mass::reserve(subsystem, [inside.width, inside.height]);
        }
        reserve.head = i32::from(inside.height >= HEADED);
        Self {
            section,
            subsystem,
            theme,
            signs: Signs::of(theme),
            plane: Plane::new(&extent, reserve, [inside.width, inside.height]),
        }
    }

    fn draw(&self, board: &mut Board<'_>) {
        let shear = self.plane.cell(0.0, 0.0);
        let section = self.section;
        let centroid = (self.plane).cell(section.centroid_offset_y, section.centroid_offset);
        let bold = self.theme.accent();
        board.sign(shear, self.signs.shear_centre, bold);
        board.sign_if_free(centroid, self.signs.centroid, bold);
        let [first, second] = [(shear, 'S'), (centroid, 'C')];
        // Letters at the right, so that both can be read if the two points coincide.
        letter(board, first, bold);
        letter(board, second, bold);
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
        let section = self.section;
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
                section.centroid_offset_y + across * cosine,
                section.centroid_offset + lean * cosine + rise * sine,
            )
        });
        self.plane
            .draw_dots(board, points, self.theme.glyphs(), self.theme.curve(0));
    }

    fn draw_words(&self, board: &mut Board<'_>) {
        let [across, up] = radii(self.section).map(millimetres);
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
