//! Mitsuba's `.serialized` meshes, as bytes and in scenes.

use std::io::Write;

use capwalk_math::Vec3;
use capwalk_scene::{Pattern, ShadingNormals};
use capwalk_scene_io::mesh::{MeshFile, read_serialized};
use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::common::*;

/// What the writer below writes.
#[derive(Clone, Default)]
pub struct Contents {
    pub name: &'static str,
    pub positions: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
    pub uvs: Vec<[f64; 2]>,
    pub colours: Vec<[f64; 3]>,
    pub faces: Vec<[u32; 3]>,
    pub is_double: bool,
    /// Flags besides those that follow from the rest.
    pub flags: u32,
}

impl Contents {
    /// The data of the mesh before they are deflated.
    pub fn unpacked(&self, version: u16) -> Vec<u8> {
        let bits = [
            (!self.normals.is_empty(), 1),
            (!self.uvs.is_empty(), 2),
            (!self.colours.is_empty(), 8),
            (!self.is_double, 0x1000),
            (self.is_double, 0x2000),
        ];
        let given = bits.iter().filter(|(is_set, _)| *is_set);
        let flags: u32 = self.flags + given.map(|(_, bit)| bit).sum::<u32>();
        let mut bytes = flags.to_le_bytes().to_vec();
        if version == 4 {
            bytes.extend(self.name.bytes().chain([0]));
        }
        for count in [self.positions.len(), self.faces.len()] {
            bytes.extend((count as u64).to_le_bytes());
        }
        let vertices = [self.positions.as_flattened(), self.normals.as_flattened()];
        let others = [self.uvs.as_flattened(), self.colours.as_flattened()];
        for &x in vertices.into_iter().chain(others).flatten() {
            match self.is_double {
                true => bytes.extend(x.to_le_bytes()),
                false => bytes.extend((x as f32).to_le_bytes()),
            }
        }
        let corners = self.faces.as_flattened().iter();
        bytes.extend(corners.flat_map(|i| i.to_le_bytes()));
        bytes
    }
}

fn deflated(data: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(data).expect("to memory");
    encoder.finish().expect("to memory")
}

/// A file with these data, each deflated.
pub fn file_of(meshes: &[Vec<u8>], version: u16) -> Vec<u8> {
    let (mut bytes, mut offsets) = (Vec::new(), Vec::new());
    for data in meshes {
        offsets.push(bytes.len() as u64);
        bytes.extend(0x041C_u16.to_le_bytes());
        bytes.extend(version.to_le_bytes());
        bytes.extend(deflated(data));
    }
    for offset in offsets {
        match version {
            3 => bytes.extend((offset as u32).to_le_bytes()),
            _ => bytes.extend(offset.to_le_bytes()),
        }
    }
    bytes.extend((meshes.len() as u32).to_le_bytes());
    bytes
}

/// The file of these meshes.
pub fn written(meshes: &[Contents], version: u16) -> Vec<u8> {
    let data: Vec<_> = meshes.iter().map(|m| m.unpacked(version)).collect();
    file_of(&data, version)
}

/// A triangle with everything, and a square with nothing but positions. Their
/// numbers are exact in single precision.
pub fn triangle_and_square() -> [Contents; 2] {
    let triangle = Contents {
        name: "triangle",
        positions: vec![[0.0, 0.0, 0.5], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
        normals: vec![[0.0, 0.0, 2.0], [0.0, 0.6, 0.8], [0.0, 0.0, 1.0]],
        uvs: vec![[0.0, 0.25], [1.0, 0.0], [0.0, 1.0]],
        colours: vec![[0.0, 0.25, 0.5], [1.0, 1.0, 1.0], [0.75, 0.0, 0.0]],
        faces: vec![[0, 1, 2]],
        ..Contents::default()
    };
    let square = Contents {
        name: "square",
        positions: vec![
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0],
        ],
        faces: vec![[0, 1, 2], [0, 2, 3]],
        ..Contents::default()
    };
    [triangle, square]
}

fn read(bytes: &[u8], index: u32) -> MeshFile {
    read_serialized(bytes, index, true).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(bytes: &[u8], index: u32) -> String {
    let error = read_serialized(bytes, index, true).expect_err("bad");
    error.to_string()
}

#[test]
fn versions_and_precisions() {
    for (version, is_double) in [(3, false), (3, true), (4, false), (4, true)] {
        let mut meshes = triangle_and_square();
        meshes.iter_mut().for_each(|m| m.is_double = is_double);
        let bytes = written(&meshes, version);
        let [triangle, square] = [read(&bytes, 0), read(&bytes, 1)];
        let name = (version == 4).then(|| "square".to_owned());
        assert_eq!(square.name, name);
        assert_eq!(square.mesh.faces, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(square.mesh.positions[3], Vec3::new(-1.0, 1.0, 0.0));
        assert_eq!((square.normals, square.uvs), (None, None));
        assert_eq!(square.attributes, []);

        assert_eq!(triangle.mesh.faces, [[0, 1, 2]]);
        assert_eq!(triangle.mesh.positions[0], Vec3::new(0.0, 0.0, 0.5));
        let normals = triangle.normals.expect("they are there");
        assert_eq!(normals[0], Vec3::new(0.0, 0.0, 1.0));
        let error = (normals[1] - Vec3::new(0.0, 0.6, 0.8)).length();
        assert!(error < if is_double { 1e-15 } else { 1e-7 }, "{error}");
        assert_eq!(
            triangle.uvs.as_ref().expect("they are there")[0],
            [0.0, 0.25]
        );
        let [colours] = &triangle.attributes[..] else {
            panic!("one attribute")
        };
        assert_eq!(
            (colours.name.as_str(), colours.channels),
            ("vertex_color", 3)
        );
        assert_eq!(colours.data[..6], [0.0, 0.25, 0.5, 1.0, 1.0, 1.0]);

        let flat = read_serialized(&bytes, 0, false).expect("it is good");
        assert_eq!(flat.normals, None);
        assert_eq!(flat.mesh, triangle.mesh);
    }
}

/// In a scene: the name, texture coordinates as they are or flipped, flat faces.
#[test]
fn in_scenes() {
    let shape = |properties: &str| {
        let text = format!(
            "<shape type=\"serialized\"><string name=\"filename\" value=\"two.serialized\"/>\
             {properties}</shape>"
        );
        let mut scene = load(&scene(&text));
        (scene.shapes.remove(0), scene.textures)
    };
    let (triangle, textures) = shape("");
    assert_eq!(triangle.id, "triangle");
    let uvs = triangle.uvs.as_ref().expect("they are there");
    assert_eq!(uvs[..], [[[0.0, 0.25], [1.0, 0.0], [0.0, 1.0]]]);
    assert!(matches!(triangle.normals, ShadingNormals::Given(_)));
    assert_eq!(triangle.attributes[0].name, "vertex_color");
    let colours = textures.iter().find(|t| t.id == "triangle.vertex_color");
    assert!(matches!(
        colours.expect("listed").pattern,
        Pattern::PerVertex
    ));

    let (flipped, _) = shape("<boolean name=\"flip_tex_coords\" value=\"true\"/>");
    let uvs = flipped.uvs.as_ref().expect("they are there");
    assert_eq!(uvs[..], [[[0.0, 0.75], [1.0, 1.0], [0.0, 0.0]]]);
    let (flat, _) = shape("<boolean name=\"face_normals\" value=\"true\"/>");
    assert!(matches!(flat.normals, ShadingNormals::Face));

    let (square, _) = shape("<integer name=\"shape_index\" value=\"1\"/>");
    assert_eq!(square.id, "square");
    assert!(matches!(square.normals, ShadingNormals::Computed(_)));
    check(
        &scene(
            "<shape type=\"serialized\"><string name=\"filename\" value=\"two.serialized\"/>\
             <integer name=\"shape_index\" value=\"2\"/></shape>",
        ),
        &[
            "scene.xml:5:59: \"FOLDER/two.serialized\": there is no mesh 2",
            "  expected a shape_index from 0 to 1",
        ],
    );
}

#[test]
fn cut_off_anywhere_is_an_error() {
    for version in [3, 4] {
        let bytes = written(&triangle_and_square(), version);
        for length in 0..bytes.len() {
            for index in [0, 1] {
                let cut = read_serialized(&bytes[..length], index, true);
                assert!(
                    cut.is_err(),
                    "version {version}, mesh {index}, {length} bytes"
                );
            }
        }
    }
    // The same of what is deflated.
    let data = triangle_and_square()[0].unpacked(4);
    for length in 0..data.len() {
        let message = refused(&file_of(&[data[..length].to_vec()], 4), 0);
        assert!(message.starts_with("mesh 0: "), "{message}");
    }
}

#[test]
fn bad_files() {
    let [triangle, square] = triangle_and_square();
    let with = |change: &dyn Fn(&mut Contents)| {
        let mut changed = triangle.clone();
        change(&mut changed);
        refused(&written(&[changed], 4), 0)
    };
    let header = |bytes: &[u8]| {
        let mut file = written(std::slice::from_ref(&square), 4);
        file[..bytes.len()].copy_from_slice(bytes);
        refused(&file, 0)
    };
    let tail = |count: u32, offset: u64| {
        let mut file = written(std::slice::from_ref(&square), 4);
        file.truncate(file.len() - 12);
        file.extend(offset.to_le_bytes());
        file.extend(count.to_le_bytes());
        refused(&file, 0)
    };
    let counts = |vertices: u64, faces: u64| {
        let mut data = square.unpacked(4);
        data[11..19].copy_from_slice(&vertices.to_le_bytes());
        data[19..27].copy_from_slice(&faces.to_le_bytes());
        refused(&file_of(&[data], 4), 0)
    };
    let damaged = "the file is cut off or damaged";
    for (message, expected) in [
        (
            refused(b"\x1c", 0),
            format!("byte 0: the file ends within the header of a mesh; {damaged}"),
        ),
        (
            header(b"ply\n"),
            "byte 0: there is no serialized mesh; expected a file as written by Mitsuba, which \
             begins with the bytes 1c 04"
                .into(),
        ),
        (
            header(b"\x1c\x04\x05\x00"),
            "byte 0: the mesh is of version 5; expected version 3 or 4; convert the mesh to .ply"
                .into(),
        ),
        (
            refused(&written(&[square.clone(), square.clone()], 4), 2),
            "there is no mesh 2; expected a shape_index from 0 to 1".into(),
        ),
        (
            refused(&written(std::slice::from_ref(&square), 3), 1),
            "there is no mesh 1; expected shape_index 0: the file has one mesh".into(),
        ),
        (
            tail(u32::MAX, 0),
            format!(
                "end of the file: 4294967295 meshes are announced, which the file cannot hold; \
                 {damaged}"
            ),
        ),
        (
            tail(0, 0),
            format!(
                "end of the file: 0 meshes are announced, which the file cannot hold; {damaged}"
            ),
        ),
        (
            with(&|m| m.flags = 0x2000),
            "mesh 0: its flags are 0x300b: both of single and double precision; expected one of \
             0x1000 and 0x2000"
                .into(),
        ),
        (
            with(&|m| m.positions[1][2] = f64::NAN),
            "mesh 0: vertex 1 has the position (1, 0, NaN); expected finite coordinates".into(),
        ),
        (
            with(&|m| m.normals[2] = [0.0; 3]),
            "mesh 0: normal 2 is (0, 0, 0); expected a finite vector that is not zero; \
             face_normals does without normals"
                .into(),
        ),
        (
            with(&|m| m.uvs[1][0] = f64::INFINITY),
            "mesh 0: vertex 1 has the texture coordinates [inf, 0.0]; expected finite numbers"
                .into(),
        ),
        (
            with(&|m| m.colours[0][0] = f64::NAN),
            "mesh 0: vertex 0 has the colour [NaN, 0.25, 0.5]; expected finite numbers".into(),
        ),
        (
            with(&|m| m.faces[0][1] = 3),
            "mesh 0: face 0 refers to vertex 3; there are 3 vertices (counted from 0)".into(),
        ),
        (
            with(&|m| m.faces.clear()),
            "the file has no faces; expected a mesh with at least one triangle".into(),
        ),
        (
            file_error(&[square.unpacked(4), vec![7]].concat()),
            format!("mesh 0: more data follow the faces; {damaged}"),
        ),
    ] {
        assert_eq!(message, expected);
    }
    // Counts that the deflated bytes cannot hold, and some that they could.
    for [vertices, faces] in [[u64::MAX, 2], [4, u64::MAX], [1 << 40, 1 << 40]] {
        let message = counts(vertices, faces);
        let expected = format!("mesh 0: {vertices} vertices and {faces} faces are announced");
        assert!(message.starts_with(&expected), "{message}");
    }
    assert_eq!(
        counts(4, 1000),
        format!("mesh 0: the data end within the faces; {damaged}")
    );
    let message = tail(1, 1 << 40);
    assert!(message.contains("begin at byte 1099511627776"), "{message}");
    // One wrong bit in the checksum.
    let mut file = written(&[square], 4);
    let last = file.len() - 13;
    file[last] ^= 1;
    let message = refused(&file, 0);
    assert!(message.contains("cannot be unpacked: corrupt"), "{message}");
}

fn file_error(data: &[u8]) -> String {
    refused(&file_of(&[data.to_vec()], 4), 0)
}

/// Marks for flat faces have no effect, as in Mitsuba, but are not passed over
/// in silence.
#[test]
fn marked_as_flat() {
    let [_, square] = triangle_and_square();
    let bytes = written(
        &[Contents {
            flags: 0x10,
            ..square
        }],
        4,
    );
    let warnings = read(&bytes, 0).warnings;
    assert!(warnings[0].starts_with("is marked as flat"), "{warnings:?}");
    let flat = read_serialized(&bytes, 0, false).expect("it is good");
    assert_eq!(flat.warnings, Vec::<String>::new());
}

/// Flags that say nothing of what is in the file have no effect, as in Mitsuba.
#[test]
fn flags_without_meaning() {
    let [_, square] = triangle_and_square();
    let plain = read(&written(&[triangle_and_square()[1].clone()], 4), 0);
    let bytes = written(
        &[Contents {
            flags: 0x104,
            ..square
        }],
        4,
    );
    let marked = read(&bytes, 0);
    assert_eq!(marked.mesh, plain.mesh);
    let warnings = marked.warnings;
    assert!(
        warnings[0].starts_with("has the flags 0x104"),
        "{warnings:?}"
    );
}

/// A cup around the y axis, single precision, and a saucer below it, double.
fn cup_and_saucer() -> [Contents; 2] {
    let ring = |radius: f64, y: f64, sides: u32| {
        (0..=sides).map(move |i| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(sides);
            [radius * angle.cos(), y, -radius * angle.sin()]
        })
    };
    let quads = |sides: u32, below: u32, above: u32| {
        (0..sides).flat_map(move |i| {
            let [a, b] = [below + i, below + i + 1];
            let [c, d] = [above + i + 1, above + i];
            [[a, b, c], [a, c, d]]
        })
    };
    let mut cup = Contents {
        name: "cup",
        ..Contents::default()
    };
    // So many that true and interpolated normals hardly differ at silhouettes.
    const SIDES: u32 = 64;
    let profile = [(0.35, 0.0), (0.7, 1.0)];
    for &(radius, y) in &profile {
        cup.positions.extend(ring(radius, y, SIDES));
        for (i, [x, _, z]) in ring(1.0, 0.0, SIDES).enumerate() {
            cup.normals.push([x, -0.35, z]);
            cup.uvs.push([i as f64 / f64::from(SIDES), y]);
        }
    }
    cup.faces.extend(quads(SIDES, 0, SIDES + 1));
    let saucer = Contents {
        name: "saucer",
        positions: ring(0.3, 0.0, 9).chain(ring(1.1, 0.25, 9)).collect(),
        faces: quads(9, 10, 0).collect(),
        is_double: true,
        ..Contents::default()
    };
    [cup, saucer]
}

const PARITY: &str = "../../tests/parity/cup.serialized";

/// Writes the meshes of `tests/parity/serialized.xml`:
/// `cargo test -p capwalk-scene-io --test reading write_cup -- --ignored`.
#[test]
#[ignore = "writes a file of the repository"]
fn write_cup() {
    std::fs::write(PARITY, written(&cup_and_saucer(), 4)).expect("the folder is there");
    std::fs::write(
        folder().join("two.serialized"),
        written(&triangle_and_square(), 4),
    )
    .expect("the folder is there");
}

#[test]
fn the_cup_of_the_parity_scene_is_the_one_of_these_tests() {
    let (kept, fresh) = (std::fs::read(PARITY), written(&cup_and_saucer(), 4));
    let kept = kept.expect("it is in the repository");
    for index in [0, 1] {
        let [kept, fresh] = [read(&kept, index), read(&fresh, index)];
        assert_eq!(kept.name, fresh.name);
        assert_eq!(kept.mesh.faces, fresh.mesh.faces);
        // Sines may differ in the last digit.
        let pairs = kept.mesh.positions.iter().zip(&fresh.mesh.positions);
        assert!(pairs.into_iter().all(|(a, b)| (*a - *b).length() < 1e-6));
    }
}
