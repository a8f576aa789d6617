//! A glTF file whose parts may be used: it is JSON of the right form, and all that
//! it refers to is there.
//!
//! The crate `gltf` takes for granted what its own check finds, and that check
//! itself indexes before it compares. So what it does not find is looked for first,
//! and what it finds and does no harm is passed over.

use std::cell::OnceCell;

use capwalk_math::Affine;
use gltf::json::mesh::Semantic;
use gltf::json::validation::{Checked, Error, Validate};
use gltf::json::{Path, Root};
use gltf::{Document, Glb};
use serde_json::Value;

use super::error::{MeshFileError, MeshPlace};

/// How a binary file begins.
const GLB: &[u8] = b"glTF";

/// Where sizes stand, which may have more than 32 bits.
const SIZES: [&str; 4] = ["byteLength", "byteOffset", "byteStride", "count"];

/// Parts of a file that a mesh does not need.
const BESIDE_MESHES: [&str; 6] = [
    "cameras",
    "extensions",
    "images",
    "materials",
    "samplers",
    "textures",
];

/// A file that was read, and of its buffers those that were needed so far.
#[derive(Debug)]
pub(crate) struct GltfFile {
    json: Value,
    pub document: Document,
    /// See [`Self::nodes`].
    pub(super) nodes: OnceCell<Vec<(usize, Affine)>>,
    /// How many animations it has, which are not read.
    pub animations: usize,
    /// The binary chunk.
    pub(super) binary: Option<Vec<u8>>,
    pub(super) buffers: Vec<OnceCell<Vec<u8>>>,
}

impl GltfFile {
    /// The file with these bytes; its meshes are checked, [`Self::check_rest`] checks
    /// everything else.
    pub fn parse(bytes: &[u8]) -> Result<Self, MeshFileError> {
        let (json, binary) = match bytes.starts_with(GLB) {
            true => chunks(bytes)?,
            false => (bytes.to_vec(), None),
        };
        let mut json: Value = serde_json::from_slice(&json).map_err(|error| {
            let place = MeshPlace::Line(error.line());
            let message = format!("it is not JSON: {error}");
            MeshFileError::damaged(place, message, "expected a glTF 2.0 file, .gltf or .glb")
        })?;
        tidy(&mut json, &Path::new())?;
        complete(&mut json);
        let animations = json
            .as_object_mut()
            .and_then(|root| root.remove("animations"));
        let animations = animations
            .as_ref()
            .and_then(Value::as_array)
            .map_or(0, Vec::len);
        if let Some(version) = json.pointer("/asset/version").and_then(Value::as_str)
            && !version.starts_with("2.")
        {
            let message = format!("it is \"{version}\"");
            let help = "expected a glTF 2.0 file";
            return Err(unsupported("asset.version", message, help));
        }
        let root: Root = serde_path_to_error::deserialize(&json).map_err(|error| {
            let place = error.path().to_string();
            damaged(&place, error.inner().to_string())
        })?;
        let file = Self {
            buffers: vec![OnceCell::new(); root.buffers.len()],
            document: Document::from_json_without_validation(root),
            nodes: OnceCell::new(),
            animations,
            json,
            binary,
        };
        file.check_positions()?;
        file.check(|section| !BESIDE_MESHES.contains(&section))?;
        Ok(file)
    }

    /// An error if anything is wrong in what is not a mesh.
    pub fn check_rest(&self) -> Result<(), MeshFileError> {
        self.check(|section| BESIDE_MESHES.contains(&section))
    }

    /// The check of `gltf` takes it for granted that there are the accessors of positions.
    fn check_positions(&self) -> Result<(), MeshFileError> {
        let root = self.document.as_json();
        for (m, mesh) in root.meshes.iter().enumerate() {
            for (p, primitive) in mesh.primitives.iter().enumerate() {
                let positions = primitive
                    .attributes
                    .get(&Checked::Valid(Semantic::Positions));
                if positions.is_some_and(|index| index.value() >= root.accessors.len()) {
                    let place = format!("meshes[{m}].primitives[{p}].attributes.POSITION");
                    return Err(self.fault(&place, Error::IndexOutOfBounds));
                }
            }
        }
        Ok(())
    }

    /// The first fault that `gltf` finds in some of the file's sections.
    fn check(&self, is_asked: impl Fn(&str) -> bool) -> Result<(), MeshFileError> {
        let root = self.document.as_json();
        let mut first = None;
        root.validate(root, Path::new, &mut |path, error| {
            let place = path().0.replace("[\"", ".").replace("\"]", "");
            // What `gltf` calls it.
            let place = place.replace("khrLightsPunctual", "KHR_lights_punctual");
            let section = place.split(['.', '[']).next().unwrap_or_default();
            if first.is_none() && is_asked(section) && !is_harmless(&place, error) {
                first = Some(self.fault(&place, error));
            }
        });
        first.map_or(Ok(()), Err)
    }

    /// A fault in words.
    fn fault(&self, place: &str, fault: Error) -> MeshFileError {
        let found = self.json.pointer(&pointer(place)).map(Value::to_string);
        let message = match (fault, found) {
            (Error::IndexOutOfBounds, Some(index)) => {
                format!("it is {index}, but there is no such entry")
            }
            (Error::Missing, Some(_)) => "a part of it is missing".to_owned(),
            (_, None) => "it is missing".to_owned(),
            (_, Some(found)) => format!("it is {}", shortened(found)),
        };
        let help = "expected what glTF 2.0 allows; the file is cut off or damaged";
        MeshFileError::damaged(at(place), message, help)
    }

    /// The numbers at a place, as precise as the file has them, where `gltf` has single
    /// precision; `default` if there are none.
    pub fn numbers<const N: usize>(
        &self,
        place: &str,
        default: [f64; N],
    ) -> Result<[f64; N], MeshFileError> {
        let Some(found) = self.value(place) else {
            return Ok(default);
        };
        let list = found
            .as_array()
            .map_or(std::slice::from_ref(found), Vec::as_slice);
        let numbers: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
        let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
        numbers.ok_or_else(|| {
            let message = format!("it is {}", shortened(found.to_string()));
            let help = format!("expected {N} numbers");
            MeshFileError::invalid(at(place), message, help)
        })
    }

    /// The number at a place, see [`Self::numbers`].
    pub fn number(&self, place: &str, default: f64) -> Result<f64, MeshFileError> {
        self.numbers(place, [default]).map(|[number]| number)
    }

    /// What stands at a place such as `meshes[0].primitives[2].mode`.
    pub fn value(&self, place: &str) -> Option<&Value> {
        let found = self.json.pointer(&pointer(place));
        found.filter(|value| !value.is_null())
    }

    /// The names of the properties of an object; none if it is not there.
    pub fn keys(&self, place: &str) -> impl Iterator<Item = &str> {
        let object = self.value(place).and_then(Value::as_object);
        let keys = object.into_iter().flat_map(|object| object.keys());
        keys.map(String::as_str)
    }
}

/// The text and the binary chunk of a `.glb`.
fn chunks(bytes: &[u8]) -> Result<(Vec<u8>, Option<Vec<u8>>), MeshFileError> {
    let bad = |place: MeshPlace, message: String| {
        let help = "the file is cut off or damaged; expected glTF 2.0";
        MeshFileError::damaged(place, message, help)
    };
    // `gltf` subtracts the length of the header from that of the file.
    let length = bytes.get(8..).and_then(|rest| rest.first_chunk());
    let length = length.map(|&length| u32::from_le_bytes(length) as usize);
    if length != Some(bytes.len()) || bytes.len() < 12 {
        let announced = length.unwrap_or(0);
        let message = format!(
            "{announced} bytes are announced, but {} are there",
            bytes.len()
        );
        return Err(bad(MeshPlace::Byte(8), message));
    }
    let whole = Glb::from_slice(bytes);
    let whole = whole.map_err(|error| bad(MeshPlace::File, format!("its chunks: {error}")))?;
    Ok((
        whole.json.into_owned(),
        whole.bin.map(|bin| bin.into_owned()),
    ))
}

/// Brings numbers into the form that `gltf` reads: some writers give whole ones a
/// decimal point. Those of more than 32 bits that are no sizes, of which it would drop
/// some, are an error.
fn tidy(value: &mut Value, path: &Path) -> Result<(), MeshFileError> {
    match value {
        Value::Number(number) => {
            if let Some(x) = number.as_f64()
                && x.fract() == 0.0
                && (0.0..9e15).contains(&x)
                && x.is_sign_positive()
            {
                *number = (x as u64).into();
            }
            let key = path.0.rsplit('.').next().unwrap_or_default();
            match number.as_u64() {
                Some(large) if large > u32::MAX.into() && !SIZES.contains(&key) => {
                    let message = format!("it is {large}");
                    let help = "expected a number of 32 bits";
                    Err(MeshFileError::invalid(at(&path.0), message, help))
                }
                _ => Ok(()),
            }
        }
        Value::Array(items) => {
            let mut items = items.iter_mut().enumerate();
            items.try_for_each(|(index, item)| tidy(item, &path.index(index)))
        }
        Value::Object(object) => {
            // Whatever an application says to itself.
            object.remove("extras");
            let mut entries = object.iter_mut();
            entries.try_for_each(|(key, item)| tidy(item, &path.field(key)))
        }
        Value::Null | Value::Bool(_) | Value::String(_) => Ok(()),
    }
}

/// Adds what may be left out of a file, which `gltf` does not know: nodes of a scene, and all scenes.
fn complete(json: &mut Value) {
    match json.get_mut("scenes").and_then(Value::as_array_mut) {
        Some(scenes) if !scenes.is_empty() => {
            let scenes = scenes.iter_mut().filter_map(Value::as_object_mut);
            scenes.for_each(|scene| {
                scene
                    .entry("nodes")
                    .or_insert_with(|| Value::Array(Vec::new()));
            });
        }
        // Whichever would be shown is not there.
        _ => drop(json.as_object_mut().and_then(|root| root.remove("scene"))),
    }
}

/// What `gltf` refuses and is legal, has no effect here, or is refused where it is used.
fn is_harmless(place: &str, fault: Error) -> bool {
    let last = place.rsplit('.').next().unwrap_or_default();
    // A name of an attribute stands in the place of what it stands for.
    let is_unknown_attribute = last.starts_with('<');
    is_unknown_attribute
        || fault == Error::Unsupported
        || matches!(last, "min" | "max" | "byteStride" | "target" | "POSITION")
            && fault != Error::IndexOutOfBounds
        || fault == Error::Missing && matches!(last, "bufferView" | "source")
}

/// The JSON pointer of a place such as `meshes[0].primitives[2].mode`.
fn pointer(place: &str) -> String {
    let place = place.replace(']', "").replace(['.', '['], "/");
    format!("/{place}")
}

/// A place as errors have it.
pub(super) fn at(place: &str) -> MeshPlace {
    match place.is_empty() || place == "." {
        true => MeshPlace::File,
        false => MeshPlace::Json(place.to_owned()),
    }
}

/// An error at a place: the file is incomplete.
pub(super) fn damaged(place: &str, message: impl Into<String>) -> MeshFileError {
    MeshFileError::damaged(at(place), message, "the file is cut off or damaged")
}

/// An error at a place: a part of glTF that is not read.
pub(crate) fn unsupported(place: &str, message: impl Into<String>, help: &str) -> MeshFileError {
    MeshFileError::unsupported(at(place), message, help)
}

/// A text that was found, not too long for a message.
fn shortened(mut found: String) -> String {
    const LONGEST: usize = 40;
    if let Some((end, _)) = found.char_indices().nth(LONGEST) {
        found.truncate(end);
        found += " ...";
    }
    found
}
