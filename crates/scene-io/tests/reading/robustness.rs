//! Damaged files: thousands of them, the same ones in every run. Each is read or
//! refused; nothing panics, and nothing reserves memory that the file does not
//! pay for.

use capwalk_scene_io::mesh::{read_obj, read_ply};

use crate::common::*;

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
const PIECES: [&str; 20] = [
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
];

/// One to four changes of a text: cut, deleted, repeated, replaced, inserted.
fn damage(original: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = original.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..end)),
            2 => {
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
            3 if at < bytes.len() => bytes[at] = random.below(256) as u8,
            4 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            _ => {
                let piece = PIECES[random.below(PIECES.len())];
                bytes.splice(at..at, piece.bytes());
            }
        }
    }
    bytes
}

#[test]
fn damaged_scenes() {
    let original = scene(
        "<path value=\".\"/>\
         <include filename=\"one_material.xml\"/><alias id=\"grey\" as=\"gray\"/>\
         <bsdf type=\"twosided\" id=\"m\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" \
         value=\"#ff8000\"/></bsdf><ref id=\"gray\"/></bsdf>\
         <shape type=\"obj\" id=\"s\"><string name=\"filename\" value=\"square.obj\"/>\
         <transform name=\"to_world\"><lookat origin=\"1 2 3\" target=\"0 0 0\" up=\"0 1 0\"/>\
         <rotate x=\"1\" angle=\"$w\"/><matrix value=\"1 0 0 0 1 0 0 0 1\"/></transform>\
         <ref id=\"m\"/><emitter type=\"area\"><spectrum name=\"radiance\" value=\"3\"/></emitter>\
         </shape><shape type=\"cube\"><boolean name=\"flip_normals\" value=\"true\"/></shape>",
    )
    .replace(
        "version=\"3.0.0\">",
        "version=\"3.0.0\"><default name=\"w\" value=\"16\"/>",
    )
    .replace(
        "\"perspective\"/>",
        "\"perspective\"><float name=\"fov\" value=\"40\"/><film type=\"hdrfilm\"><integer \
         name=\"width\" value=\"$w\"/><rfilter type=\"tent\"/></film><sampler \
         type=\"independent\"/></sensor>",
    );
    load(&original);
    let mut random = Random(1);
    let mut loaded = 0;
    for _ in 0..6000 {
        let damaged = damage(original.as_bytes(), &mut random);
        let text = String::from_utf8_lossy(&damaged);
        match try_load(&text, &[]) {
            Ok(_) => loaded += 1,
            Err(error) => {
                let message = error.to_string();
                assert!(
                    !message.is_empty() && message.contains(".xml:"),
                    "{message}"
                );
                if let Some(position) = error.position() {
                    assert!(position.span.start <= position.span.end, "{message}");
                }
            }
        }
    }
    // The damage is of the interesting kind: some survive it, most do not.
    assert!((20..3000).contains(&loaded), "{loaded}");
}

#[test]
fn damaged_obj_meshes() {
    let original = "# mesh\no a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvn 0 0 1\n\
                    f 1/1/1 2/1/1 3/1/1 4/1/1\nf -1/1/1 -2/1/1 -3/1/1\ns off\n";
    let mut random = Random(2);
    let mut read = 0;
    for _ in 0..20_000 {
        let damaged = damage(original.as_bytes(), &mut random);
        for want_normals in [false, true] {
            if let Ok(file) = read_obj(&damaged, want_normals) {
                file.mesh.check().expect("what is read is usable");
                read += 1;
            }
        }
    }
    assert!((1000..39_000).contains(&read), "{read}");
}

#[test]
fn damaged_ply_meshes() {
    let header = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property float z\nproperty list uchar uchar extra\nelement face 1\n\
             property list uchar int vertex_indices\nend_header\n"
        )
    };
    let text = format!("{}0 0 0 0\n1 0 0 1 7\n0 1 0 0\n3 0 1 2\n", header("ascii"));
    let mut binary = header("binary_little_endian").into_bytes();
    for p in [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
        p.iter().for_each(|x| binary.extend(x.to_le_bytes()));
        binary.extend([1, 9]);
    }
    binary.push(3);
    [0_i32, 1, 2]
        .iter()
        .for_each(|i| binary.extend(i.to_le_bytes()));
    let mut random = Random(3);
    let mut read = 0;
    for original in [text.as_bytes(), &binary[..]] {
        read_ply(original, true).expect("it is good before it is damaged");
        for _ in 0..10_000 {
            let damaged = damage(original, &mut random);
            if let Ok(file) = read_ply(&damaged, true) {
                file.mesh.check().expect("what is read is usable");
                read += 1;
            }
        }
    }
    assert!((200..19_000).contains(&read), "{read}");
}

/// Neither the parser of XML nor what comes after it may run out of stack.
#[test]
fn deep_nesting_is_refused() {
    let deep = format!("{HEAD}{}", "<bsdf type=\"twosided\">".repeat(100_000));
    assert!(try_load(&deep, &[]).is_err());
    let closed = format!("{deep}{}</scene>", "</bsdf>".repeat(100_000));
    assert!(try_load(&closed, &[]).is_err());
}

/// A chain of references is followed without recursion.
#[test]
fn long_chains_of_references() {
    let mut objects = String::new();
    for i in 0..20_000 {
        let next = i + 1;
        objects += &format!("<bsdf type=\"twosided\" id=\"b{i}\"><ref id=\"b{next}\"/></bsdf>");
    }
    objects += "<bsdf type=\"diffuse\" id=\"b20000\"/>";
    let error = message(&scene(&objects), &[]);
    assert!(error.contains("twosided"), "{error}");
}
