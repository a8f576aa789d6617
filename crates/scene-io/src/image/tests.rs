use super::*;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use capwalk_math::Rgb;
use capwalk_scene::Image;
use std::path::{Path, PathBuf};

/// A path in the temporary directory; the file is removed at the end.
struct Temporary(PathBuf);

impl Temporary {
    fn new(name: &str) -> Self {
        Self(std::env::temp_dir().join(format!("capwalk-{}-{name}", std::process::id())))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

/// Values that single precision holds exactly.
fn example() -> LayeredImage {
    let (width, height) = (7, 5);
    let image = |f: fn(f64, f64) -> [f64; 3]| {
        let mut image = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                image.pixels[y * width + x] = Rgb::from(f(x as f64, y as f64));
            }
        }
        image
    };
    let mut layered = LayeredImage::default();
    layered.push("value", image(|x, y| [0.125 * x, 0.25 * y, 0.5]));
    layered.push(
        "gradient",
        image(|x, y| [x - 3.0, 2.0 * (y - 2.0), 1e-3_f32.into()]),
    );
    layered.push("stderr", image(|x, y| [0.5, x * y, f64::INFINITY]));
    layered.metadata = [
        ("parameter", "ball.translate.x"),
        ("scene", "bälle.xml"),
        ("seed", "7"),
    ]
    .map(|(k, v)| (k.into(), v.into()))
    .to_vec();
    layered.samples = Some((0..35).collect());
    layered
}

#[test]
fn exr_and_npz_give_back_what_was_written() {
    for ending in ["exr", "npz"] {
        let file = Temporary::new(&format!("back.{ending}"));
        let layered = example();
        let written = write(&file.0, &layered, &Preview::default()).expect("writable");
        assert_eq!(written.non_finite_pixels, 0);
        assert_eq!(read(&file.0).expect("readable"), layered, "{ending}");
        // The same bytes each time.
        let bytes = std::fs::read(&file.0).expect("readable");
        for _ in 0..5 {
            write(&file.0, &layered, &Preview::default()).expect("writable");
            assert_eq!(std::fs::read(&file.0).expect("readable"), bytes, "{ending}");
        }
    }
}

/// NaN comes back as NaN and is counted where it matters.
#[test]
fn non_finite_pixels_are_counted_and_kept() {
    let mut layered = example();
    layered.layers[0].image.pixels[3].g = f64::NAN;
    layered.layers[1].image.pixels[4].r = f64::NEG_INFINITY;
    for (ending, count) in [("exr", 2), ("npz", 2), ("png", 1)] {
        let file = Temporary::new(&format!("nan.{ending}"));
        let written = write(&file.0, &layered, &Preview::default()).expect("writable");
        assert_eq!(written.non_finite_pixels, count, "{ending}");
        if ending != "png" {
            let back = read(&file.0).expect("readable");
            assert!(back.layers[0].image.pixels[3].g.is_nan());
        }
    }
}

#[test]
fn png_shows_the_gradient_or_else_the_value() {
    let file = Temporary::new("preview.png");
    let mut layered = example();
    let gradient = write(&file.0, &layered, &Preview::default()).expect("writable");
    assert_eq!(
        gradient.limit,
        Some(Scale::of([&layered.layers[1].image]).limit)
    );
    let preview = Preview {
        limit: Some(0.5),
        exposure: 0.0,
    };
    let limited = write(&file.0, &layered, &preview).expect("writable");
    assert_eq!(limited.limit, Some(0.5));

    layered.layers.remove(1);
    let value = write(&file.0, &layered, &Preview::default()).expect("writable");
    assert_eq!(value.limit, None);
    let (width, height, pixels) = decode_png(&file.0);
    assert_eq!((width, height), (7, 5));
    for (i, pixel) in layered.layers[0].image.pixels.iter().enumerate() {
        assert_eq!(pixels[3 * i..3 * i + 3], tone::photographic(*pixel, 1.0));
    }
}

fn decode_png(path: &Path) -> (u32, u32, Vec<u8>) {
    decode(&std::fs::read(path).expect("readable"))
}

fn decode(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes))
        .read_info()
        .expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut pixels).expect("a PNG");
    (info.width, info.height, pixels)
}

/// A NaN pixel of a panel is magenta, and only it.
#[test]
fn panels_show_non_finite_pixels() {
    let file = Temporary::new("panels.png");
    let layered = example();
    let mut broken = layered.layers[1].image.clone();
    broken.pixels[0].r = f64::NAN;
    let panel = |title, image, style| Panel {
        title,
        image,
        style,
    };
    let scale = Scale::of([&layered.layers[1].image]);
    let panels = [
        panel(
            "value",
            &layered.layers[0].image,
            Style::Photographic { exposure: 0.0 },
        ),
        panel(
            "gradient",
            &layered.layers[1].image,
            Style::Diverging(scale),
        ),
        panel("reference", &broken, Style::Diverging(scale)),
    ];
    assert_eq!(write_panels(&file.0, &panels, &layered.metadata), Ok(1));
    let (width, height, pixels) = decode_png(&file.0);
    let magenta = pixels.chunks(3).filter(|c| *c == tone::NON_FINITE).count();
    let zoom = 384_usize.div_ceil(7);
    assert_eq!(magenta, zoom * zoom);
    // Four have two rows, as tall as that one each.
    let [value, gradient, reference] = &panels;
    let z = panel("z", &broken, Style::Diverging(scale));
    let four = [value, gradient, reference, &z].map(|p| panel(p.title, p.image, p.style));
    assert_eq!(write_panels(&file.0, &four, &layered.metadata), Ok(2));
    let (width_of_two, height_of_two, pixels) = decode_png(&file.0);
    let magenta = pixels.chunks(3).filter(|c| *c == tone::NON_FINITE).count();
    assert_eq!(magenta, 2 * zoom * zoom);
    assert!(width_of_two < width && height_of_two == 2 * height);
    let wrong = write_panels(Path::new("panels.exr"), &panels, &[]).expect_err("not a PNG");
    assert!(wrong.to_string().contains("known endings: .png, .svg"));
}

/// Of an SVG file the images have the colours of the PNG file, one pixel each, and titles are text.
#[test]
fn svg_holds_images_and_type() {
    let file = Temporary::new("preview.svg");
    let mut layered = example();
    let parameter = "a<b>&\u{1}.translate.x".to_owned();
    layered.metadata.insert(0, ("parameter".into(), parameter));
    let written = write(&file.0, &layered, &Preview::default()).expect("writable");
    let text = std::fs::read_to_string(&file.0).expect("readable");
    let svg = roxmltree::Document::parse(&text).expect("XML");
    let elements = |name: &'static str| svg.descendants().filter(move |n| n.has_tag_name(name));
    let lines: Vec<_> = elements("text").filter_map(|n| n.text()).collect();
    assert_eq!(
        lines[..2],
        [VALUE, "gradient per unit of a<b>&.translate.x"]
    );
    let limit = written.limit.expect("a gradient");
    let first: f64 = lines[2].parse().expect("the bar's upper end");
    assert!((first / limit - 1.0).abs() < 0.01, "{first} {limit}");

    let images: Vec<_> = elements("image").collect();
    assert_eq!(images.len(), 3); // the last one is the bar
    let scale = Scale::of([&layered.layers[1].image]);
    let styles = [
        Style::Photographic { exposure: 0.0 },
        Style::Diverging(scale),
    ];
    for ((element, style), layer) in images.iter().zip(styles).zip(&layered.layers) {
        let link = element.attribute(("http://www.w3.org/1999/xlink", "href"));
        let data = link.and_then(|link| link.strip_prefix("data:image/png;base64,"));
        let bytes = BASE64_STANDARD.decode(data.expect("data")).expect("Base64");
        let (width, height, pixels) = decode(&bytes);
        assert_eq!((width, height), (7, 5));
        let colours: Vec<u8> = layer
            .image
            .pixels
            .iter()
            .flat_map(|&p| style.colour(p))
            .collect();
        assert_eq!(pixels, colours);
        assert_eq!(element.attribute("width"), Some("385"));
    }
    assert!(read(&file.0).is_err());
}

#[test]
fn errors_say_what_to_do() {
    let message = |result: Result<Written, ImageError>| result.expect_err("wrong").to_string();
    let layered = example();
    let options = Preview::default();
    for name in ["out.jpg", "out", "out.exr.gz"] {
        let text = message(write(Path::new(name), &layered, &options));
        assert!(
            text.contains("known endings: .exr, .npz, .png, .svg"),
            "{text}"
        );
        assert!(check_writable(Path::new(name)).is_err());
    }
    let nowhere = Path::new("/nonexistent/directory/out.exr");
    let text = message(write(nowhere, &layered, &options));
    assert!(
        text.starts_with("cannot write /nonexistent/directory/out.exr: "),
        "{text}"
    );
    assert!(check_writable(nowhere).is_err());

    let file = Temporary::new("checked.exr");
    assert_eq!(check_writable(&file.0), Ok(()));
    assert!(!file.0.exists());

    let flat = Preview {
        limit: Some(0.0),
        exposure: 0.0,
    };
    let text = message(write(Path::new("flat.png"), &layered, &flat));
    assert!(text.contains("limit of its colours is 0"), "{text}");

    let mut uneven = example();
    uneven.push("z", Image::new(3, 3));
    let text = message(write(&file.0, &uneven, &options));
    assert!(
        text.contains("\"value\" has 7 x 5 pixels, but \"z\" has 3 x 3"),
        "{text}"
    );
    let text = message(write(&file.0, &LayeredImage::default(), &options));
    assert!(text.contains("no layers"), "{text}");
    assert!(!file.0.exists());

    for ending in ["exr", "npz"] {
        let file = Temporary::new(&format!("broken.{ending}"));
        let missing = read(&file.0).expect_err("missing").to_string();
        assert!(missing.starts_with("cannot read "), "{missing}");
        assert!(missing.contains("expected an image"), "{missing}");
        write(&file.0, &layered, &options).expect("writable");
        let bytes = std::fs::read(&file.0).expect("readable");
        for length in [0, 10, bytes.len() / 2, bytes.len() - 30] {
            std::fs::write(&file.0, &bytes[..length]).expect("writable");
            assert!(read(&file.0).is_err(), "{ending} cut to {length} bytes");
        }
    }
    let text = read(Path::new("a.png")).expect_err("8 bits").to_string();
    assert!(text.contains("known endings: .exr, .npz"), "{text}");
}

/// Grey layers with one channel, or with none of their own.
#[test]
fn grey_layers() {
    let file = Temporary::new("grey.npz");
    for shape in [[5, 7].as_slice(), &[5, 7, 1]] {
        let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        let values = (0..35_u8).map(f32::from);
        crate::archive::add_array(&mut archive, "value", "<f4", shape, values).expect("writable");
        let bytes = archive.finish().expect("writable").into_inner();
        std::fs::write(&file.0, bytes).expect("writable");
        let image = read(&file.0).expect("readable").layers.remove(0).image;
        assert_eq!((image.width, image.height), (7, 5));
        assert_eq!(image.pixels[8], Rgb::splat(8.0));
    }
}

/// A header that promises more than the file has is refused before memory is
/// taken for it.
#[test]
fn impossible_shapes_are_refused() {
    let file = Temporary::new("shape.npz");
    write(&file.0, &example(), &Preview::default()).expect("writable");
    let mut bytes = std::fs::read(&file.0).expect("readable");
    // Numbers of the first header; the checksum is compared at its end only.
    let at = bytes
        .windows(7)
        .position(|w| w == b"(5, 7, ")
        .expect("a shape");
    bytes[at + 1] = b'9';
    std::fs::write(&file.0, &bytes).expect("writable");
    let text = read(&file.0).expect_err("too large").to_string();
    assert!(
        text.contains("\"value\" ends before its shape [9, 7, 3]"),
        "{text}"
    );
}
