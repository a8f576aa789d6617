//! The two forms of a glTF file, `.gltf` and `.glb`, and the bytes that its
//! buffers name: in the file itself, in other files, or in the text as base64.

use std::collections::BTreeMap;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::Value;

use super::error::{MeshFileError, MeshPlace};
use super::gltf_json::Item;

const GLB: &[u8] = b"glTF";
const JSON_CHUNK: &[u8] = b"JSON";
const BINARY_CHUNK: &[u8] = b"BIN\0";

/// Opens a file beside the glTF file, by its relative path.
pub type OpenFile<'a> = dyn Fn(&str) -> Result<Vec<u8>, String> + 'a;

/// The JSON of a file, and its binary chunk if it is a `.glb` with one.
pub(super) fn split(bytes: &[u8]) -> Result<(Value, Option<&[u8]>), MeshFileError> {
    let (json, binary) = match bytes.starts_with(GLB) {
        true => glb_chunks(bytes)?,
        false => (bytes, None),
    };
    let value = serde_json::from_slice(json).map_err(|error| {
        let place = MeshPlace::Line(error.line());
        let message = format!("it is not JSON: {error}");
        MeshFileError::damaged(place, message, "expected a glTF 2.0 file, .gltf or .glb")
    })?;
    Ok((value, binary))
}

/// The JSON chunk and the binary one behind it; others are passed over, as glTF
/// demands.
fn glb_chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), MeshFileError> {
    let bad = |at: usize, message: String| {
        let help = "the file is cut off or damaged; expected glTF 2.0";
        MeshFileError::damaged(MeshPlace::Byte(at), message, help)
    };
    let word = |at: usize| {
        let word = bytes.get(at..).and_then(|rest| rest.first_chunk());
        let word = word.ok_or_else(|| bad(at, "the file ends within a header".into()));
        word.map(|&word| u32::from_le_bytes(word))
    };
    let (version, length) = (word(4)?, word(8)?);
    if version != 2 {
        return Err(bad(4, format!("the file is of version {version}")));
    }
    if length as usize != bytes.len() {
        let message = format!(
            "{length} bytes are announced, but {} are there",
            bytes.len()
        );
        return Err(bad(8, message));
    }
    let mut chunks = Vec::new();
    let mut at = 12;
    while at < bytes.len() && chunks.len() < 2 {
        let length = word(at)? as usize;
        word(at + 4)?;
        let (kind, rest) = bytes[at + 4..].split_at(4);
        let chunk = rest.get(..length).ok_or_else(|| {
            let message = format!(
                "a chunk of {length} bytes begins, but {} follow",
                rest.len()
            );
            bad(at, message)
        })?;
        chunks.push((kind, chunk));
        at += 8 + length;
    }
    match chunks[..] {
        [(JSON_CHUNK, json)] => Ok((json, None)),
        [(JSON_CHUNK, json), (kind, binary)] => {
            Ok((json, (kind == BINARY_CHUNK).then_some(binary)))
        }
        _ => Err(bad(12, "there is no JSON chunk".into())),
    }
}

/// The buffers of a file, each opened when it is first needed.
pub(super) struct Buffers<'a> {
    root: Item<'a>,
    binary: Option<&'a [u8]>,
    open: &'a OpenFile<'a>,
    opened: BTreeMap<usize, Vec<u8>>,
}

impl<'a> Buffers<'a> {
    pub fn new(root: Item<'a>, binary: Option<&'a [u8]>, open: &'a OpenFile<'a>) -> Self {
        let opened = BTreeMap::new();
        Self {
            root,
            binary,
            open,
            opened,
        }
    }

    /// The bytes of a buffer, as many as it announces.
    pub fn get(&mut self, index: usize) -> Result<&[u8], MeshFileError> {
        if !self.opened.contains_key(&index) {
            let bytes = self.open(index)?;
            self.opened.insert(index, bytes);
        }
        Ok(&self.opened[&index])
    }

    fn open(&self, index: usize) -> Result<Vec<u8>, MeshFileError> {
        let buffer = self.root.entry("buffers", index)?;
        let length = buffer.required("byteLength")?.as_index()?;
        let mut bytes = match (buffer.get("uri"), self.binary) {
            (Some(uri), _) => self.read(&uri)?,
            (None, Some(binary)) if index == 0 => binary.to_vec(),
            (None, _) => {
                return Err(buffer.unsupported(
                    "it has no \"uri\", and the file has no binary chunk for it",
                    "the file is cut off, or its buffer is compressed; export it without \
                     compression",
                ));
            }
        };
        if bytes.len() < length {
            return Err(buffer.damaged(
                format!("it announces {length} bytes, but {} are there", bytes.len()),
                "the file is cut off or damaged",
            ));
        }
        bytes.truncate(length);
        Ok(bytes)
    }

    fn read(&self, item: &Item) -> Result<Vec<u8>, MeshFileError> {
        let uri = item.as_text()?;
        if let Some(data) = uri.strip_prefix("data:") {
            let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
            let encoded = encoded.ok_or_else(|| {
                let help = "expected data:application/octet-stream;base64,...";
                item.unsupported("the data are not encoded as base64", help)
            })?;
            return BASE64_STANDARD.decode(encoded).map_err(|error| {
                let message = format!("the data are not base64: {error}");
                item.damaged(message, "the file is cut off or damaged")
            });
        }
        let path = percent_decoded(uri).filter(|path| is_relative(path));
        let path = path.ok_or_else(|| {
            let help = "expected the path of a file, relative to the glTF file";
            item.unsupported(format!("\"{uri}\" cannot be opened"), help)
        })?;
        (self.open)(&path).map_err(|error| {
            let message = format!("cannot read \"{path}\": {error}");
            item.damaged(message, "put the file beside the glTF file")
        })
    }
}

/// True if it names no scheme (`http:`, `C:`) and no root.
fn is_relative(path: &str) -> bool {
    let first = path.split(['/', '\\']).next().unwrap_or("");
    !first.is_empty() && !first.contains(':')
}

/// The text with `%20` and the like replaced; `None` if it is no text then.
fn percent_decoded(text: &str) -> Option<String> {
    let mut pieces = text.split('%');
    let mut decoded = pieces.next()?.as_bytes().to_vec();
    for piece in pieces {
        decoded.push(u8::from_str_radix(piece.get(..2)?, 16).ok()?);
        decoded.extend(&piece.as_bytes()[2..]);
    }
    String::from_utf8(decoded).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_decoded_and_must_be_relative() {
        let decoded = |text| percent_decoded(text).expect("a text");
        assert_eq!(decoded("a%20b/%C3%A9.bin"), "a b/é.bin");
        for bad in ["a%", "a%2", "a%zz", "%ff", "%é"] {
            assert_eq!(percent_decoded(bad), None, "{bad}");
        }
        assert!(is_relative("../a:b/c.bin") && is_relative("c.bin"));
        for bad in ["", "/dev/zero", "http://a/b", "C:\\a", "\\a"] {
            assert!(!is_relative(bad), "{bad}");
        }
    }
}
