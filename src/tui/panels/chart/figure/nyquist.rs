//! The imaginary part over the real part.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::Widget;

use super::{look, style};
use crate::tui::plot::{Chart, Curve, Glyphs, Spot};
use crate::tui::scene::axes::{Loci, nearest};
use crate::tui::scene::{CurveKind, Scene};
use crate::tui::theme::Theme;

/// Number of modes that are numbered on a locus: those with one digit.
const NUMBERED_MODES: usize = 9;

/// Draws the loci of a scene.
pub(super) fn draw(scene: &Scene, loci: &Loci, theme: Theme, (area, buffer): (Rect, &mut Buffer)) {
    let each = loci.points.iter().enumerate();
    let curves: Vec<Curve<'_>> = each
        .map(|(index, [x, y])| Curve {
            x,
            y,
            ..look(index, scene, theme, area.width)
        })
        .collect();
    let mut chart = Chart::nyquist(loci.axes.clone(), &curves);
    style(&mut chart, scene, theme);
    chart.spots = spots(scene, theme);
    chart.equalised(area).render(area, buffer);
}

/// The modes on the first curve of the model, numbered from 1, and the values at the cursor.
fn spots(scene: &Scene, theme: Theme) -> Vec<Spot> {
    let styles = theme.chart();
    let first = scene
        .curves
        .iter()
        .find(|curve| curve.kind == CurveKind::Model);
    let modes = scene.marks.modes.iter().zip('1'..).enumerate();
    let modes = modes
        .take(NUMBERED_MODES)
        .filter_map(|(index, (mode, digit))| {
            let (x, y) = nearest(first?, *mode, scene)?;
            let style = if scene.marks.mode == Some(index) {
                styles.selected_mark
            } else if scene.marks.modes_dim {
                theme.dim()
            } else {
                styles.mark
            };
            Some(Spot {
                x,
                y,
                sign: digit,
                style,
            })
        });
    let mut spots: Vec<Spot> = modes.collect();
    // If several share a cell, the lowest mode is visible.
    spots.reverse();
    let sign = if theme.glyphs() == Glyphs::Ascii {
        'X'
    } else {
        '◆'
    };
    for curve in &scene.curves {
        if let Some([x, y]) = curve.at_cursor.as_deref() {
            spots.push(Spot {
                x: *x,
                y: *y,
                sign,
                style: theme.curve(curve.colour).patch(theme.key()),
            });
        }
    }
    spots
}
