//! Numbers that a PLY file gives besides positions: which of them belong
//! together, and what Mitsuba calls them.

use super::ply_header::PlyElement;

/// Properties that are one attribute.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Group {
    /// `vertex_color`, `face_heat` ...
    pub name: String,
    /// Indices of its properties; 1 or 3.
    pub properties: Vec<usize>,
    /// True if they are whole numbers.
    pub is_integer: bool,
}

/// Names that are no attributes.
const RESERVED: [&str; 10] = [
    "x",
    "y",
    "z",
    "nx",
    "ny",
    "nz",
    "texture_u",
    "texture_v",
    "vertex_indices",
    "vertex_index",
];

/// Endings by which neighbours are put together, in their order.
const ENDINGS: [[&str; 4]; 4] = [
    ["x", "y", "z", "w"],
    ["r", "g", "b", "a"],
    ["0", "1", "2", "3"],
    ["1", "2", "3", "4"],
];
const COLOUR_ENDINGS: usize = 1;

/// The attributes of an element `kind` (`vertex` or `face`), by Mitsuba's rules:
/// `r g b` (or `red green blue`) are `<kind>_color`; neighbours `p_x p_y p_z` (or
/// `0 1 2`, `1 2 3`) are `<kind>_p`; `p_r p_g p_b` are `<kind>_p_color`. A single
/// `p_x` (`p_r`, `p_0`, `p_1`) has one channel. Other names and numbers of
/// channels are no attributes, in Mitsuba neither.
pub(super) fn groups(element: &PlyElement, kind: &str) -> Vec<Group> {
    let mut groups = Vec::new();
    let is_integer = |properties: &[usize]| {
        let mut scalars = properties.iter().map(|&i| element.properties[i].scalar);
        scalars.any(|scalar| scalar.is_integer())
    };
    for names in [["r", "g", "b"], ["red", "green", "blue"]] {
        if let [Some(r), Some(g), Some(b)] = names.map(|name| element.position(name)) {
            let properties = vec![r, g, b];
            groups.push(Group {
                name: format!("{kind}_color"),
                is_integer: is_integer(&properties),
                properties,
            });
            break;
        }
    }
    let parts = |i: usize| {
        let property = element.properties.get(i)?;
        if property.length.is_some() || RESERVED.contains(&property.name.as_str()) {
            return None;
        }
        property.name.rsplit_once('_')
    };
    let mut next = 0;
    while next < element.properties.len() {
        let first = next;
        next += 1;
        let Some((prefix, ending)) = parts(first) else {
            continue;
        };
        let Some(kind_of_ending) = ENDINGS.iter().position(|e| e[0] == ending) else {
            continue;
        };
        let endings = ENDINGS[kind_of_ending];
        while next - first < endings.len() && parts(next) == Some((prefix, endings[next - first])) {
            next += 1;
        }
        let properties: Vec<usize> = (first..next).collect();
        if !matches!(properties.len(), 1 | 3) {
            continue;
        }
        let colour = if kind_of_ending == COLOUR_ENDINGS {
            "_color"
        } else {
            ""
        };
        groups.push(Group {
            name: format!("{kind}_{prefix}{colour}"),
            is_integer: is_integer(&properties),
            properties,
        });
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::super::ply_header;
    use super::*;

    fn named(properties: &str) -> Vec<(String, Vec<usize>)> {
        let lines = properties
            .split(' ')
            .map(|p| format!("property float {p}\n"));
        let lines: String = lines.collect();
        let text = format!("ply\nformat ascii 1.0\nelement vertex 0\n{lines}end_header\n");
        let header = ply_header::parse(text.as_bytes()).expect("a header");
        let groups = groups(&header.elements[0], "vertex");
        groups.into_iter().map(|g| (g.name, g.properties)).collect()
    }

    #[test]
    fn neighbours_with_one_prefix_belong_together() {
        let owned = |name: &str, properties: &[usize]| (name.to_owned(), properties.to_vec());
        assert_eq!(
            named("x y z red green blue"),
            [owned("vertex_color", &[3, 4, 5])]
        );
        assert_eq!(
            named("x y z b_x b_y b_z c_0 d_r d_g d_b"),
            [
                owned("vertex_b", &[3, 4, 5]),
                owned("vertex_c", &[6]),
                owned("vertex_d_color", &[7, 8, 9])
            ]
        );
        // Two or four channels, names without an ending, texture coordinates.
        assert_eq!(named("x y z a_x a_y heat texture_u texture_v"), []);
        assert_eq!(named("x y z a_1 a_2 a_3 a_4 b_3"), []);
    }
}
