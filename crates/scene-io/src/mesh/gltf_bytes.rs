//! The bytes that a glTF file names: in itself, in other files, or in its text as
//! base64. Nothing is announced that is not there.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use gltf::accessor::{Accessor, Item, Iter};
use gltf::buffer::View;

use super::error::MeshFileError;
use super::gltf_file::{GltfFile, at, damaged, unsupported};

/// Opens a file beside the glTF file, by its relative path.
pub type OpenFile<'a> = dyn Fn(&str) -> Result<Vec<u8>, String> + 'a;

impl GltfFile {
    /// The elements of an accessor, of the type that it says.
    pub(super) fn elements<'s, T: Item>(
        &'s self,
        accessor: &Accessor<'s>,
        open: &OpenFile,
    ) -> Result<Iter<'s, T>, MeshFileError> {
        let place = format!("accessors[{}]", accessor.index());
        let Some(view) = accessor.view() else {
            return Err(unsupported(
                &place,
                "it has no \"bufferView\"",
                "its numbers are all zero or compressed; export the mesh without compression",
            ));
        };
        let (count, size) = (accessor.count(), size_of::<T>());
        if count == 0 {
            let place = at(&format!("{place}.count"));
            return Err(MeshFileError::invalid(
                place,
                "it is 0",
                "expected at least 1",
            ));
        }
        self.check_elements(&view, accessor.offset(), count, size, &place, open)?;
        if let Some(sparse) = accessor.sparse() {
            let (place, count) = (format!("{place}.sparse"), sparse.count());
            if count == 0 || count > accessor.count() {
                let message = format!("it replaces {count} elements of {}", accessor.count());
                return Err(damaged(&place, message));
            }
            let (indices, values) = (sparse.indices(), sparse.values());
            let size_of_index = indices.index_type().size();
            let (view, offset) = (indices.view(), indices.offset());
            self.check_elements(&view, offset, count, size_of_index, &place, open)?;
            self.check_elements(&values.view(), values.offset(), count, size, &place, open)?;
        }
        let bytes = |buffer: gltf::Buffer| Some(self.buffers[buffer.index()].get()?.as_slice());
        Ok(Iter::new(accessor.clone(), bytes).expect("all of its elements are there"))
    }

    /// Opens the buffer of elements of this size; an error at `place` if they are not all there.
    fn check_elements(
        &self,
        view: &View,
        offset: usize,
        count: usize,
        size: usize,
        place: &str,
        open: &OpenFile,
    ) -> Result<(), MeshFileError> {
        let available = self.view(view, open)?.len();
        let stride = view.stride().unwrap_or(size);
        if stride < size {
            let place = format!("bufferViews[{}].byteStride", view.index());
            let message = format!("it is {stride}, but an element takes {size} bytes");
            return Err(damaged(&place, message));
        }
        let length = stride.checked_mul(count - 1);
        let length = length.and_then(|length| length.checked_add(size));
        match length.is_some_and(|length| is_within(offset, length, available)) {
            true => Ok(()),
            false => Err(damaged(
                place,
                format!(
                    "{count} elements of {size} bytes, {stride} apart from byte {offset} on, are \
                     announced, but the view has {available} bytes"
                ),
            )),
        }
    }

    /// The bytes of a view.
    pub(super) fn view(&self, view: &View, open: &OpenFile) -> Result<&[u8], MeshFileError> {
        let place = format!("bufferViews[{}]", view.index());
        if let Some(extension) = self.keys(&format!("{place}.extensions")).next() {
            let message = format!("it has the extension \"{extension}\", which is not read");
            let help = "export the mesh without compression";
            return Err(unsupported(&place, message, help));
        }
        let (start, length) = (view.offset(), view.length());
        let buffer = self.buffer(view.buffer(), open)?;
        match is_within(start, length, buffer.len()) {
            true => Ok(&buffer[start..start + length]),
            false => Err(damaged(
                &place,
                format!(
                    "{length} bytes from byte {start} on are announced, but the buffer has {}",
                    buffer.len()
                ),
            )),
        }
    }

    /// The bytes of a buffer, as many as it announces, opened when they are first needed.
    fn buffer(&self, buffer: gltf::Buffer, open: &OpenFile) -> Result<&[u8], MeshFileError> {
        let cell = &self.buffers[buffer.index()];
        if let Some(bytes) = cell.get() {
            return Ok(bytes);
        }
        let place = format!("buffers[{}]", buffer.index());
        let mut bytes = match (buffer.source(), &self.binary) {
            (gltf::buffer::Source::Uri(uri), _) => read_uri(uri, &format!("{place}.uri"), open)?,
            (gltf::buffer::Source::Bin, Some(binary)) if buffer.index() == 0 => binary.clone(),
            (gltf::buffer::Source::Bin, _) => {
                return Err(unsupported(
                    &place,
                    "it has no \"uri\", and the file has no binary chunk for it",
                    "the file is cut off, or its buffer is compressed; export it without \
                     compression",
                ));
            }
        };
        let length = buffer.length();
        if bytes.len() < length {
            let message = format!("it announces {length} bytes, but {} are there", bytes.len());
            return Err(damaged(&place, message));
        }
        bytes.truncate(length);
        Ok(cell.get_or_init(|| bytes))
    }

    /// The bytes of the image with this index, and the ending that a file of it would have.
    pub fn image(
        &self,
        index: usize,
        open: &OpenFile,
    ) -> Result<(Vec<u8>, &'static str), MeshFileError> {
        let place = format!("images[{index}]");
        let image = &self.document.as_json().images[index];
        let bytes = match (&image.uri, image.buffer_view) {
            (Some(uri), _) => read_uri(uri, &format!("{place}.uri"), open)?,
            (None, Some(view)) => {
                let view = self.document.views().nth(view.value());
                self.view(&view.expect("indices are checked"), open)?
                    .to_vec()
            }
            (None, None) => {
                return Err(damaged(&place, "it has neither \"uri\" nor \"bufferView\""));
            }
        };
        match &bytes[..] {
            [0x89, b'P', b'N', b'G', ..] => Ok((bytes, "png")),
            [0xff, 0xd8, ..] => Ok((bytes, "jpg")),
            _ => {
                let message = "it is neither PNG nor JPEG";
                Err(unsupported(&place, message, "export images as PNG or JPEG"))
            }
        }
    }
}

/// True if so many bytes from `start` on are among those that are there.
fn is_within(start: usize, length: usize, available: usize) -> bool {
    let end = start.checked_add(length);
    end.is_some_and(|end| end <= available)
}

/// The bytes that a URI stands for. `place` is where it stands.
fn read_uri(uri: &str, place: &str, open: &OpenFile) -> Result<Vec<u8>, MeshFileError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let encoded = encoded.ok_or_else(|| {
            let help = "expected data:application/octet-stream;base64,...";
            unsupported(place, "the data are not encoded as base64", help)
        })?;
        let decoded = BASE64_STANDARD.decode(encoded);
        return decoded
            .map_err(|error| damaged(place, format!("the data are not base64: {error}")));
    }
    let path = percent_decoded(uri).filter(|path| is_relative(path));
    let path = path.ok_or_else(|| {
        let help = "expected the path of a file, relative to the glTF file";
        unsupported(place, format!("\"{uri}\" cannot be opened"), help)
    })?;
    open(&path).map_err(|error| {
        let message = format!("cannot read \"{path}\": {error}");
        MeshFileError::damaged(at(place), message, "put the file beside the glTF file")
    })
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
