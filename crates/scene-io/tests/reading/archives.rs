//! Image files whose contents cost more than what is wanted of them: headers are read first, then
//! the layer that is named, and nothing else.

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};

use capwalk_math::Rgb;
use capwalk_scene::Image;
use capwalk_scene_io::image::{self, ImageError, ImageFile, LayeredImage, Preview};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::damage::{Original, survive};

/// A file that is removed at the end.
struct Temporary(PathBuf);

impl Temporary {
    fn new(name: &str, bytes: &[u8]) -> Self {
        let name = format!("capwalk-archives-{}-{name}", std::process::id());
        let file = Self(std::env::temp_dir().join(name));
        std::fs::write(&file.0, bytes).expect("writable");
        file
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

/// An array of so many bytes, all of them zero, behind the header that NumPy writes.
fn array(descr: &str, shape: &str, bytes: usize) -> Vec<u8> {
    let header =
        format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}      \n");
    let mut array = b"\x93NUMPY\x01\x00".to_vec();
    array.extend((header.len() as u16).to_le_bytes());
    array.extend(header.bytes());
    array.resize(array.len() + bytes, 0);
    array
}

/// An archive of these arrays, each deflated.
fn npz(arrays: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let files = arrays
        .iter()
        .map(|(name, bytes)| (format!("{name}.npy"), bytes.clone()));
    archive(&files.collect::<Vec<_>>())
}

/// An archive of these files.
fn archive(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, bytes) in files {
        let started = archive.start_file(name, options);
        started.expect("a name");
        archive.write_all(bytes).expect("memory");
    }
    archive.finish().expect("an archive").into_inner()
}

fn open(name: &str, bytes: &[u8]) -> Result<ImageFile, String> {
    let file = Temporary::new(name, bytes);
    ImageFile::open(&file.0).map_err(|error| error.to_string())
}

/// Damages the numbers of an array, so that to unpack it is an error.
fn damage(archive: &mut [u8], name: &str) {
    let name = format!("{name}.npy");
    let mut places = archive.windows(name.len());
    let place = places.position(|part| part == name.as_bytes());
    // Behind the beginning of its deflated bytes, which has the header.
    let start = place.expect("is in the archive") + name.len() + 3000;
    archive[start..start + 8].fill(0xff);
}

/// How large a layer is says its header, and a layer is read whatever is wrong with the others.
#[test]
fn headers_come_before_pixels() {
    let image = |side: usize| {
        let numbers = side * side * 3;
        let mut bytes = array("<f4", &format!("({side}, {side}, 3)"), 0);
        // No two alike, so that they do not fit the first bytes.
        let mut x = 1_u32;
        bytes.extend((0..numbers).flat_map(|_| {
            x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((x >> 9) as f32).to_le_bytes()
        }));
        bytes
    };
    let mut bytes = npz(&[("value", image(8)), ("broken", image(30))]);
    damage(&mut bytes, "broken");
    let mut file = open("order.npz", &bytes).expect("an archive");
    assert_eq!(file.names(), ["value", "broken"]);
    assert_eq!(file.size("broken"), Ok(Some([30, 30])));
    let value = file.image("value").expect("it is whole").expect("there");
    assert_eq!((value.width, value.height), (8, 8));
    assert!(file.image("broken").is_err());
    assert_eq!(file.size("missing"), Ok(None));
    // Where everything is asked for, it must be whole.
    let file = Temporary::new("whole.npz", &bytes);
    assert!(image::read(&file.0).is_err());
}

/// 48 MB in 50 KB: the size is known before they are unpacked.
#[test]
fn bombs_are_measured_first() {
    let bytes = npz(&[("value", array("<f4", "(2000, 2000, 3)", 48_000_000))]);
    assert!(bytes.len() < 100_000);
    let mut file = open("bomb.npz", &bytes).expect("an archive");
    assert_eq!(file.size("value"), Ok(Some([2000, 2000])));
    // More than the file can hold: neither is memory taken for it.
    let bytes = npz(&[("value", array("<f4", "(2000000, 2000000, 3)", 1000))]);
    let mut file = open("promise.npz", &bytes).expect("an archive");
    let error = file.image("value").expect_err("too large").to_string();
    assert!(error.contains("ends before its shape"), "{error}");
}

/// What stands behind an array would be left out in silence.
#[test]
fn bytes_behind_an_array_are_refused() {
    let bytes = npz(&[("value", array("<f4", "(2, 2, 3)", 48 + 5))]);
    let error = open("behind.npz", &bytes).map(|mut file| file.image("value"));
    let error = error.expect("an archive").expect_err("five bytes more");
    let expected = "the array \"value\" has 5 bytes behind its end; expected 48";
    assert!(error.to_string().contains(expected), "{error}");
}

/// The reason why a file is refused.
#[track_caller]
fn refused(name: &str, bytes: &[u8], expected: &str) {
    match open(name, bytes).map(|mut file| file.image("value")) {
        Ok(Ok(_)) => panic!("{name} is refused"),
        Ok(Err(error)) => assert!(error.to_string().contains(expected), "{error}"),
        Err(error) => assert!(error.contains(expected), "{error}"),
    }
}

/// Images of nothing, and archives that have none or say something twice.
#[test]
fn images_have_layers_and_pixels() {
    refused("none.npz", &npz(&[]), "it has no layers");
    for shape in ["(5, 0, 3)", "(0, 5)"] {
        let empty = npz(&[("value", array("<f4", shape, 0))]);
        refused("empty.npz", &empty, "\"value\" has no pixels");
    }
    let mut layered = LayeredImage::default();
    layered.push("value", Image::new(0, 5));
    for ending in ["exr", "npz", "png"] {
        let file = Temporary::new(&format!("nothing.{ending}"), b"");
        let error = image::write(&file.0, &layered, &Preview::default());
        let error = error.expect_err(ending).to_string();
        assert!(error.contains("has no pixels"), "{error}");
    }
    let value = || array("<f4", "(2, 2, 3)", 48);
    let named = ["value.npy", "value"].map(|name| (name.to_owned(), value()));
    refused("once.npz", &archive(&named), "the name \"value\"");
    let mut twice = npz(&[("value", value()), ("valuf", value())]);
    for at in 0..twice.len() - 9 {
        if twice[at..].starts_with(b"valuf.npy") {
            twice[at + 4] = b'e';
        }
    }
    refused("twice.npz", &twice, "two of its arrays have the same name");
}

/// In EXR files, too, with one part.
#[test]
fn bytes_behind_pixels_are_refused() {
    let mut bytes = written("exr", &example());
    let whole = open("whole.exr", &bytes).map(|mut file| file.image("value"));
    assert!(whole.expect("an image").is_ok());
    bytes.extend(b"12345");
    refused("behind.exr", &bytes, "5 bytes behind its last pixels");
}

/// What could not be read is not written.
#[test]
fn long_names_are_not_written() {
    let mut layered = LayeredImage::default();
    layered.push(&"x".repeat(9000), Image::new(2, 2));
    let file = Temporary::new("long.npz", b"");
    let error = image::write(&file.0, &layered, &Preview::default());
    let error = error.expect_err("a long name").to_string();
    assert!(
        error.contains("would have 9004 bytes; expected at most 8192"),
        "{error}"
    );
}

/// Texts that nobody could read, and lists of arrays that nobody wrote.
#[test]
fn metadata_and_lists_have_bounds() {
    let value = || ("value", array("<f4", "(2, 2, 3)", 48));
    let text = array("<U4200000", "(2, 2)", 67_200_000);
    let expected = "\"metadata\" has 67200";
    refused("text.npz", &npz(&[value(), ("metadata", text)]), expected);
    let long = "x".repeat(10_000);
    let named = npz(&[value(), (&long, array("<f4", "(1, 1)", 4))]);
    refused("name.npz", &named, "has 10004 bytes; expected at most 8192");
    let names: Vec<String> = (0..20_000).map(|i| format!("layer{i}")).collect();
    let layers = names.iter().map(|name| (name.as_str(), Vec::new()));
    let many = npz(&layers.collect::<Vec<_>>());
    refused("many.npz", &many, "its list of arrays has");
}

fn example() -> LayeredImage {
    let mut layered = LayeredImage::default();
    for (name, number) in [("value", 0.5), ("gradient", -2.0), ("stderr", 0.25)] {
        let mut image = Image::new(7, 5);
        image.pixels.fill(Rgb::splat(number));
        layered.push(name, image);
    }
    layered.metadata = vec![("scene".into(), "bälle.xml".into())];
    layered.samples = Some(vec![3; 35]);
    layered
}

/// The bytes of an image file with this ending.
fn written(ending: &str, layered: &LayeredImage) -> Vec<u8> {
    let file = Temporary::new(&format!("written.{ending}"), b"");
    image::write(&file.0, layered, &Preview::default()).expect("writable");
    std::fs::read(&file.0).expect("readable")
}

/// A layer alone is the layer of the whole file, in both formats.
#[test]
fn one_layer_is_that_of_all() {
    let layered = example();
    for ending in ["exr", "npz"] {
        let name = format!("one.{ending}");
        let mut file = open(&name, &written(ending, &layered)).expect("an image");
        for layer in &layered.layers {
            assert_eq!(file.size(&layer.name), Ok(Some([7, 5])), "{ending}");
            let image = file.image(&layer.name).expect("readable");
            assert_eq!(image.as_ref(), Some(&layer.image), "{ending}");
        }
    }
}

#[test]
fn headers_of_exr_have_bounds() {
    let mut layered = example();
    layered.metadata = vec![("note".into(), "x".repeat(3_000_000))];
    let long = written("exr", &layered);
    refused("long.exr", &long, "its header has more than");
    layered.metadata = (0..20_000).map(|i| (format!("n{i}"), "x".into())).collect();
    let many = written("exr", &layered);
    refused("many.exr", &many, "headers have more than 16384 attributes");
}

/// Reads what a command reads: headers, then layers that are not too large.
fn read_layers(path: &Path) -> Result<bool, ImageError> {
    let mut file = ImageFile::open(path)?;
    let names: Vec<String> = file.names().iter().map(|&name| name.to_owned()).collect();
    let mut is_read = false;
    for name in names {
        if let Some([width, height]) = file.size(&name)?
            && width.saturating_mul(height) <= 1 << 20
            && let Some(image) = file.image(&name)?
        {
            assert_eq!(image.pixels.len(), width * height);
            is_read = true;
        }
    }
    Ok(is_read)
}

fn reads(ending: &str, bytes: &[u8]) -> bool {
    let file = Temporary::new(&format!("damaged.{ending}"), bytes);
    match read_layers(&file.0) {
        Ok(is_read) => is_read,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 20_000, "{message}");
            false
        }
    }
}

/// As files, and inside the deflated arrays, which a checksum guards.
#[test]
fn damaged_archives() {
    let npz_file = |bytes: &[u8]| reads("npz", bytes);
    let exr_file = |bytes: &[u8]| reads("exr", bytes);
    let layered = example();
    let value = array("<f4", "(5, 7, 3)", 420);
    let bomb = npz(&[("value", array("<f4", "(100, 100, 3)", 120_000))]);
    let originals = vec![
        Original::new(written("npz", &layered), npz_file),
        Original::new(written("exr", &layered), exr_file),
        Original::new(bomb, npz_file),
        Original {
            bytes: value,
            wrap: |bytes| npz(&[("value", bytes.to_vec())]),
            read: npz_file,
        },
    ];
    let share = survive("archive", originals, 1000);
    assert!((0.01..0.95).contains(&share), "{share}");
}
