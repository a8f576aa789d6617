//! Files that are made to cost much more than they are long: each is read in little time
//! and memory, or refused for its reason.

use std::fmt::Write;
use std::time::{Duration, Instant};

use capwalk_scene_io::image::{self, Layer, LayeredImage, Preview, VALUE};
use capwalk_scene_io::load_scene_str;
use capwalk_scene_io::mesh::read_ply;

use crate::common::*;

/// Far more than any of these takes without optimisation, far less than one that takes time
/// proportional to the square of its length.
const LONGEST: Duration = Duration::from_secs(30);

const MANY: usize = 100_000;

fn within<T>(name: &str, read: impl FnOnce() -> T) -> T {
    let started = Instant::now();
    let result = read();
    let elapsed = started.elapsed();
    println!("{name}: {elapsed:?}");
    assert!(elapsed < LONGEST, "{name} takes {elapsed:?}");
    result
}

/// A text for every number.
fn many(count: usize, one: impl Fn(&mut String, usize)) -> String {
    let mut text = String::new();
    (0..count).for_each(|i| one(&mut text, i));
    text
}

/// Each parameter is ten of the one before: 10^12 bytes in the end.
#[test]
fn parameters_that_multiply() {
    let mut defaults = "<default name=\"p0\" value=\"x\"/>".to_owned();
    for i in 1..13 {
        let value = format!("$p{}_", i - 1).repeat(10).replace('_', "");
        write!(defaults, "<default name=\"p{i}\" value=\"{value}\"/>").expect("memory");
    }
    let text = scene("").replace(HEAD, &format!("{HEAD}{defaults}"));
    let error = within("parameters", || message(&text, &[]));
    assert!(error.contains("put in too much text"), "{error}");
    assert!(error.starts_with("scene.xml:2:"), "{error}");
    // A long definition from outside, many times.
    let names = "<string name=\"s\" value=\"$d$d$d$d$d$d$d$d$d$d\"/>";
    let long = "x".repeat(200_000);
    let error = message(&scene(names), &[("d", &long)]);
    assert!(error.contains("put in too much text"), "{error}");
    // One of them is not too long, a thousand are.
    let objects = many(1000, |text, _| *text += "<bsdf type=\"$d\"/>");
    let error = message(&scene(&objects), &[("d", &long)]);
    assert!(error.contains("put in too much text"), "{error}");
}

/// The parser compares each attribute with all before.
#[test]
fn many_attributes() {
    let attributes = many(MANY, |text, i| {
        write!(text, " a{i}=\"1\"").expect("memory");
    });
    let error = within("attributes", || {
        message(&scene(&format!("<bsdf{attributes}/>")), &[])
    });
    assert!(error.contains("more than 64 attributes"), "{error}");
    assert!(error.starts_with("scene.xml:5:3"), "{error}");
    // Where they are none.
    for text in [
        format!("<!--<{attributes}-->"),
        format!("<?x <{attributes}?>"),
        format!("<string name=\"x\" value='{}'/>", "=".repeat(1000)),
    ] {
        let read = try_load(&scene(&text), &[]);
        let message = read.map(|_| ()).map_err(|error| error.to_string());
        assert!(
            !format!("{message:?}").contains("attributes"),
            "{message:?}"
        );
    }
}

/// What is many is read in time proportional to its length.
#[test]
fn many_of_everything() {
    let bsdf = "<bsdf type=\"diffuse\" id=\"m\"/>";
    let defaults = many(MANY, |text, i| {
        write!(text, "<default name=\"p{i}\" value=\"{i}\"/>").expect("memory");
    });
    let uses = many(MANY, |text, i| {
        write!(text, "<bsdf type=\"diffuse\" id=\"b$p{i}\"/>").expect("memory");
    });
    let references = many(MANY, |text, _| *text += "<ref id=\"m\"/>");
    let aliases = many(MANY, |text, i| {
        write!(text, "<alias id=\"m\" as=\"n{i}\"/>").expect("memory");
    });
    let warnings = many(MANY, |text, _| *text += "<bsdf type=\"diffuse\"/>stray\n");
    let shapes = many(20_000, |text, i| {
        write!(text, "<shape type=\"rectangle\" id=\"s{i}\"/>").expect("memory");
    });
    for (name, objects) in [
        ("parameters", format!("{defaults}{uses}")),
        ("references", format!("{bsdf}{references}")),
        ("aliases", format!("{bsdf}{aliases}")),
        ("stray texts", warnings.clone()),
        ("one line of stray texts", warnings.replace('\n', " ")),
        ("shapes", shapes.clone()),
        (
            "shapes without names",
            shapes.replace(" id=\"s", " name=\"s"),
        ),
        (
            "an unknown name",
            format!("{uses}{shapes}<ref id=\"sx\"/>").replace('$', ""),
        ),
    ] {
        let read = within(name, || try_load(&scene(&objects), &[]));
        let message = read.err().map(|error| error.to_string());
        match name {
            "an unknown name" => assert!(message.expect("an error").contains("\"sx\"")),
            "references" => {}
            _ => assert_eq!(message, None, "{name}"),
        }
    }
}

/// Warnings beyond the first thousand are counted.
#[test]
fn many_warnings() {
    let objects = many(1500, |text, _| *text += "stray\n<bsdf type=\"diffuse\"/>");
    let loaded = load_scene_str(&scene(&objects), &folder(), "scene.xml", &[]);
    let warnings = loaded.expect("a good scene").warnings;
    assert_eq!(warnings.len(), 1001);
    let last = warnings[1000].to_string();
    assert!(last.contains("there are 500 more warnings"), "{last}");
}

/// Numbers, names and values that are very long.
#[test]
fn long_texts() {
    let digits = "9".repeat(1_000_000);
    for object in [
        format!("<shape type=\"sphere\"><float name=\"radius\" value=\"{digits}\"/></shape>"),
        format!("<shape type=\"sphere\"><integer name=\"radius\" value=\"{digits}\"/></shape>"),
        format!("<shape type=\"{digits}\"/>"),
        format!("<ref id=\"{digits}\"/>"),
        format!("<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"{digits}\"/></bsdf>"),
        format!("<x{digits}/>"),
        format!("<bsdf type=\"diffuse\"><float name=\"{digits}\" value=\"1\"/></bsdf>"),
    ] {
        let error = within("a long text", || message(&scene(&object), &[]));
        assert!(error.starts_with("scene.xml:5:"), "{}", &error[..100]);
        assert!(error.len() < 2000, "{} bytes", error.len());
    }
}

/// Spectra in spectra, each referring to the next.
#[test]
fn spectra_that_nest() {
    let chain = |length| {
        let spectra = many(length, |text, i| {
            let next = i + 1;
            write!(
                text,
                "<spectrum type=\"d65\" id=\"a{i}\"><ref id=\"a{next}\"/></spectrum>"
            )
            .expect("memory");
        });
        scene(&format!(
            "{spectra}<spectrum type=\"d65\" id=\"a{length}\"/>"
        ))
    };
    load(&chain(7));
    let error = within("spectra", || message(&chain(10_000), &[]));
    assert!(
        error.contains("textures stand inside each other too deep")
            && error.contains("expected at most 8 inside each other"),
        "{error}"
    );
}

/// The parser looks at all declarations of the elements around each.
#[test]
fn namespaces() {
    let declared = many(6000, |text, i| {
        write!(text, "<bsdf xmlns:n{i}=\"u{i}\" type=\"diffuse\"/>").expect("memory");
    });
    let error = within("namespaces", || message(&scene(&declared), &[]));
    assert_eq!(
        error,
        "scene.xml:5:9: scene files have no namespaces\n  remove \"xmlns...\" and prefixes of \
         names"
    );
    let error = message(&scene("<bsdf\nxmlns = 'u' type=\"diffuse\"/>"), &[]);
    assert!(error.starts_with("scene.xml:6:1: scene files"), "{error}");
    // Where it is none.
    load(&scene(
        "<!-- xmlns:a=\"b\" --><bsdf type=\"diffuse\" id=\" xmlns=\"/>",
    ));
}

/// Nothing is built of elements that are nested too deep, whether they are closed or not.
#[test]
fn depth_is_seen_before_parsing() {
    let open = "<bsdf type=\"twosided\">\n".repeat(40);
    let error = message(&format!("{HEAD}{open}"), &[]);
    assert_eq!(
        error,
        "scene.xml:33:1: <bsdf> is nested 33 elements deep\n  at most 32 are read"
    );
    // Elements side by side are not.
    let closed = "<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"></bsdf>".repeat(40);
    load(&scene(&closed));
}

/// The size that a header announces is compared with the length of the file.
#[test]
fn images_without_pixels() {
    let folder = std::env::temp_dir().join(format!("capwalk-exr-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("bomb.exr");
    let image = capwalk_scene::Image {
        width: 2,
        height: 2,
        pixels: vec![capwalk_math::Rgb::splat(0.5); 4],
    };
    let layers = vec![Layer {
        name: VALUE.into(),
        image,
    }];
    let layered = LayeredImage {
        layers,
        ..LayeredImage::default()
    };
    image::write(&path, &layered, &Preview::default()).expect("an image");
    let mut bytes = std::fs::read(&path).expect("the image");
    let find = |bytes: &[u8], part: &[u8]| {
        let mut places = bytes.windows(part.len());
        places.position(|w| w == part).expect("is in the header")
    };
    // Files of others do not say how many chunks they have.
    let count = find(&bytes, b"chunkCount\0int\0\x04\0\0\0");
    bytes.drain(count..count + 23);
    let window = b"dataWindow\0box2i\0\x10\0\0\0";
    let corner = find(&bytes, window) + window.len() + 8;
    for side in [9_999_999_i32, 400_000, 60_000] {
        for at in [corner, corner + 4] {
            bytes[at..at + 4].copy_from_slice(&side.to_le_bytes());
        }
        std::fs::write(&path, &bytes).expect("a file");
        let error = image::read(&path).expect_err("an image without pixels");
        assert!(error.to_string().contains("bytes cannot hold"), "{error}");
        let shown = path.display();
        let texture = format!(
            "<texture type=\"bitmap\"><string name=\"filename\" value=\"{shown}\"/></texture>"
        );
        let error = message(&scene(&texture), &[]);
        assert!(error.contains("bytes cannot hold"), "{error}");
    }
    std::fs::remove_dir_all(&folder).expect("the folder");
}

/// Names of properties and elements are compared with all others.
#[test]
fn long_headers_of_ply() {
    let properties = many(200_000, |text, i| {
        writeln!(text, "property float p{i}").expect("memory");
    });
    let elements = many(200_000, |text, i| {
        writeln!(text, "element e{i} 0").expect("memory");
    });
    for (name, lines, line) in [
        (
            "properties",
            format!("element vertex 0\n{properties}"),
            1027,
        ),
        ("elements", elements, 1027),
    ] {
        let text = format!("ply\nformat ascii 1.0\n{lines}end_header\n");
        let error = within(name, || read_ply(text.as_bytes(), true)).expect_err(name);
        let expected =
            format!("line {line}: the header has more than 1024 elements and properties");
        assert!(error.to_string().contains(&expected), "{error}");
    }
}
