//! NPY files: one array of numbers, with a line of Python before it that says which.
//!
//! `npyz` reads both, but takes exponential time for nested brackets in that line, and
//! panics where the product of a shape overflows. So the line is held to the form that
//! NumPy writes for plain arrays before the library sees it.

use std::io::{Chain, Cursor, Read};

use npyz::NpyFile;

/// The longest header that is read, bytes; those of plain arrays have 128.
const LONGEST_HEADER: usize = 1 << 14;

/// An array whose header was read; its numbers are still packed.
pub(crate) type PackedArray<R> = NpyFile<Chain<Cursor<Vec<u8>>, R>>;

/// What a header says of an array.
#[derive(Debug, PartialEq)]
struct Header {
    /// Its type in NumPy's notation: `<f8`.
    descr: String,
    shape: Vec<u64>,
}

/// The array in a file of `size` bytes, or what is wrong with its header. The array ends where
/// the file ends, so that no more memory is taken than the file has, and no bytes are left over.
pub(crate) fn open<R: Read>(mut file: R, size: u64) -> Result<PackedArray<R>, String> {
    let (start, text) = read_header(&mut file)?;
    let text = std::str::from_utf8(&start[text..]).map_err(|_| "has a header that is no text")?;
    let header = Parser { rest: text }.header()?;
    let Header { descr, shape } = &header;
    let (full, found) = (full_size(&header)?, size.saturating_sub(start.len() as u64));
    if found < full {
        return Err(format!(
            "ends before its shape {shape:?} of type {descr} is full"
        ));
    }
    if found > full {
        let more = found - full;
        return Err(format!(
            "has {more} bytes behind its end; expected {full} for its shape {shape:?} of type {descr}"
        ));
    }
    NpyFile::new(Cursor::new(start).chain(file)).map_err(|error| error.to_string())
}

/// All bytes before the numbers, and where the text among them begins.
fn read_header(file: &mut impl Read) -> Result<(Vec<u8>, usize), String> {
    let mut start = vec![0; 8];
    let mut more = |start: &mut Vec<u8>, from: usize| {
        let read = file.read_exact(&mut start[from..]);
        read.map_err(|_| "ends inside its header".to_owned())
    };
    more(&mut start, 0)?;
    if !start.starts_with(b"\x93NUMPY") {
        return Err("is no array of NumPy (.npy)".into());
    }
    let bytes_of_length = match start[6..8] {
        [1, 0] => 2,
        [2 | 3, 0] => 4,
        _ => {
            let [major, minor] = [start[6], start[7]];
            return Err(format!(
                "has version {major}.{minor} of the format; expected 1.0, 2.0 or 3.0"
            ));
        }
    };
    start.resize(8 + bytes_of_length, 0);
    more(&mut start, 8)?;
    let length = start[8..].iter().rev();
    let length = length.fold(0, |sum, &byte| sum << 8 | usize::from(byte));
    if length > LONGEST_HEADER {
        return Err(format!(
            "has a header of {length} bytes; expected at most {LONGEST_HEADER}"
        ));
    }
    let text = start.len();
    start.resize(text + length, 0);
    more(&mut start, text)?;
    Ok((start, text))
}

/// The bytes of all numbers.
fn full_size(Header { descr, shape }: &Header) -> Result<u64, String> {
    let name = descr.trim_start_matches(['<', '>', '|', '=']);
    let Some(kind) = name.chars().next().filter(char::is_ascii_alphabetic) else {
        return Err(format!("has the type '{descr}', which NumPy does not have"));
    };
    if kind == 'O' {
        return Err("holds objects of Python; save an array of float32 or float64 instead".into());
    }
    let count: Option<u64> = match &name[1..] {
        "" => Some(1),
        digits => digits.parse().ok(),
    };
    // A character has four bytes.
    let unit = if kind == 'U' { 4 } else { 1 };
    let item = count.and_then(|n| n.checked_mul(unit));
    // The library multiplies the sides also where one of them is 0.
    let mut sides = shape.iter().map(|&side| side.max(1));
    let items = sides.try_fold(1_u64, |n, side| n.checked_mul(side));
    let largest = item.zip(items).and_then(|(n, m)| n.max(1).checked_mul(m));
    match (largest, item) {
        (Some(_), _) if shape.contains(&0) => Ok(0),
        (Some(largest), Some(1..)) => Ok(largest),
        (Some(_), Some(0)) => Err(format!("has the type '{descr}', of no bytes")),
        _ => Err(format!(
            "has the shape {shape:?} of type {descr}, more than can be"
        )),
    }
}

/// Reads `{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }` from its start.
struct Parser<'a> {
    rest: &'a str,
}

impl<'a> Parser<'a> {
    fn header(mut self) -> Result<Header, String> {
        let (mut descr, mut shape, mut has_order) = (None, None, false);
        self.expect("{")?;
        while !self.next_is("}") {
            let key = self.quoted()?;
            self.expect(":")?;
            match key {
                "descr" if self.rest.trim_start().starts_with('[') => {
                    let reason = "has several columns; save one array for each of them";
                    return Err(reason.into());
                }
                "descr" if descr.is_none() => descr = Some(self.quoted()?.to_owned()),
                "shape" if shape.is_none() => shape = Some(self.sides()?),
                "fortran_order" if !has_order => {
                    has_order = true;
                    if !self.next_is("True") {
                        self.expect("False")?;
                    }
                }
                _ => return Err(format!("has an unknown or repeated '{key}' in its header")),
            }
            if !self.next_is(",") {
                self.expect("}")?;
                break;
            }
        }
        if !self.rest.trim().is_empty() {
            return self.malformed("the end");
        }
        match (descr, shape, has_order) {
            (Some(descr), Some(shape), true) => Ok(Header { descr, shape }),
            _ => Err("has no 'descr', 'fortran_order' or 'shape' in its header".into()),
        }
    }

    /// `(2, 3)`, `(2,)` or `()`.
    fn sides(&mut self) -> Result<Vec<u64>, String> {
        let mut sides = Vec::new();
        self.expect("(")?;
        while !self.next_is(")") {
            let side = self.while_is(|c| c.is_ascii_digit());
            match side.parse() {
                Ok(side) => sides.push(side),
                Err(_) => return self.malformed("a number below 2^64"),
            }
            if !self.next_is(",") {
                self.expect(")")?;
                break;
            }
        }
        Ok(sides)
    }

    fn quoted(&mut self) -> Result<&'a str, String> {
        let quote = if self.next_is("\"") { "\"" } else { "'" };
        if quote == "'" {
            self.expect("'")?;
        }
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "_<>|=".contains(c);
        let word = self.while_is(is_plain);
        self.expect(quote)?;
        Ok(word)
    }

    fn while_is(&mut self, is_part: impl Fn(char) -> bool) -> &'a str {
        self.rest = self.rest.trim_start();
        let length = self.rest.find(|c| !is_part(c)).unwrap_or(self.rest.len());
        let (part, rest) = self.rest.split_at(length);
        self.rest = rest;
        part
    }

    fn next_is(&mut self, token: &str) -> bool {
        let rest = self.rest.trim_start().strip_prefix(token);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn expect(&mut self, token: &str) -> Result<(), String> {
        match self.next_is(token) {
            true => Ok(()),
            false => self.malformed(token),
        }
    }

    fn malformed<T>(&self, expected: &str) -> Result<T, String> {
        let found: String = self.rest.trim().chars().take(20).collect();
        Err(format!(
            "has a header that NumPy does not write for an array: \
             expected {expected} before \"{found}\""
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file with this header and so many bytes of numbers.
    fn file(header: &str, bytes: usize) -> Vec<u8> {
        let mut file = b"\x93NUMPY\x01\x00".to_vec();
        file.extend((header.len() as u16).to_le_bytes());
        file.extend(header.bytes());
        file.resize(file.len() + bytes, 0);
        file
    }

    fn shape(header: &str, bytes: usize) -> Result<Vec<u64>, String> {
        let file = file(header, bytes);
        open(&file[..], file.len() as u64).map(|array| array.shape().to_vec())
    }

    fn header(descr: &str, shape: &str) -> String {
        format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}  \n")
    }

    #[test]
    fn headers_of_plain_arrays() {
        assert_eq!(shape(&header("<f8", "(2, 3)"), 48), Ok(vec![2, 3]));
        assert_eq!(shape(&header(">f4", "(2,)"), 8), Ok(vec![2]));
        assert_eq!(shape(&header("<f8", "()"), 8), Ok(vec![]));
        assert_eq!(shape(&header("<U3", "(0, 2)"), 0), Ok(vec![0, 2]));
        let other = "{\"shape\":(1,),\"fortran_order\":True,\"descr\":\"|u1\"}";
        assert_eq!(shape(other, 1), Ok(vec![1]));
    }

    /// What stands behind an array would be left out in silence.
    #[test]
    fn bytes_behind_an_array_are_errors() {
        let error = shape(&header("<f8", "(2,)"), 17).expect_err("one byte more");
        assert!(error.contains("has 1 bytes behind its end"), "{error}");
    }

    /// Each is refused for its own reason, at once.
    #[test]
    fn other_headers_are_errors() {
        let nested = |open: &str, close: &str| {
            let deep = format!("{}{}", open.repeat(5000), close.repeat(5000));
            header("<f8", &deep)
        };
        let list = "{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (1,), }";
        for (text, expected) in [
            (nested("(", ")"), "expected a number"),
            (nested("{", "}"), "expected ("),
            (nested("[", "]"), "expected ("),
            ("{".repeat(10_000), "expected '"),
            (list.into(), "several columns"),
            (header("|O", "(1,)"), "objects of Python"),
            (
                header("<f8", "(4294967296, 4294967296)"),
                "more than can be",
            ),
            (
                header("<f8", "(0, 4294967296, 4294967296)"),
                "more than can be",
            ),
            (header("<f8", "(18446744073709551616,)"), "below 2^64"),
            (header("<f8", "(-1,)"), "below 2^64"),
            (header("<U4611686018427387904", "(1,)"), "more than can be"),
            (header("<U0", "(100000000, 2)"), "of no bytes"),
            (header("<f8", "(9,)"), "ends before its shape [9]"),
            (header("8", "(1,)"), "does not have"),
            ("{}".into(), "has no 'descr'"),
            ("x".repeat(20_000), "a header of 20000 bytes"),
        ] {
            let error = shape(&text, 64).expect_err(expected);
            assert!(error.contains(expected), "{error}");
        }
    }
}
