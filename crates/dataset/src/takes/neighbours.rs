//! Column names that have a meaning by their neighbours alone, such as `tx`, `w` of `w,i,j,k`, or `X1`.

use std::collections::BTreeSet;

use crate::takes::columns::{Column, JOINTS, Quantity, at_joint, without_unit};
use crate::takes::unit::LengthUnit;

/// Ends of names of a quaternion, scalar part first, beside positions of the same body.
const SCALAR_FIRST: [&str; 4] = ["w", "i", "j", "k"];
/// Ends of names of a quaternion in the order of its components.
const BY_AXES: [&str; 4] = ["w", "x", "y", "z"];
const AXES: [&str; 3] = ["x", "y", "z"];
/// Words before the axis, of a position and of an attitude, in the messages of ROS and of game engines.
const PAIRS: [(&str, &str); 3] = [
    ("position", "orientation"),
    ("translation", "rotation"),
    ("position", "rotation"),
];
/// Names of Euler angles.
const EULER: [&str; 3] = ["roll", "pitch", "yaw"];

/// A name without unit, in lower case, before and after its last joint.
fn taken_apart(name: &str) -> (String, String) {
    let (label, last) = at_joint(without_unit(name.trim()).0);
    (label.to_owned(), last.to_ascii_lowercase())
}

/// Columns of a header, also those that have a meaning by their neighbours alone.
pub(crate) fn columns_of(names: impl IntoIterator<Item = impl AsRef<str>>) -> Vec<Column> {
    let names = names.into_iter().map(|name| name.as_ref().to_owned());
    let names: Vec<String> = names.collect();
    let mut columns: Vec<Column> = names.iter().map(|name| Column::parse(name)).collect();
    read(&names, &mut columns);
    columns
}

/// Gives columns that have no meaning of their own the one that all of their group have together.
fn read(names: &[String], columns: &mut [Column]) {
    let apart: Vec<(String, String)> = names.iter().map(|name| taken_apart(name)).collect();
    let place = |label: &str, last: &str| {
        let is_own = |own: &(String, String)| own.0 == label && own.1 == last;
        apart.iter().position(is_own)
    };
    let labels: BTreeSet<&str> = apart.iter().map(|(label, _)| label.as_str()).collect();
    for label in labels {
        let group = |ends: &[&str]| -> Option<Vec<usize>> {
            ends.iter().map(|end| place(label, end)).collect()
        };
        let has_axes = group(&AXES).is_some();
        if !has_axes && let Some(places) = group(&["tx", "ty", "tz"]) {
            position(names, columns, &places, label);
        }
        if has_axes && let Some(places) = group(&SCALAR_FIRST) {
            attitude(columns, &places, label);
        }
        let own = |word: &str| {
            let before = label.len().checked_sub(word.len())?;
            let matches = label.get(before..)?.eq_ignore_ascii_case(word);
            let is_whole = before == 0 || label[..before].ends_with(JOINTS);
            (matches && is_whole).then(|| &label[..before])
        };
        for (of_position, of_attitude) in PAIRS {
            let Some(before) = own(of_attitude) else {
                continue;
            };
            let is_beside = |other: &&(String, String)| {
                let word = other.0.strip_prefix(before);
                word.is_some_and(|word| word.eq_ignore_ascii_case(of_position))
            };
            let beside = apart.iter().find(is_beside).map(|(label, _)| label);
            let places: Option<Vec<usize>> = beside.and_then(|label| {
                let all = AXES.iter().map(|axis| place(label, axis));
                all.collect()
            });
            if let (Some(positions), Some(quaternion)) = (places, group(&BY_AXES)) {
                let body = before.trim_end_matches(JOINTS);
                position(names, columns, &positions, body);
                attitude(columns, &quaternion, body);
            }
        }
        let mut numbers: Vec<&str> = apart
            .iter()
            .filter(|own| own.0 == label)
            .filter_map(|own| own.1.strip_prefix('x'))
            .collect();
        numbers.retain(|own| !own.is_empty() && own.bytes().all(|b| b.is_ascii_digit()));
        for number in numbers {
            let ends = AXES.map(|axis| format!("{axis}{number}"));
            if let Some(places) = group(&ends.each_ref().map(String::as_str)) {
                let name = [label, number].join(if label.is_empty() { "" } else { " " });
                position(names, columns, &places, &name);
            }
        }
    }
}

/// Makes columns the coordinates x, y and z of `label`, in the units that their names state.
fn position(names: &[String], columns: &mut [Column], places: &[usize], label: &str) {
    for (axis, &place) in places.iter().enumerate() {
        let unit = without_unit(names[place].trim()).1;
        if unit.is_some_and(|unit| !LengthUnit::is_whole_name(unit)) {
            continue;
        }
        columns[place] = Column {
            label: label.to_owned(),
            quantity: Quantity::Coordinate(axis, unit.and_then(LengthUnit::parse)),
        };
    }
}

/// Makes columns the components of the quaternion of `label`.
fn attitude(columns: &mut [Column], places: &[usize], label: &str) {
    for (component, &place) in places.iter().enumerate() {
        columns[place] = Column {
            label: label.to_owned(),
            quantity: Quantity::Quaternion(component),
        };
    }
}

/// Body of the Euler angle that a column is, as in `disc_roll_deg` or `Yaw (rad)`; `None` for another column.
pub(super) fn euler(name: &str) -> Option<String> {
    let lower = name.trim().to_ascii_lowercase();
    let bare = without_unit(&lower).0;
    let cut = ["_deg", "_rad", " deg", " rad"];
    let bare = cut
        .iter()
        .find_map(|unit| bare.strip_suffix(unit))
        .unwrap_or(bare);
    let (label, last) = at_joint(bare);
    EULER.contains(&last).then(|| label.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use Quantity::{Coordinate, Other, Quaternion};

    fn read(header: &str) -> Vec<(String, Quantity)> {
        let columns = columns_of(header.split(','));
        let each = columns.into_iter();
        each.map(|own| (own.label, own.quantity)).collect()
    }

    #[test]
    fn groups_of_names_have_a_meaning() {
        let own = |label: &str, quantity| (label.to_owned(), quantity);
        let pose = |label: &str, order: [usize; 4]| {
            let axes = (0..3).map(|axis| own(label, Coordinate(axis, None)));
            let parts = order.into_iter().map(|part| own(label, Quaternion(part)));
            axes.chain(parts).collect::<Vec<_>>()
        };
        assert_eq!(read("tx,ty,tz,qx,qy,qz,qw"), pose("", [1, 2, 3, 0]));
        assert_eq!(read("x,y,z,w,i,j,k"), pose("", [0, 1, 2, 3]));
        let ros = "f.pose.position.x,f.pose.position.y,f.pose.position.z,f.pose.orientation.x,\
            f.pose.orientation.y,f.pose.orientation.z,f.pose.orientation.w";
        assert_eq!(read(ros), pose("f.pose", [1, 2, 3, 0]));
        let points = read("X1,Y1,Z1,X12 (m),Y12 (m),Z12 (m)");
        assert_eq!(points[1], own("1", Coordinate(1, None)));
        assert_eq!(points[5], own("12", Coordinate(2, Some(LengthUnit::Metre))));
    }

    #[test]
    fn a_group_with_a_part_missing_has_none() {
        for header in ["w,i,j,k", "X1,Y1", "tx,ty", "x1"] {
            let all = read(header).into_iter().all(|(_, own)| own == Other);
            assert!(all, "{header}");
        }
        let torques = read("x,y,z,tx,ty,tz");
        assert!(torques[3..].iter().all(|own| own.1 == Other));
        assert_eq!(read("position_x")[0].0, "position");
        assert_eq!(euler("disc_Roll_deg").as_deref(), Some("disc"));
        assert_eq!(euler("Yaw (rad)").as_deref(), Some(""));
        assert_eq!(euler("roller"), None);
    }
}
