//! Accessors of a glTF file: numbers in buffers.

use super::error::MeshFileError;
use super::gltf_buffer::Buffers;
use super::gltf_json::Item;

/// Numbers of an accessor, shape `(count, width)`.
pub(super) struct Numbers {
    /// How many there are for each vertex: 1, 2, 3 or 4.
    pub width: usize,
    pub values: Vec<f64>,
    /// True if they are whole numbers, not fractions of the largest.
    pub is_integer: bool,
}

/// The `componentType`.
#[derive(Clone, Copy, PartialEq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(item: &Item) -> Result<Self, MeshFileError> {
        match item.as_index()? {
            5120 => Ok(Self::I8),
            5121 => Ok(Self::U8),
            5122 => Ok(Self::I16),
            5123 => Ok(Self::U16),
            5125 => Ok(Self::U32),
            5126 => Ok(Self::F32),
            other => Err(item.invalid(
                format!("it is {other}"),
                "expected 5120, 5121, 5122, 5123, 5125 or 5126",
            )),
        }
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number in the first bytes of four.
    fn read(self, bytes: [u8; 4]) -> f64 {
        let [a, b, ..] = bytes;
        match self {
            Self::I8 => (a as i8).into(),
            Self::U8 => a.into(),
            Self::I16 => i16::from_le_bytes([a, b]).into(),
            Self::U16 => u16::from_le_bytes([a, b]).into(),
            Self::U32 => u32::from_le_bytes(bytes).into(),
            Self::F32 => f32::from_le_bytes(bytes).into(),
        }
    }

    /// The number that stands for 1 where integers are normalised.
    fn one(self) -> Option<f64> {
        match self {
            Self::I8 => Some(127.0),
            Self::U8 => Some(255.0),
            Self::I16 => Some(32767.0),
            Self::U16 => Some(65535.0),
            Self::U32 | Self::F32 => None,
        }
    }
}

/// The numbers of an accessor whose `type` is one of these.
pub(super) fn read(
    accessor: &Item,
    root: &Item,
    buffers: &mut Buffers,
    types: &[&str],
) -> Result<Numbers, MeshFileError> {
    if let Some(sparse) = accessor.get("sparse") {
        let help = "export the mesh without sparse accessors";
        return Err(sparse.unsupported("sparse accessors are not read", help));
    }
    let kind = accessor.required("type")?;
    let kind_text = kind.as_text()?;
    if !types.contains(&kind_text) {
        let help = format!("expected {}", types.join(" or "));
        return Err(kind.invalid(format!("it is {kind_text}"), &help));
    }
    let width = match kind_text {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        _ => 4,
    };
    let component = Component::of(&accessor.required("componentType")?)?;
    let is_normalized = match accessor.get("normalized") {
        Some(item) => item.as_boolean()?,
        None => false,
    };
    let one = component.one().filter(|_| is_normalized);
    let size = width * component.size();
    let (bytes, stride) = slice(accessor, root, buffers, size)?;
    let elements = bytes.chunks(stride);
    let numbers = elements.flat_map(|element| element[..size].chunks_exact(component.size()));
    let values = numbers.map(|raw| {
        let mut four = [0; 4];
        four[..raw.len()].copy_from_slice(raw);
        let number = component.read(four);
        one.map_or(number, |one| (number / one).max(-1.0))
    });
    Ok(Numbers {
        width,
        values: values.collect(),
        is_integer: component != Component::F32 && !is_normalized,
    })
}

/// The bytes from the first number to the last, and how far apart the elements
/// of `size` bytes begin. Nothing is announced that is not there.
fn slice<'b>(
    accessor: &Item,
    root: &Item,
    buffers: &'b mut Buffers,
    size: usize,
) -> Result<(&'b [u8], usize), MeshFileError> {
    let Some(view) = accessor.get("bufferView") else {
        return Err(accessor.unsupported(
            "it has no \"bufferView\"",
            "its numbers are all zero or compressed; export the mesh without compression",
        ));
    };
    let view = root.entry("bufferViews", view.as_index()?)?;
    let compression = view.get("extensions").and_then(|e| e.keys().next());
    if let Some(extension) = compression {
        let message = format!("it has the extension \"{extension}\", which is not read");
        return Err(view.unsupported(message, "export the mesh without compression"));
    }
    let number = |item: &Item, key: &str| item.get(key).map_or(Ok(0), |item| item.as_index());
    let stride = match view.get("byteStride") {
        None => size,
        Some(item) => match item.as_index()? {
            stride if stride < size => {
                let message = format!("it is {stride}, but an element takes {size} bytes");
                return Err(item.damaged(message, "expected at least that"));
            }
            stride => stride,
        },
    };
    let count = accessor.required("count")?;
    let elements = count.as_index()?;
    if elements == 0 {
        return Err(count.invalid("it is 0", "expected at least 1"));
    }
    let view_start = number(&view, "byteOffset")?;
    let view_length = view.required("byteLength")?.as_index()?;
    let offset = number(accessor, "byteOffset")?;
    let buffer = buffers.get(view.required("buffer")?.as_index()?)?;
    let within = |start: usize, length: usize, available: usize| {
        start
            .checked_add(length)
            .is_some_and(|end| end <= available)
    };
    if !within(view_start, view_length, buffer.len()) {
        return Err(view.damaged(
            format!(
                "{view_length} bytes from byte {view_start} on are announced, but the buffer has \
                 {}",
                buffer.len()
            ),
            "the file is cut off or damaged",
        ));
    }
    let length = stride.checked_mul(elements - 1);
    let length = length.and_then(|length| length.checked_add(size));
    match length.filter(|&length| within(offset, length, view_length)) {
        Some(length) => Ok((&buffer[view_start + offset..][..length], stride)),
        None => Err(accessor.damaged(
            format!(
                "{elements} elements of {size} bytes, {stride} apart from byte {offset} on, are \
                 announced, but the view has {view_length} bytes"
            ),
            "the file is cut off or damaged",
        )),
    }
}
