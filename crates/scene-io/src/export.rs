//! A [`Scene`] as files that Mitsuba 3 and capwalk read: one XML file, one PLY
//! file per shape, and one EXR file per bitmap.
//!
//! Numbers are written with all their digits and meshes in double precision,
//! so loading the files gives the same scene again: to the bit, but for given
//! normals, the sensor's rotation and its field of view, which are normalised
//! or computed anew and may differ in the last digit. Mitsuba rounds to its own
//! precision when it loads.
//!
//! Texels of bitmaps are written in single precision.
//!
//! Two things cannot be told in XML: materials come back in the order in which
//! they are first used, and the constant emitter comes back behind the area emitters.
//! Mitsuba takes seeds below 2³² only.

mod beside;
mod error;
mod shape_file;
mod xml_file;

use std::collections::HashSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use capwalk_scene::{Image, Pattern, Scene, Texture, TextureId};

use beside::Files;
pub use error::ExportError;

use crate::atomic::write_one_of_many;
use crate::files::read_file;
use crate::image::{LayeredImage, VALUE, encode_exr};
use crate::mesh::write_ply;

/// Writes the scene and returns the path of its XML file. A path that ends in
/// `.xml` is that file; any other is a directory to put `scene.xml` into. The
/// meshes go to a directory beside the XML, named after it: `scene_meshes`;
/// bitmaps to `scene_textures`.
/// Directories are made where they are missing, files of the same name
/// replaced.
pub fn write_scene(scene: &Scene, path: &Path) -> Result<PathBuf, ExportError> {
    each_file(scene, path, |path, bytes| {
        if let Some(directory) = path.parent() {
            at(directory, fs::create_dir_all(directory))?;
        }
        at(path, write_one_of_many(path, |file| file.write_all(bytes)))
    })
}

/// [`write_scene`] that replaces nothing: a file that is there already and has other contents is
/// an error, and nothing is written.
pub fn write_new_scene(scene: &Scene, path: &Path) -> Result<PathBuf, ExportError> {
    each_file(scene, path, |path, bytes| {
        let is_equal = match path.symlink_metadata() {
            Err(_) => true,
            Ok(found) => found.len() == bytes.len() as u64 && is_file_of(path, bytes),
        };
        match is_equal {
            true => Ok(()),
            false => Err(ExportError::InTheWay { path: path.into() }),
        }
    })?;
    write_scene(scene, path)
}

/// True if a file has these bytes.
fn is_file_of(path: &Path, bytes: &[u8]) -> bool {
    read_file(path).is_ok_and(|found| found == bytes)
}

/// Shows the bytes of each file of a scene, the XML file last: where it is, the files that it
/// names are. Returns its path.
fn each_file(
    scene: &Scene,
    path: &Path,
    mut show: impl FnMut(&Path, &[u8]) -> Result<(), ExportError>,
) -> Result<PathBuf, ExportError> {
    let is_xml = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("xml"));
    let xml_path = match is_xml {
        true => path.to_owned(),
        false => path.join("scene.xml"),
    };
    let stem = xml_path.file_stem().unwrap_or_default().to_string_lossy();
    let folder = format!("{stem}_meshes");
    let directory = xml_path.with_file_name(&folder);

    let mut files = Files::default();
    let names = file_names(scene.shapes.iter().map(|s| s.id.as_str()), "ply");
    for (shape, name) in scene.shapes.iter().zip(&names) {
        let path = directory.join(name);
        let mut bytes = Vec::new();
        at(
            &path,
            write_ply(&shape_file::mesh_file(scene, shape), &mut bytes),
        )?;
        show(&path, &bytes)?;
        files.meshes.push(format!("{folder}/{name}"));
    }

    let folder = format!("{stem}_textures");
    let directory = xml_path.with_file_name(&folder);
    let bitmaps = scene.textures.iter().enumerate();
    let bitmaps: Vec<_> = bitmaps
        .filter_map(|(i, texture)| {
            let size = match &texture.pattern {
                Pattern::Bitmap(bitmap) => [bitmap.width, bitmap.height],
                Pattern::Environment => {
                    let map = scene.environment_map_of(TextureId(i as u32))?;
                    [map.width, map.height]
                }
                _ => return None,
            };
            Some((i, texture, size))
        })
        .collect();
    let names = file_names(bitmaps.iter().map(|(_, t, _)| t.id.as_str()), "exr");
    for ((i, texture, size), name) in bitmaps.into_iter().zip(names) {
        let path = directory.join(&name);
        let bytes = exr_of(texture, size).map_err(|reason| ExportError::Encode {
            path: path.clone(),
            reason,
        })?;
        show(&path, &bytes)?;
        files.bitmaps.insert(i, format!("{folder}/{name}"));
    }
    let text = xml_file::text(scene, &files);
    show(&xml_path, text.as_bytes())?;
    Ok(xml_path)
}

fn at<T>(path: &Path, result: io::Result<T>) -> Result<T, ExportError> {
    result.map_err(|error| ExportError::Write {
        path: path.to_owned(),
        error,
    })
}

fn exr_of(texture: &Texture, size: [u32; 2]) -> Result<Vec<u8>, String> {
    let [width, height] = size.map(|n| n as usize);
    let pixels = (0..texture.texels()).map(|i| texture.texel(i)).collect();
    let mut layered = LayeredImage::default();
    layered.push(
        VALUE,
        Image {
            width,
            height,
            pixels,
        },
    );
    encode_exr(&layered, [width, height])
}

/// The longest part of an id in a file name, characters: file systems take 255 bytes in all.
const LONGEST_NAME: usize = 60;

/// A file name for each id: the beginning of the id, with what file systems dislike replaced
/// by `_`, and a number where two would be the same in any case.
fn file_names<'a>(ids: impl Iterator<Item = &'a str>, ending: &str) -> Vec<String> {
    let mut taken = HashSet::new();
    let plain = |c: char| c.is_alphanumeric() || "-_.".contains(c);
    let name_of = |id: &str| {
        let start = id.chars().take(LONGEST_NAME);
        let name: String = start.map(|c| if plain(c) { c } else { '_' }).collect();
        // No hidden files.
        match name.strip_prefix('.') {
            Some(rest) => format!("_{rest}"),
            None => name,
        }
    };
    let unique = |id: &str| {
        let name = name_of(id);
        let numbered = (2..).map(|n: u64| format!("{name}_{n}"));
        let mut candidates = std::iter::once(name.clone()).chain(numbered);
        let free = candidates
            .find(|candidate| taken.insert(candidate.to_lowercase()))
            .expect("numbers do not run out before names do");
        format!("{free}.{ending}")
    };
    ids.map(unique).collect()
}

#[cfg(test)]
mod tests;
