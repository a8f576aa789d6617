//! What a folder of `tests/scenes` says: a scene, and what is to be checked.

use std::path::{Path, PathBuf};

use capwalk_scene::Scene;
use serde_json::Value;

/// The cutoff of walks, degrees: 0.2 rad. One that is given is that of both modes, where a
/// pilot would choose one in each, and asks for the method walk.
pub const WIDE: &str = "11.459155902616466";

/// A phenomenon.
pub struct Folder {
    pub name: String,
    path: PathBuf,
}

/// A parameter of the scene, and what its derivative must be like.
pub struct Check {
    /// As it is typed after `capwalk check -p`.
    pub parameter: String,
    pub demand: Demand,
}

pub enum Demand {
    /// It agrees with finite differences.
    Agree(Differences),
    /// It is refused, in a message with these words.
    Refuse(Vec<String>),
}

/// The finite differences that a derivative is compared with.
pub struct Differences {
    /// In units of the parameter.
    pub step: f64,
    /// Samples per pixel, on either side.
    pub spp: u32,
    /// Those of the derivative that is compared; `None`: the scene's.
    pub derivative_spp: Option<u32>,
    /// How many pixels must have noise; `None`: half of them.
    pub pixels: Option<usize>,
    /// What `--method edges` is like.
    pub edges: Edges,
}

/// What gathered edges have to do with a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// They agree with the differences, too.
    Gathered,
    /// None are gathered: it walks.
    Walked,
    /// They are too noisy to be compared.
    Noisy,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/scenes")
}

/// The folders, in alphabetical order.
pub fn all() -> Vec<Folder> {
    let entries = std::fs::read_dir(root()).expect("tests/scenes");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let names = paths.filter(|path| path.is_dir()).map(|path| {
        let name = path.file_name().expect("a folder").to_str();
        name.expect("a name of plain letters").to_owned()
    });
    let mut names: Vec<String> = names.collect();
    names.sort();
    names.iter().map(|name| Folder::new(name)).collect()
}

impl Folder {
    pub fn new(name: &str) -> Self {
        let path = root().join(name);
        Self {
            name: name.into(),
            path,
        }
    }

    /// The scene file, as an argument of the command.
    pub fn scene_file(&self) -> String {
        let file = self.path.join("scene.xml").canonicalize();
        let file = file.unwrap_or_else(|error| panic!("{}/scene.xml: {error}", self.name));
        file.to_str().expect("a path of plain letters").to_owned()
    }

    pub fn scene(&self) -> Scene {
        let scene = capwalk_scene_io::load_scene(self.scene_file().as_ref(), &[]);
        scene.unwrap_or_else(|error| panic!("{error}")).scene
    }

    /// The comment at the top of the scene file, which says what is to be seen.
    pub fn sentence(&self) -> String {
        let text = self.text("scene.xml");
        let comment = text
            .strip_prefix("<!-- ")
            .and_then(|text| text.split_once(" -->"));
        let (sentence, _) = comment.unwrap_or_else(|| panic!("{} has no sentence", self.name));
        sentence.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// What `check.json` demands.
    pub fn checks(&self) -> Vec<Check> {
        let text = self.text("check.json");
        let value: Value = serde_json::from_str(&text)
            .unwrap_or_else(|error| panic!("{}/check.json: {error}", self.name));
        let list = value.as_array().filter(|list| !list.is_empty());
        let list = list.unwrap_or_else(|| panic!("{}/check.json: expected a list", self.name));
        let check = |value| {
            let check = Check::read(value);
            check.unwrap_or_else(|| panic!("{}/check.json: cannot use {value}", self.name))
        };
        list.iter().map(check).collect()
    }

    fn text(&self, file: &str) -> String {
        let text = std::fs::read_to_string(self.path.join(file));
        text.unwrap_or_else(|error| panic!("{}/{file}: {error}", self.name))
    }
}

impl Check {
    /// `None` if a key is missing, of the wrong kind, or unknown.
    fn read(value: &Value) -> Option<Self> {
        let object = value.as_object()?;
        let known = [
            "parameter",
            "step",
            "reference_spp",
            "spp",
            "pixels",
            "edges_walked",
            "edges_noisy",
            "refused",
        ];
        if !object.keys().all(|key| known.contains(&key.as_str())) {
            return None;
        }
        let parameter = object.get("parameter")?.as_str()?.to_owned();
        // With the reason.
        let edges = match (object.get("edges_walked"), object.get("edges_noisy")) {
            (None, None) => Edges::Gathered,
            (Some(Value::String(_)), None) => Edges::Walked,
            (None, Some(Value::String(_))) => Edges::Noisy,
            _ => return None,
        };
        let demand = match object.get("refused") {
            Some(words) => {
                let words = words.as_array()?.iter();
                let words = words.map(|word| Some(word.as_str()?.to_owned()));
                Demand::Refuse(words.collect::<Option<_>>()?)
            }
            None => Demand::Agree(Differences {
                step: object.get("step")?.as_f64()?,
                spp: object.get("reference_spp")?.as_u64()?.try_into().ok()?,
                derivative_spp: match object.get("spp") {
                    Some(count) => Some(count.as_u64()?.try_into().ok()?),
                    None => None,
                },
                pixels: match object.get("pixels") {
                    Some(count) => Some(count.as_u64()? as usize),
                    None => None,
                },
                edges,
            }),
        };
        Some(Self { parameter, demand })
    }
}
