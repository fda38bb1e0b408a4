//! Forces above the beam, and the marks of responses on it.

use std::collections::BTreeMap;

use super::{Focus, Picture};
use crate::model::schema::ForceKey;
use crate::model::{At, BeamMotion, Force, Group, MassMotion, Model, Place, Target};
use crate::tui::sketch::{BIMOMENT, Board, Signs, TORQUE};
use crate::tui::tree::{self, Node};

/// The indices of forces or responses by column.
type Places = BTreeMap<i32, Vec<usize>>;

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    let forces = forces(picture);
    draw_forces(picture, board, &forces);
    let probes = probes(picture);
    draw_probes(picture, board, &probes);
    draw_force_words(picture, board, &forces);
    draw_probe_words(picture, board, &probes);
}

/// A force's amplitude with its unit.
pub(super) fn amplitude(model: &Model, i: usize) -> String {
    let amplitude = Group::Force(i).parameter(ForceKey::Amplitude as usize);
    tree::value(model, Node::Parameter(amplitude))
}

/// The forces on the beam.
fn forces(picture: &Picture<'_>) -> Places {
    let forces = picture.model.forces.iter();
    on_beam(picture, forces.map(|force| Some(force.target.at())))
}

/// The responses of the beam.
fn probes(picture: &Picture<'_>) -> Places {
    let responses = picture.model.responses.iter();
    on_beam(picture, responses.map(|response| response.quantity.at()))
}

fn on_beam<'a>(picture: &Picture<'_>, all: impl Iterator<Item = Option<At<'a>>>) -> Places {
    let mut places = Places::new();
    for (i, at) in all.enumerate() {
        let place = match at {
            Some(At::Beam(place)) => Some(place),
            Some(At::Support(name)) => {
                let mut inner = picture.model.supports.inner.iter();
                let support = inner.find(|support| support.name == name);
                support.map(|support| Place::Position(support.position))
            }
            Some(At::Subsystem(_) | At::Ground) | None => None,
        };
        if let Some(place) = place {
            places.entry(picture.place(place)).or_default().push(i);
        }
    }
    places
}

/// Whether a force pushes against its direction at the moment when others are largest.
fn is_backward(force: &Force) -> bool {
    force.amplitude * force.phase.to_radians().cos() < -1e-9 * force.amplitude.abs()
}

/// The sign of a force.
fn sign(signs: &Signs, force: &Force) -> char {
    use {BeamMotion as B, MassMotion as M};
    let backward = is_backward(force);
    match &force.target {
        Target::Beam(_, B::W) | Target::Mass(_, M::Y) if backward => signs.down,
        Target::Beam(_, B::W) | Target::Mass(_, M::Y) => signs.up,
        Target::Beam(_, B::V) | Target::Mass(_, M::Z) if backward => signs.into,
        Target::Beam(_, B::V) | Target::Mass(_, M::Z) => signs.out,
        Target::Beam(_, B::Psi) | Target::Mass(_, M::Theta) => TORQUE,
        Target::Beam(_, B::WSlope | B::VSlope) => signs.moment,
        Target::Beam(_, B::PsiSlope) => BIMOMENT,
    }
}

/// Signs side by side, from the position into the beam; the selected one is at the position.
fn draw_forces(picture: &Picture<'_>, board: &mut Board<'_>, forces: &Places) {
    if !picture.rows.forces {
        return;
    }
    let mut further = Vec::new();
    for (column, members) in forces {
        let mut members = members.clone();
        members.sort_by_key(|i| picture.focus != Focus::Force(*i));
        let mut seen = Vec::new();
        for (number, i) in members.into_iter().enumerate() {
            let force = &picture.model.forces[i];
            let selected = picture.focus == Focus::Force(i);
            let style = picture.style(force.enabled, selected);
            let sign = sign(picture.signs, force);
            if number == 0 {
                board.sign([*column, picture.above(*column)], sign, style);
            } else if !seen.contains(&sign) {
                further.push((*column, sign, style));
            }
            seen.push(sign);
        }
    }
    for (column, sign, style) in further {
        // The sign at the position is always visible; the others follow if there is room.
        let inward = if column >= picture.ends[1] { -1 } else { 1 };
        for step in 1..=4 {
            let column = column + inward * step;
            if board.sign_if_free([column, picture.above(column)], sign, style) {
                break;
            }
        }
    }
    let Focus::Force(i) = picture.focus else {
        return;
    };
    if let Some((column, _)) = forces.iter().find(|(_, members)| members.contains(&i)) {
        picture.point(board, [*column, picture.above(*column)], 1);
    }
}

fn draw_force_words(picture: &Picture<'_>, board: &mut Board<'_>, forces: &Places) {
    let Some(row) = picture.rows.force_words else {
        return;
    };
    let selected = |i: &usize| picture.focus == Focus::Force(*i);
    for (column, members) in selected_first(forces, selected) {
        let on = |i: &&usize| picture.model.forces[**i].enabled;
        let acting: Vec<String> = members
            .iter()
            .filter(on)
            .map(|i| of_force(picture.model, *i, members.len() > 1))
            .collect();
        let chosen = members.iter().find(|i| selected(i));
        let mut words = Vec::new();
        let style = match chosen {
            Some(i) => {
                words.push(of_force(picture.model, *i, members.len() > 1));
                picture.theme.accent()
            }
            None => picture.style(!acting.is_empty(), false),
        };
        match acting.len() {
            0 => words.push("off".to_owned()),
            1 => words.extend(acting),
            count => words.extend([acting.join(", "), format!("{count} forces")]),
        }
        board.first_by([column, row], &words, style);
    }
}

/// The amplitude, after the direction if there are several.
fn of_force(model: &Model, i: usize, among_others: bool) -> String {
    let direction = model.forces[i].target.direction();
    if among_others {
        format!("{direction} {}", amplitude(model, i))
    } else {
        amplitude(model, i)
    }
}

/// Positions in order, the one with the selected member first.
fn selected_first(places: &Places, selected: impl Fn(&usize) -> bool) -> Vec<(i32, &Vec<usize>)> {
    let mut list: Vec<(i32, &Vec<usize>)> = places.iter().map(|(column, i)| (*column, i)).collect();
    list.sort_by_key(|(_, members)| !members.iter().any(&selected));
    list
}

/// Marks on the beam.
fn draw_probes(picture: &Picture<'_>, board: &mut Board<'_>, probes: &Places) {
    let row = picture.rows.beam;
    let selected = |i: &usize| picture.focus == Focus::Response(*i);
    for (column, members) in probes {
        let on = members.iter().any(|i| picture.model.responses[*i].enabled);
        let chosen = members.iter().any(selected);
        let sign = picture.signs.probe[usize::from(!on)];
        board.sign([*column, row], sign, picture.style(on, chosen));
    }
    if let Some((column, _)) = probes
        .iter()
        .find(|(_, members)| members.iter().any(selected))
    {
        picture.point(board, [*column, row], 1);
    }
}

/// The directions of the responses next to their marks; the selected response by its name.
fn draw_probe_words(picture: &Picture<'_>, board: &mut Board<'_>, probes: &Places) {
    if picture.rows.springs == 0 {
        return;
    }
    let responses = &picture.model.responses;
    let selected = |i: &usize| picture.focus == Focus::Response(*i);
    for (column, members) in selected_first(probes, selected) {
        let any_on = members.iter().any(|i| responses[*i].enabled);
        let mut keys: Vec<&str> = Vec::new();
        for i in members.iter().filter(|i| responses[**i].enabled || !any_on) {
            let direction = responses[*i].quantity.direction();
            keys.extend(direction.filter(|key| !keys.contains(key)));
        }
        let motions = keys.join(" ");
        let chosen = members.iter().find(|i| selected(i));
        let (words, style) = match chosen {
            Some(i) => {
                let words = vec![responses[*i].name.clone(), motions];
                (words, picture.theme.accent())
            }
            None => (vec![motions], picture.theme.dim()),
        };
        // If springs leave no room below the beam, there may be some above it.
        if !board.first_by([column, picture.springs(column).start], &words, style) {
            board.first_by([column, picture.above(column)], &words, style);
        }
    }
}

/// The signs of the forces and responses of a mass, after a blank; the selected one after a pointer.
pub(super) fn on_mass(picture: &Picture<'_>, name: &str) -> String {
    let mut signs: Vec<char> = Vec::new();
    let mut push = |sign: char, selected: bool| {
        if selected {
            signs.extend(['>', sign]);
        } else if !signs.contains(&sign) {
            signs.push(sign);
        }
    };
    for (i, force) in picture.model.forces.iter().enumerate() {
        if force.target.at() == At::Subsystem(name) {
            let selected = picture.focus == Focus::Force(i);
            push(sign(picture.signs, force), selected);
        }
    }
    for (i, response) in picture.model.responses.iter().enumerate() {
        if response.quantity.at() == Some(At::Subsystem(name)) {
            let selected = picture.focus == Focus::Response(i);
            push(
                picture.signs.probe[usize::from(!response.enabled)],
                selected,
            );
        }
    }
    if signs.is_empty() {
        String::new()
    } else {
        format!(" {}", String::from_iter(signs))
    }
}

/// The mass of the selected force or response.
pub(super) fn selected_mass<'a>(picture: &Picture<'a>) -> Option<&'a str> {
    let at = match picture.focus {
        Focus::Force(i) => picture.model.forces[i].target.at(),
        Focus::Response(i) => picture.model.responses[i].quantity.at()?,
        _ => return None,
    };
    match at {
        At::Subsystem(name) => Some(name),
        At::Beam(_) | At::Support(_) | At::Ground => None,
    }
}

/// The signs of forces and responses in the picture, and their meanings.
pub(super) fn keys(picture: &Picture<'_>) -> Vec<String> {
    let model = picture.model;
    let mut keys: Vec<String> = Vec::new();
    for force in &model.forces {
        let direction = force.target.direction();
        let backward = if is_backward(force) { "-" } else { "" };
        let key = format!("{} {backward}{direction}", sign(picture.signs, force));
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    if !model.responses.is_empty() {
        keys.push(format!("{} response", picture.signs.probe[0]));
    }
    keys
}
