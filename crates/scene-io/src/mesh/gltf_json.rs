//! The JSON of a glTF file, read strictly: every error names the place as glTF's
//! own validator does, `meshes[0].primitives[2].mode`.

use serde_json::Value;

use super::error::{MeshFileError, MeshPlace};

/// A value and where it stands.
#[derive(Clone)]
pub(super) struct Item<'a> {
    value: &'a Value,
    path: String,
}

impl<'a> Item<'a> {
    /// The whole file.
    pub fn root(value: &'a Value) -> Self {
        let path = String::new();
        Self { value, path }
    }

    pub fn place(&self) -> MeshPlace {
        match self.path.is_empty() {
            true => MeshPlace::File,
            false => MeshPlace::Json(self.path.clone()),
        }
    }

    /// An error at this value: out of its range.
    pub fn invalid(&self, message: impl Into<String>, help: &str) -> MeshFileError {
        MeshFileError::invalid(self.place(), message, help)
    }

    /// An error at this value: the file is incomplete.
    pub fn damaged(&self, message: impl Into<String>, help: &str) -> MeshFileError {
        MeshFileError::damaged(self.place(), message, help)
    }

    /// An error at this value: a part of glTF that is not read.
    pub fn unsupported(&self, message: impl Into<String>, help: &str) -> MeshFileError {
        MeshFileError::unsupported(self.place(), message, help)
    }

    /// What is there instead of what was expected.
    fn wrong(&self, expected: &str) -> MeshFileError {
        const LONGEST: usize = 40;
        let mut found = self.value.to_string();
        if let Some((end, _)) = found.char_indices().nth(LONGEST) {
            found.truncate(end);
            found += " ...";
        }
        self.invalid(format!("it is {found}"), &format!("expected {expected}"))
    }

    /// The property of an object, if it is there.
    pub fn get(&self, key: &str) -> Option<Item<'a>> {
        let separator = if self.path.is_empty() { "" } else { "." };
        Some(Item {
            value: self.value.get(key)?,
            path: format!("{}{separator}{key}", self.path),
        })
    }

    /// The property of an object; an error if it is missing.
    pub fn required(&self, key: &str) -> Result<Item<'a>, MeshFileError> {
        self.get(key).ok_or_else(|| {
            let message = format!("\"{key}\" is missing");
            self.damaged(message, "expected a complete glTF 2.0 file")
        })
    }

    /// Names of the properties of an object; none if it is something else.
    pub fn keys(&self) -> impl Iterator<Item = &'a str> {
        let object = self.value.as_object().into_iter();
        object.flat_map(|object| object.keys().map(String::as_str))
    }

    fn array(&self) -> Result<&'a [Value], MeshFileError> {
        let array = self.value.as_array().map(Vec::as_slice);
        array.ok_or_else(|| self.wrong("a list"))
    }

    /// How many entries a list has; 0 if it is missing.
    pub fn count(&self, list: &str) -> Result<usize, MeshFileError> {
        match self.get(list) {
            None => Ok(0),
            Some(list) => Ok(list.array()?.len()),
        }
    }

    /// The entry of a list that the file refers to by its index.
    pub fn entry(&self, list: &str, index: usize) -> Result<Item<'a>, MeshFileError> {
        let list = self.required(list)?;
        let array = list.array()?;
        let path = format!("{}[{index}]", list.path);
        match array.get(index) {
            Some(value) => Ok(Item { value, path }),
            None => Err(MeshFileError::damaged(
                MeshPlace::Json(path),
                "there is no such entry, but the file refers to it",
                format!("{} are there (counted from 0)", array.len()),
            )),
        }
    }

    /// The entries of a list as whole numbers; none if it is missing.
    pub fn indices(&self, list: &str) -> Result<Vec<usize>, MeshFileError> {
        let entries = (0..self.count(list)?).map(|i| self.entry(list, i)?.as_index());
        entries.collect()
    }

    /// The entries of a list of texts; none if it is missing.
    pub fn texts(&self, list: &str) -> Result<Vec<&'a str>, MeshFileError> {
        let entries = (0..self.count(list)?).map(|i| self.entry(list, i)?.as_text());
        entries.collect()
    }

    /// An integer from 0; 3.0 is one, too.
    pub fn as_index(&self) -> Result<usize, MeshFileError> {
        // Some writers give whole numbers a decimal point.
        let decimal = || {
            let x = self.value.as_f64()?;
            (x.fract() == 0.0 && (0.0..9e15).contains(&x)).then_some(x as u64)
        };
        let number = self.value.as_u64().or_else(decimal);
        let index = number.and_then(|number| usize::try_from(number).ok());
        index.ok_or_else(|| self.wrong("a whole number from 0"))
    }

    pub fn as_text(&self) -> Result<&'a str, MeshFileError> {
        self.value.as_str().ok_or_else(|| self.wrong("a text"))
    }

    pub fn as_boolean(&self) -> Result<bool, MeshFileError> {
        let boolean = self.value.as_bool();
        boolean.ok_or_else(|| self.wrong("true or false"))
    }

    /// A list of `N` finite numbers.
    pub fn as_numbers<const N: usize>(&self) -> Result<[f64; N], MeshFileError> {
        let array = self.value.as_array();
        let numbers: Option<Vec<f64>> = array.and_then(|a| a.iter().map(Value::as_f64).collect());
        let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        let finite = numbers.filter(|numbers| numbers.iter().all(|x| x.is_finite()));
        finite.ok_or_else(|| self.wrong(&format!("a list of {N} numbers")))
    }
}
