//! The header of a PLY file: which elements follow, and how they are written.

use super::error::{MeshFileError, MeshPlace};

/// Elements and properties of a file, at most: each is compared with all before. Clouds of
/// Gaussians, which have many, have 62 properties.
const MOST_NAMES: usize = 1024;

/// How the body is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// The type of a property or of the items of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    /// Bytes in a binary body.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    pub fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    fn parse(name: &str, line: usize) -> Result<Self, MeshFileError> {
        Ok(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "long" | "int64" => Self::I64,
            "ulong" | "uint64" => Self::U64,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => {
                return Err(MeshFileError::damaged(
                    MeshPlace::Line(line),
                    format!("unknown type \"{name}\""),
                    "expected char, uchar, short, ushort, int, uint, float or double",
                ));
            }
        })
    }
}

/// What each element has: a number, or a list of numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlyProperty {
    pub name: String,
    /// The type of the length, for lists.
    pub length: Option<Scalar>,
    pub scalar: Scalar,
}

/// A kind of element, such as `vertex`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlyElement {
    pub name: String,
    pub count: u64,
    pub properties: Vec<PlyProperty>,
}

impl PlyElement {
    /// Index of the property with this name.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.properties.iter().position(|p| p.name == name)
    }

    /// The least number of bytes that one of these takes in the body.
    pub fn least_size(&self, format: Encoding) -> usize {
        let sizes = self.properties.iter().map(|property| match format {
            // A digit and a separator.
            Encoding::Ascii => 2,
            _ => property.length.unwrap_or(property.scalar).size(),
        });
        sizes.sum()
    }
}

/// The header and where the body begins.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlyHeader {
    pub format: Encoding,
    pub elements: Vec<PlyElement>,
    pub body: usize,
    /// Lines of the header, for the places of messages about the body.
    pub lines: usize,
}

pub(super) fn parse(bytes: &[u8]) -> Result<PlyHeader, MeshFileError> {
    let mut format = None;
    let mut elements: Vec<PlyElement> = Vec::new();
    let mut names = 0;
    let mut position = 0;
    for line in 1.. {
        let Some(length) = bytes[position..].iter().position(|&b| b == b'\n') else {
            let help = "expected a header that ends with end_header";
            let message = match line {
                1 => "the file is not a PLY file",
                _ => "the file ends within its header",
            };
            return Err(MeshFileError::damaged(MeshPlace::Line(line), message, help));
        };
        let text = String::from_utf8_lossy(&bytes[position..position + length]);
        position += length + 1;
        let words: Vec<&str> = text.split_whitespace().collect();
        let bad = |help: &str| {
            MeshFileError::damaged(
                MeshPlace::Line(line),
                format!("the header has \"{}\"", text.trim()),
                help,
            )
        };
        if let ["element" | "property", ..] = words[..] {
            names += 1;
        }
        if names > MOST_NAMES {
            return Err(MeshFileError::damaged(
                MeshPlace::Line(line),
                format!("the header has more than {MOST_NAMES} elements and properties"),
                "remove those that are not used",
            ));
        }
        match (line, &words[..]) {
            (1, ["ply"]) => {}
            (1, _) => {
                let help = "expected \"ply\" in the first line";
                return Err(MeshFileError::damaged(
                    MeshPlace::Line(1),
                    "the file is not a PLY file",
                    help,
                ));
            }
            (_, [] | ["comment", ..] | ["obj_info", ..]) => {}
            (_, ["format", kind, "1.0"]) if format.is_none() => {
                format = Some(match *kind {
                    "ascii" => Encoding::Ascii,
                    "binary_little_endian" => Encoding::LittleEndian,
                    "binary_big_endian" => Encoding::BigEndian,
                    _ => {
                        return Err(bad(
                            "expected ascii, binary_little_endian or binary_big_endian",
                        ));
                    }
                });
            }
            (_, ["format", ..]) => return Err(bad("expected one format, of version 1.0")),
            (_, ["element", name, count]) => {
                if elements.iter().any(|e| e.name == *name) {
                    return Err(bad("expected each element once"));
                }
                elements.push(PlyElement {
                    name: (*name).into(),
                    count: count.parse().map_err(|_| bad("expected a count"))?,
                    properties: Vec::new(),
                });
            }
            (_, ["property", definition @ ..]) => {
                let property = match definition {
                    ["list", length, scalar, name] => PlyProperty {
                        name: (*name).into(),
                        length: Some(Scalar::parse(length, line)?),
                        scalar: Scalar::parse(scalar, line)?,
                    },
                    [scalar, name] => PlyProperty {
                        name: (*name).into(),
                        length: None,
                        scalar: Scalar::parse(scalar, line)?,
                    },
                    _ => return Err(bad("expected property TYPE NAME or list TYPE TYPE NAME")),
                };
                if property.length.is_some_and(|length| !length.is_integer()) {
                    return Err(bad("expected an integer type for the length of a list"));
                }
                let element = elements
                    .last_mut()
                    .ok_or_else(|| bad("expected an element before its properties"))?;
                if element.position(&property.name).is_some() {
                    return Err(bad("expected each property once"));
                }
                element.properties.push(property);
            }
            (_, ["end_header"]) => {
                let format = format.ok_or_else(|| bad("expected a format before it"))?;
                return Ok(PlyHeader {
                    format,
                    elements,
                    body: position,
                    lines: line,
                });
            }
            _ => {
                return Err(bad(
                    "expected format, element, property, comment or end_header",
                ));
            }
        }
    }
    unreachable!("a file has fewer lines than there are numbers")
}
