//! The joints: a sign on the beam at each.

use super::{Focus, Picture, named_motions};
use crate::model::{Joint, Link};
use crate::tui::sketch::Board;

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    for (index, joint) in picture.model.joints.iter().enumerate() {
        let at = [picture.column(joint.position), picture.rows.beam];
        let is_selected = picture.focus == Focus::Joint(index);
        board.sign(at, sign(picture, joint), picture.style(true, is_selected));
        if is_selected {
            picture.point(board, at, 1);
        }
    }
}

fn is_sprung(joint: &Joint) -> bool {
    let mut links = joint.links.iter();
    links.any(|link| matches!(link, Link::Elastic(_)))
}

fn sign(picture: &Picture<'_>, joint: &Joint) -> char {
    picture.signs.joint[usize::from(is_sprung(joint))]
}

/// The motions that a joint does not hold together: the free ones and those on springs.
pub(super) fn words(joint: &Joint) -> Vec<String> {
    let free = named_motions(|motion| joint[motion] == Link::Free, "free");
    let sprung = named_motions(|motion| matches!(joint[motion], Link::Elastic(_)), "sprung");
    free.into_iter().chain(sprung).collect()
}

/// The signs of the joints that are in the picture, and their meanings.
pub(super) fn keys(picture: &Picture<'_>) -> Vec<String> {
    let with = |sprung: bool, word: &str| {
        let mut joints = picture.model.joints.iter();
        let first = joints.find(|joint| is_sprung(joint) == sprung);
        first.map(|joint| format!("{} {word}", sign(picture, joint)))
    };
    let keys = [with(false, "hinge"), with(true, "coupling")];
    keys.into_iter().flatten().collect()
}
