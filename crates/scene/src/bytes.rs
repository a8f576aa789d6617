//! Things as bytes, to be sent to another process of the same version.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::scene::Scene;

/// Bytes that are not what was expected.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("these bytes are none of this version of capwalk, or were damaged: {reason}")]
pub struct BytesError {
    /// What was found.
    pub reason: String,
}

fn damaged(reason: impl ToString) -> BytesError {
    BytesError {
        reason: reason.to_string(),
    }
}

/// The bytes of a thing: exact for every number, with the version and a checksum.
pub fn pack<T: Serialize>(thing: &T) -> Result<Vec<u8>, BytesError> {
    let mut bytes = postcard::to_allocvec(&(VERSION, thing)).map_err(damaged)?;
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    Ok(bytes)
}

/// What [`pack`] made bytes of.
pub fn unpack<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, BytesError> {
    let (content, checksum) = bytes
        .split_last_chunk::<4>()
        .ok_or_else(|| damaged("they are too few"))?;
    if crc32fast::hash(content).to_le_bytes() != *checksum {
        return Err(damaged("their checksum is wrong"));
    }
    let (version, content): (&str, _) = postcard::take_from_bytes(content).map_err(damaged)?;
    if version != VERSION {
        return Err(damaged(format!(
            "they are of version {version}; expected {VERSION}"
        )));
    }
    postcard::from_bytes(content).map_err(damaged)
}

/// A number that tells things apart: FNV-1a of the bytes that [`pack`] makes of them, and of the
/// version.
pub fn fingerprint<T: Serialize>(thing: &T) -> u64 {
    struct Hash(u64);

    impl Extend<u8> for Hash {
        fn extend<I: IntoIterator<Item = u8>>(&mut self, bytes: I) {
            let prime = 0x0000_0100_0000_01b3;
            let add = |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(prime);
            self.0 = bytes.into_iter().fold(self.0, add);
        }
    }

    let start = Hash(0xcbf2_9ce4_8422_2325);
    let hash = postcard::to_extend(&(VERSION, thing), start);
    hash.expect("what is in memory has a length").0
}

const VERSION: &str = env!("CARGO_PKG_VERSION");

impl Scene {
    /// The scene as bytes, exact in every number. Read them with the same version.
    pub fn to_bytes(&self) -> Result<Vec<u8>, BytesError> {
        pack(self)
    }

    /// What [`Scene::to_bytes`] made.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        let scene: Self = unpack(bytes)?;
        scene.check().map_err(damaged)?;
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::builtin;

    /// Every digit of every number comes back, of every kind of scene that is built in.
    #[test]
    fn scenes_come_back_to_the_bit() {
        for name in builtin::names() {
            let scene = builtin::scene(name).expect("built in");
            let bytes = scene.to_bytes().expect("it has bytes");
            assert_eq!(Scene::from_bytes(&bytes).as_ref(), Ok(&scene), "{name}");
        }
    }

    #[test]
    fn damage_is_found() {
        let bytes = builtin::scene("leaf").expect("built in").to_bytes();
        let bytes = bytes.expect("it has bytes");
        let reason = |bytes: &[u8]| Scene::from_bytes(bytes).expect_err("damaged").reason;
        assert_eq!(reason(&bytes[..3]), "they are too few");
        let mut flipped = bytes.clone();
        flipped[100] ^= 1;
        assert_eq!(reason(&flipped), "their checksum is wrong");
        let mut other = bytes;
        let sum = other.len() - 4;
        // The version is the first text.
        other[1] = b'9';
        let checksum = crc32fast::hash(&other[..sum]).to_le_bytes();
        other[sum..].copy_from_slice(&checksum);
        assert!(reason(&other).starts_with("they are of version 9"));
    }
}
