//! Files for Mitsuba 0.x and 1.x, brought to the names of 2 and 3: what
//! Mitsuba's loader does for versions below 2.0, and what it leaves to others
//! (`ldrfilm`, `highQualityEdges`, `<lookAt>`, filters and `gamma` of bitmaps, `extEta` of metals).

use crate::texts::Span;
use crate::xml::{Attribute, Element};

/// What was renamed in one file.
#[derive(Debug)]
pub(crate) struct Upgraded {
    /// Where the file says its version.
    pub span: Span,
    /// A warning about it.
    pub message: String,
}

/// Tone mapping and file formats of `ldrfilm`. Images are written as linear
/// numbers; previews have their own exposure.
const OF_LDRFILM: [&str; 7] = [
    "file_format",
    "gamma",
    "exposure",
    "key",
    "burn",
    "tonemap_method",
    "label",
];

/// How bitmaps are filtered where they are small in the image, and kept in memory. Here, as in
/// Mitsuba 3, all texels under a pixel count by the pixel's samples.
const OF_BITMAP: [&str; 2] = ["max_anisotropy", "cache"];

/// Offsets and scales of texture coordinates, and what they became.
const UV_NAMES: [(&str, &str, &str); 4] = [
    ("uoffset", "translate", "x"),
    ("voffset", "translate", "y"),
    ("uscale", "scale", "x"),
    ("vscale", "scale", "y"),
];

/// Upgrades the elements of a file, before anything else is done with them.
pub(crate) fn upgrade(root: &mut Element, version: &Attribute) -> Upgraded {
    let mut changes = Vec::new();
    for child in &mut root.children {
        element(child, &mut changes);
    }
    changes.sort();
    changes.dedup();
    let changes = match changes.is_empty() {
        true => "nothing had to be renamed".to_owned(),
        false => changes.join(", "),
    };
    Upgraded {
        span: version.value_span,
        message: format!(
            "the file is for Mitsuba {}; it is read as one for version 3 ({changes})",
            version.value
        ),
    }
}

fn element(it: &mut Element, changes: &mut Vec<String>) {
    // Names of parameters are the file's own.
    let has_property_name = it.tag != "default";
    for attribute in &mut it.attributes {
        if attribute.name == "name" && has_property_name {
            rename(&mut attribute.value, &upgraded_name, changes);
        }
    }
    if it.tag == "lookAt" {
        rename(&mut it.tag, &str::to_lowercase, changes);
    }
    for child in &mut it.children {
        element(child, changes);
    }
    let plugin = it.attribute("type").map(|plugin| plugin.value.clone());
    match (it.tag.as_str(), plugin.as_deref()) {
        ("bsdf", Some("diffuse")) => {
            rename_property(it, "diffuse_reflectance", "reflectance", changes);
        }
        ("film", plugin) => {
            if plugin == Some("ldrfilm") {
                let plugin = it.attributes.iter_mut().find(|a| a.name == "type");
                let plugin = plugin.expect("its value has been looked at");
                rename(&mut plugin.value, &|_| "hdrfilm".into(), changes);
                leave_out(it, |name, _| OF_LDRFILM.contains(&name), changes);
            }
            rename_property(it, "high_quality_edges", "sample_border", changes);
        }
        ("bsdf", Some("conductor" | "roughconductor")) => {
            leave_out(
                it,
                |name, value| name == "ext_eta" && is_air(value),
                changes,
            );
        }
        ("texture", plugin) => {
            if plugin == Some("bitmap") {
                bitmap(it, changes);
            }
            uv_transform(it, changes);
        }
        _ => {}
    }
}

/// Renames the properties of an element that have a name.
fn rename_property(it: &mut Element, old: &str, new: &str, changes: &mut Vec<String>) {
    for child in &mut it.children {
        let names = child.attributes.iter_mut().filter(|a| a.name == "name");
        for name in names.filter(|name| name.value == old) {
            rename(&mut name.value, &|_| new.into(), changes);
        }
    }
}

/// Leaves out the properties with such a name and value.
fn leave_out(it: &mut Element, which: impl Fn(&str, &str) -> bool, changes: &mut Vec<String>) {
    it.children.retain(|child| {
        let text = |name| child.attribute(name).map_or("", |a| a.value.as_str());
        let name = text("name");
        let is_kept = !which(name, text("value"));
        if !is_kept {
            changes.push(format!("{name} left out"));
        }
        is_kept
    });
}

/// True for what is around metals in Mitsuba 3, up to 0.03 %.
fn is_air(index: &str) -> bool {
    let is_number = || {
        index
            .parse()
            .is_ok_and(|x: f64| (1.0..=1.000277).contains(&x))
    };
    matches!(index, "air" | "vacuum") || is_number()
}

/// The filters that blur, and `gamma` where it is that of linear numbers or of sRGB.
fn bitmap(it: &mut Element, changes: &mut Vec<String>) {
    leave_out(it, |name, _| OF_BITMAP.contains(&name), changes);
    for child in &mut it.children {
        let named = |wanted: &str| child.attribute("name").is_some_and(|a| a.value == wanted);
        let (is_filter, is_gamma) = (named("filter_type"), named("gamma"));
        let Some(value) = child.attributes.iter_mut().find(|a| a.name == "value") else {
            continue;
        };
        if is_filter && matches!(value.value.as_str(), "trilinear" | "ewa") {
            rename(&mut value.value, &|_| "bilinear".into(), changes);
        }
        let raw = match value.value.parse::<f64>() {
            Ok(1.0) if is_gamma => "true",
            Ok(-1.0) if is_gamma => "false",
            _ => continue,
        };
        changes.push(format!("gamma {} is now raw {raw}", value.value));
        value.value = raw.into();
        child.tag = "boolean".into();
        let name = child.attributes.iter_mut().find(|a| a.name == "name");
        name.expect("it is called gamma").value = "raw".into();
    }
}

fn rename(text: &mut String, new: &dyn Fn(&str) -> String, changes: &mut Vec<String>) {
    let renamed = new(text);
    if renamed != *text {
        changes.push(format!("{text} is now {renamed}"));
        *text = renamed;
    }
}

/// `toWorld` as `to_world`, `intIOR` as `int_ior`: an underscore where small
/// letters end, and no capitals behind it.
pub(crate) fn upgraded_name(name: &str) -> String {
    let mut result = String::with_capacity(name.len() + 4);
    let mut chars = name.chars().peekable();
    let mut last_is_small = false;
    while let Some(c) = chars.next() {
        if last_is_small && c.is_ascii_uppercase() {
            result.push('_');
            result.push(c.to_ascii_lowercase());
            while let Some(next) = chars.next_if(char::is_ascii_uppercase) {
                result.push(next.to_ascii_lowercase());
            }
            last_is_small = false;
        } else {
            result.push(c);
            last_is_small = c.is_ascii_lowercase();
        }
    }
    result
}

/// `uoffset`, `vscale` and so on as a `to_uv`: first the offset, then the scale.
fn uv_transform(texture: &mut Element, changes: &mut Vec<String>) {
    let mut steps: Vec<Element> = Vec::new();
    let mut span = None;
    for (old, tag, axis) in UV_NAMES {
        let is_old = |child: &Element| child.attribute("name").is_some_and(|n| n.value == old);
        let Some(place) = texture.children.iter().position(is_old) else {
            continue;
        };
        let child = texture.children.remove(place);
        span = span.or(Some(child.span));
        changes.push(format!("{old} is now in to_uv"));
        // Without a value it stays wrong, at its place.
        let Some(value) = child.attribute("value") else {
            texture.children.insert(place, child);
            continue;
        };
        let step = Attribute {
            name: axis.into(),
            ..value.clone()
        };
        match steps.iter_mut().find(|step| step.tag == tag) {
            Some(known) => known.attributes.push(step),
            None => steps.push(Element {
                tag: tag.into(),
                span: child.span,
                attributes: vec![step],
                children: Vec::new(),
            }),
        }
    }
    let Some(span) = span.filter(|_| !steps.is_empty()) else {
        return;
    };
    texture.children.push(Element {
        tag: "transform".into(),
        span,
        attributes: vec![Attribute {
            name: "name".into(),
            value: "to_uv".into(),
            name_span: span,
            value_span: span,
        }],
        children: steps,
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As Mitsuba's `camel_to_underscore_case`.
    #[test]
    fn names_in_camel_case() {
        for (old, new) in [
            ("toWorld", "to_world"),
            ("intIOR", "int_ior"),
            ("sampleCount", "sample_count"),
            ("cropOffsetX", "crop_offset_x"),
            ("alphaU", "alpha_u"),
            ("to_world", "to_world"),
            ("IOR", "IOR"),
            ("aBCd", "a_bcd"),
            ("", ""),
        ] {
            assert_eq!(upgraded_name(old), new);
        }
    }
}
