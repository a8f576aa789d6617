//! What `docs/scene-files.md` says of a material's properties are its fields, and their defaults.

use std::convert::Infallible;
use std::fs;

use capwalk_scene::fields::{FieldReader, WithoutEffect};
use capwalk_scene::lobe::{Distribution, Lobe, Microfacets};
use capwalk_scene::number::{Indices, PrincipledIndex};
use capwalk_scene::{Quantity, TextureId};

/// A material's properties, and its defaults.
#[derive(Debug, Default, PartialEq)]
struct Row(Vec<(String, String)>);

/// Stands for any texture.
const SOME: TextureId = TextureId(0);

impl Row {
    fn add(&mut self, name: &str, default: impl ToString) {
        self.0.push((name.into(), default.to_string()));
    }
}

impl FieldReader for Row {
    type Error = Infallible;

    fn without_effect(&mut self, _: WithoutEffect) {}

    fn colour(
        &mut self,
        name: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Infallible> {
        self.number(name, quantity, default)
    }

    fn number(
        &mut self,
        name: &'static str,
        _: Quantity,
        default: f64,
    ) -> Result<TextureId, Infallible> {
        self.add(name, default);
        Ok(SOME)
    }

    fn indices(
        &mut self,
        _: &'static str,
        _: Quantity,
        inside: &'static str,
        outside: &'static str,
    ) -> Result<Indices, Infallible> {
        self.add("int_ior", format!("`{inside}`"));
        self.add("ext_ior", format!("`{outside}`"));
        Ok(Indices {
            int_ior: SOME,
            ext_ior: SOME,
        })
    }

    fn index(&mut self, name: &'static str, specular: f64) -> Result<PrincipledIndex, Infallible> {
        self.add(&format!("{name}` or `specular"), specular);
        Ok(PrincipledIndex::Specular(SOME))
    }

    fn facets(
        &mut self,
        _: &'static str,
        alpha: f64,
    ) -> Result<Microfacets<TextureId>, Infallible> {
        let distribution = self.distribution("distribution")?;
        self.add("alpha", alpha);
        Ok(Microfacets::isotropic(distribution, SOME))
    }

    fn distribution(&mut self, name: &'static str) -> Result<Distribution, Infallible> {
        let [first, second] = Distribution::ALL.map(Distribution::name);
        self.add(name, format!("`{first}`, or `{second}`"));
        Ok(Distribution::ALL[0])
    }

    fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Infallible> {
        self.add(name, default);
        Ok(default)
    }
}

/// Names in backticks that commas part, or one with its alternative, and behind them their default in
/// parentheses: all such of a text.
fn written(mut text: &str) -> Row {
    let mut row = Row::default();
    while let Some((before, behind)) = text.split_once(" (") {
        let (default, rest) = behind.split_once(')').expect("it closes");
        text = rest;
        let names = before.rsplit([';', '.', ':']).next().unwrap_or(before);
        let names: Vec<&str> = names.split(", ").map(str::trim).collect();
        // What has a default before the next one, in words: `or material`, `which is one number`.
        let named = names.iter().map(|name| name.trim_start_matches("and "));
        for name in named.filter(|name| name.starts_with('`')) {
            row.add(name.trim_matches('`'), default);
        }
    }
    row
}

#[test]
fn rows_of_materials_are_their_fields() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scene-files.md");
    let document = fs::read_to_string(path).expect("it can be read");
    for plugin in Lobe::PLUGINS {
        let mut fields = Row::default();
        let read = Lobe::read(plugin, &mut fields).expect("a plugin of the list");
        assert_eq!(read.map(|lobe| lobe.plugin()), Ok(*plugin));
        let mut rows = document.lines().filter_map(|line| {
            let (plugins, properties) = line.strip_prefix("| `")?.split_once(" | ")?;
            let mut plugins = plugins.split(", ").map(|name| name.trim_matches('`'));
            plugins.any(|name| name == *plugin).then_some(properties)
        });
        let row = rows.next().unwrap_or_else(|| panic!("no row of {plugin}"));
        assert_eq!(written(row), fields, "{plugin}: {row}");
    }
}
