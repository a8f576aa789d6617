//! Where images go: places that are known to be writable before the work
//! starts, and what an image's file says about how it was made.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use capwalk::scene_io::image::{self, LayeredImage, Panel, Preview, Scale};
use capwalk::{Error, Estimate, FilesRead, Image, RenderOptions, Setting, Statistics};

use crate::args::SceneArgs;

/// Output files of a command, checked.
pub struct Files {
    paths: Vec<PathBuf>,
    /// How pictures look.
    preview: Preview,
}

impl Files {
    /// The files that were asked for, or `stem` with the default endings.
    /// Folders are created; a file that cannot be written is an error now, and so is one of
    /// those that were `read`.
    pub fn new(asked: &[PathBuf], stem: &str, endings: &[&str], read: &FilesRead) -> Result<Self> {
        let paths = if asked.is_empty() {
            let endings = endings.iter();
            endings
                .map(|ending| PathBuf::from(format!("{stem}.{ending}")))
                .collect()
        } else {
            asked.to_vec()
        };
        let mut made = Vec::new();
        let checked = Self::check(&paths, read, &mut made);
        if checked.is_err() {
            // What something is in by now stays.
            made.iter()
                .rev()
                .for_each(|folder| drop(fs::remove_dir(folder)));
        }
        checked.map(|()| Self {
            paths,
            preview: Preview::default(),
        })
    }

    /// The same files, where the colours of derivatives end there.
    pub fn limited(self, limit: Option<f64>) -> Self {
        let preview = Preview {
            limit,
            ..self.preview
        };
        Self { preview, ..self }
    }

    /// The colours of derivatives or differences in panels.
    pub fn scale<'a>(&self, images: impl IntoIterator<Item = &'a Image>) -> Scale {
        self.preview.scale(images)
    }

    /// Makes sure that the files can be written, in folders that are `made` for them.
    fn check(paths: &[PathBuf], read: &FilesRead, made: &mut Vec<PathBuf>) -> Result<()> {
        for path in paths {
            read.refuse(path).map_err(Error::from)?;
            let folders = path.ancestors().skip(1);
            let missing = folders.take_while(|at| !at.as_os_str().is_empty() && !at.exists());
            let mut missing: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
            missing.reverse();
            made.extend(missing);
            make_folder(path)?;
            image::check_writable(path)?;
        }
        refuse_repeated(paths)
    }

    /// Writes the image into all files, pictures as these panels if there
    /// are any. Returns the files' names.
    pub fn write(&self, layered: &LayeredImage, panels: &[Panel]) -> Result<Vec<String>> {
        for path in &self.paths {
            if image::is_picture(path) && !panels.is_empty() {
                image::write_panels(path, panels, &layered.metadata)?;
            } else {
                image::write(path, layered, &self.preview)?;
            }
        }
        let names = self.paths.iter();
        Ok(names.map(|path| path.display().to_string()).collect())
    }
}

/// Refuses two names of one file, whose folder is there.
fn refuse_repeated(paths: &[PathBuf]) -> Result<()> {
    let place = |path: &Path| {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).canonicalize();
        folder.map(|folder| folder.join(path.file_name().unwrap_or_default()))
    };
    let mut seen: Vec<PathBuf> = Vec::new();
    for path in paths {
        // A file that is there may have several names.
        let place = path.canonicalize().or_else(|_| place(path))?;
        ensure!(
            !seen.contains(&place),
            "the file {} is to be written twice; name each file once",
            path.display()
        );
        seen.push(place);
    }
    Ok(())
}

/// Creates the folder that a file is to be in.
pub fn make_folder(path: &Path) -> Result<()> {
    if let Some(folder) = path.parent().filter(|p| !p.as_os_str().is_empty()) {
        fs::create_dir_all(folder).with_context(|| {
            format!(
                "cannot write {}: cannot create the folder {}",
                path.display(),
                folder.display()
            )
        })?;
    }
    Ok(())
}

/// An image to be filled with layers, which says what was asked for.
pub fn layered(
    command: &str,
    scene: &SceneArgs,
    parameter: Option<&str>,
    options: &RenderOptions,
) -> LayeredImage {
    let mut layered = LayeredImage {
        metadata: origin(command, scene, options),
        ..LayeredImage::default()
    };
    if let Some(name) = parameter {
        note(&mut layered, "parameter", name);
    }
    layered
}

/// What every file says about how it was made.
pub fn origin(command: &str, scene: &SceneArgs, options: &RenderOptions) -> Vec<(String, String)> {
    let pair = |key: &str, value: String| (key.to_owned(), value);
    let mut pairs = vec![
        pair("command", command.into()),
        pair("scene", scene.scene.clone()),
        pair("seed", options.seed.to_string()),
        pair("spp", options.spp.to_string()),
        pair("version", env!("CARGO_PKG_VERSION").into()),
    ];
    if !scene.settings.is_empty() {
        let settings: Vec<String> = scene.settings.iter().map(Setting::to_string).collect();
        pairs.push(pair("set", settings.join("; ")));
    }
    pairs
}

/// Adds to what an image says about itself.
pub fn note(layered: &mut LayeredImage, key: &str, value: impl ToString) {
    layered.metadata.push((key.to_owned(), value.to_string()));
}

/// Says which GPU computed an image, if one did.
pub fn note_device(layered: &mut LayeredImage, statistics: &Statistics) {
    if let Some(name) = &statistics.device.gpu {
        note(layered, "device", name);
    }
}

/// Says what was done, for an image whose layers all come from these pieces of
/// work: the counts are sums, and it is complete if all of them are.
pub fn push_statistics(layered: &mut LayeredImage, pieces: &[&Statistics]) {
    let sum = |of: fn(&Statistics) -> u64| pieces.iter().map(|s| of(s)).sum::<u64>();
    note(layered, "samples", sum(|s| s.samples));
    note(layered, "complete", pieces.iter().all(|s| s.complete));
    note(layered, "non_finite_samples", sum(|s| s.non_finite));
    let counts = pieces.iter().map(|s| s.samples_per_pixel.clone());
    layered.samples = counts.reduce(|sum, more| {
        let pairs = sum.iter().zip(&more);
        pairs.map(|(a, b)| a.saturating_add(*b)).collect()
    });
}

/// Adds an estimate as a layer and another with its standard errors: `stderr`
/// for what the command is about, `<name>_stderr` for what comes with it.
pub fn push_estimate(layered: &mut LayeredImage, name: &str, errors: &str, estimate: &Estimate) {
    layered.push(name, estimate.mean.clone());
    layered.push(errors, estimate.standard_error.clone());
}
