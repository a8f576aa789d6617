//! Damaged files: thousands of them, the same ones in every run.
//!
//! `cargo xtask soak` makes many more: `CAPWALK_SOAK_SECONDS` says for how long,
//! `CAPWALK_SOAK_SEED` where to begin.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// How long one damaged file may take. They are a few kilobytes at most and take
/// microseconds.
const LONGEST: Duration = Duration::from_secs(20);

/// A reader: true if it could read the bytes.
pub type Reader = fn(&[u8]) -> bool;

/// A good file, and what must survive its damage.
#[derive(Clone)]
pub struct Original {
    /// What is damaged.
    pub bytes: Vec<u8>,
    /// Makes a file of it: damage behind a checksum would never be seen.
    pub wrap: fn(&[u8]) -> Vec<u8>,
    pub read: Reader,
}

impl Original {
    /// A file that is damaged as it is.
    pub fn new(bytes: impl Into<Vec<u8>>, read: Reader) -> Self {
        let (bytes, wrap) = (bytes.into(), <[u8]>::to_vec as fn(&[u8]) -> Vec<u8>);
        Self { bytes, wrap, read }
    }
}

/// Knuth's MMIX generator: deterministic, and good enough for damage.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n.max(1)
    }
}

/// Pieces that parsers stumble over.
const PIECES: [&str; 24] = [
    "0",
    "-1",
    "1e999",
    "nan",
    "4294967296",
    "99999999999999999999",
    "$",
    "\\",
    "\"",
    "<",
    "/>",
    "&lt;",
    "<scene>",
    "//",
    "f 1 2 3\n",
    "\n",
    " ",
    "\u{fffd}",
    "property list uchar int x\n",
    "element face 1000000000000\n",
    "[[[[[[[[",
    "{\"a\":",
    ",null",
    "data:,",
];

/// Numbers that take the place of others in a text.
const NUMBERS: [&str; 10] = [
    "0",
    "1",
    "2",
    "255",
    "65536",
    "-1",
    "2147483648",
    "18446744073709551615",
    "1e300",
    "0.5",
];

/// And in binary files.
const WORDS: [u64; 8] = [
    0,
    1,
    0xff,
    0x7fff_ffff,
    0xffff_ffff,
    0x1_0000_0000,
    0x7ff0_0000_7f80_0000, // infinite as f64, its lower half as f32
    u64::MAX,
];

/// One to four changes: cut, deleted, repeated, replaced, inserted, exchanged,
/// or spliced with another file.
fn damage(original: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = original.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        let longest = if random.below(8) == 0 { 400 } else { 12 };
        let end = (at + random.below(longest)).min(bytes.len());
        match random.below(11) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => {
                let piece = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, piece);
            }
            3 if at < bytes.len() => bytes[at] = random.below(256) as u8,
            4 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            5 | 6 => change_number(&mut bytes, at, random),
            7 => {
                let word = WORDS[random.below(WORDS.len())].to_le_bytes();
                let size = [1, 2, 4, 8][random.below(4)].min(bytes.len() - at);
                bytes[at..at + size].copy_from_slice(&word[..size]);
            }
            8 => {
                let from = random.below(other.len());
                bytes.truncate(at);
                bytes.extend(other.get(from..).unwrap_or_default());
            }
            _ => {
                let piece = PIECES[random.below(PIECES.len())];
                bytes.splice(at..at, piece.bytes());
            }
        }
    }
    bytes
}

/// Replaces the first number at or behind a place by another.
fn change_number(bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
    let Some(start) = bytes[at..].iter().position(u8::is_ascii_digit) else {
        return;
    };
    let start = at + start;
    let rest = bytes[start..].iter();
    let end = start + rest.take_while(|b| b.is_ascii_digit()).count();
    let number = NUMBERS[random.below(NUMBERS.len())];
    bytes.splice(start..end, number.bytes());
}

/// The file with this number.
fn damaged(originals: &[Original], number: u64) -> (Vec<u8>, Reader) {
    let original = &originals[(number % originals.len() as u64) as usize];
    let mut random = Random(number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let other = &originals[random.below(originals.len())].bytes;
    let bytes = damage(&original.bytes, other, &mut random);
    ((original.wrap)(&bytes), original.read)
}

/// Damages the originals in `count` ways, or for as long as the soak lasts, and
/// returns the share of them that could be read. A file that makes a reader panic or
/// takes too long is kept and named.
pub fn survive(name: &str, originals: Vec<Original>, count: u64) -> f64 {
    for original in &originals {
        let file = (original.wrap)(&original.bytes);
        assert!(
            (original.read)(&file),
            "{name} is good before it is damaged"
        );
    }
    let variable = |name: &str| std::env::var(name).ok()?.parse().ok();
    let first: u64 = variable("CAPWALK_SOAK_SEED").map_or(0, |seed: u64| seed << 32);
    let seconds = variable("CAPWALK_SOAK_SECONDS").map(Duration::from_secs);
    let at_work = Arc::new((
        AtomicU64::new(first),
        AtomicU64::new(0),
        AtomicBool::new(false),
    ));
    let worker = {
        let (at_work, originals) = (at_work.clone(), originals.clone());
        let started = Instant::now();
        thread::spawn(move || {
            let (number, read, is_done) = &*at_work;
            // Whatever happens, whoever waits is told.
            let _done = OnDrop(|| is_done.store(true, Ordering::Release));
            let enough = |n: u64| match seconds {
                Some(seconds) => started.elapsed() >= seconds,
                None => n >= first + count,
            };
            while !enough(number.load(Ordering::Relaxed)) {
                let (bytes, reader) = damaged(&originals, number.load(Ordering::Relaxed));
                read.fetch_add(u64::from(reader(&bytes)), Ordering::Relaxed);
                number.fetch_add(1, Ordering::Release);
            }
        })
    };
    let (number, read, is_done) = &*at_work;
    let mut last = (number.load(Ordering::Acquire), Instant::now());
    while !is_done.load(Ordering::Acquire) {
        thread::sleep(Duration::from_millis(2));
        let now = number.load(Ordering::Acquire);
        if now != last.0 {
            last = (now, Instant::now());
        }
        if last.1.elapsed() > LONGEST {
            let path = keep(name, &originals, now);
            panic!("{path} takes more than {LONGEST:?}");
        }
    }
    let number = number.load(Ordering::Acquire);
    if worker.join().is_err() {
        panic!("{} makes the reader panic", keep(name, &originals, number));
    }
    let files = number - first;
    println!("{name}: {files} damaged files");
    read.load(Ordering::Relaxed) as f64 / files as f64
}

/// Writes a damaged file to where it can be looked at.
fn keep(name: &str, originals: &[Original], number: u64) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(format!("damaged_{name}_{number}"));
    std::fs::write(&path, damaged(originals, number).0).expect("a folder for temporary files");
    path.display().to_string()
}

/// Runs at the end of a block, also when that panics.
struct OnDrop<F: Fn()>(F);

impl<F: Fn()> Drop for OnDrop<F> {
    fn drop(&mut self) {
        (self.0)();
    }
}
