//! Text to elements: XML syntax, and nothing of what it means.

use roxmltree::{Document, ParsingOptions};

use crate::problem::Problem;
use crate::texts::{FileId, Span, Texts};

/// Elements nested more deeply are an error; Mitsuba's formats need six levels.
const DEEPEST_NESTING: usize = 32;

/// Attributes of one element, at most; Mitsuba's formats have six. The parser compares
/// each with all others.
const MOST_ATTRIBUTES: usize = 64;

/// How declarations of namespaces begin. The parser looks at those of all elements around
/// each.
const NAMESPACE: &str = "xmlns";

/// Elements, attributes and texts in one file, at most: far more than any scene
/// written by hand or by an exporter, and a bound on memory.
const MOST_NODES: u32 = 1 << 24;

/// An XML element without its text.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub tag: String,
    /// The `<` and the tag's name.
    pub span: Span,
    pub attributes: Vec<Attribute>,
    pub children: Vec<Element>,
}

/// An attribute of an element.
#[derive(Clone, Debug)]
pub(crate) struct Attribute {
    pub name: String,
    pub value: String,
    pub name_span: Span,
    pub value_span: Span,
}

impl Element {
    pub fn attribute(&self, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|a| a.name == name)
    }

    /// The value of an attribute that must be there.
    pub fn required(&self, name: &str) -> Result<&Attribute, Problem> {
        self.attribute(name).ok_or_else(|| {
            Problem::missing(
                self.span,
                format!("<{}> has no attribute \"{name}\"", self.tag),
            )
            .help(format!("write <{} {name}=\"...\">", self.tag))
        })
    }

    /// Refuses attributes with other names than these.
    pub fn only_attributes(&self, known: &[&str]) -> Result<(), Problem> {
        let unknown = self
            .attributes
            .iter()
            .find(|a| !known.contains(&a.name.as_str()));
        let Some(attribute) = unknown else {
            return Ok(());
        };
        let known_names = match known {
            [] => "it has none".into(),
            _ => format!("its attributes are {}", known.join(", ")),
        };
        Err(Problem::unknown(
            attribute.name_span,
            format!("unknown attribute \"{}\" of <{}>", attribute.name, self.tag),
        )
        .help(known_names)
        .near(crate::suggest::nearest(
            &attribute.name,
            known.iter().copied(),
        )))
    }
}

/// The root element of a text, and places of stray text, which has no effect.
pub(crate) fn parse(texts: &Texts, file: FileId) -> Result<(Element, Vec<Span>), Problem> {
    let text = &texts.get(file).content;
    refuse_costly_tags(text, file)?;
    let options = ParsingOptions {
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    let document =
        Document::parse_with_options(text, options).map_err(|error| syntax(text, file, &error))?;
    let mut stray = Vec::new();
    let root = convert(document.root_element(), file, &mut stray);
    Ok((root, stray))
}

/// Finds tags as the parser does, counts what could be attributes in them, and refuses what
/// costs the parser, and what comes after it, more time or stack than the file is long.
fn refuse_costly_tags(text: &str, file: FileId) -> Result<(), Problem> {
    let behind = |from: usize, end: &str| text[from..].find(end).map(|at| from + at + end.len());
    let (mut at, mut depth) = (0, 0_usize);
    while let Some(tag) = text[at..].find('<').map(|found| at + found) {
        let rest = &text[tag..];
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        let end = match skipped.iter().find(|(start, _)| rest.starts_with(start)) {
            Some((start, end)) => behind(tag + start.len(), end),
            None => tag_end(text, tag, file)?,
        };
        let Some(end) = end else {
            return Ok(()); // The parser says what is missing.
        };
        at = end;
        match &text[tag..end] {
            tag if tag.starts_with("</") => depth = depth.saturating_sub(1),
            tag if tag.starts_with("<!") || tag.starts_with("<?") || tag.ends_with("/>") => {}
            _ => depth += 1,
        }
        if depth > DEEPEST_NESTING {
            return Err(too_deep(&text[tag..end], depth, file, tag));
        }
    }
    Ok(())
}

/// The error for an element that begins with this tag, at `start`.
fn too_deep(tag: &str, depth: usize, file: FileId, start: usize) -> Problem {
    let name = &tag[1..];
    let end = name.find(|c: char| c.is_whitespace() || c == '>');
    let name = &name[..end.unwrap_or(name.len())];
    let end = start + 1 + name.len();
    let message = format!("<{name}> is nested {depth} elements deep");
    Problem::unsupported(Span { file, start, end }, message)
        .help(format!("at most {DEEPEST_NESTING} are read"))
}

/// The place behind a tag, if it ends.
fn tag_end(text: &str, tag: usize, file: FileId) -> Result<Option<usize>, Problem> {
    let (mut quote, mut attributes) = (None, 0);
    let bytes = text.as_bytes();
    let is_between = |byte: u8| byte.is_ascii_whitespace() || byte == b'\'' || byte == b'"';
    for (i, &byte) in bytes.iter().enumerate().skip(tag) {
        match (quote, byte) {
            (None, b'>') => return Ok(Some(i + 1)),
            (None, b'\'' | b'"') => quote = Some(byte),
            (Some(open), _) if byte == open => quote = None,
            (None, b'=') => attributes += 1,
            (None, b'x') if text[i..].starts_with(NAMESPACE) && is_between(bytes[i - 1]) => {
                let (start, end) = (i, i + NAMESPACE.len());
                let span = Span { file, start, end };
                return Err(Problem::unsupported(span, "scene files have no namespaces")
                    .help("remove \"xmlns...\" and prefixes of names"));
            }
            _ => {}
        }
        if attributes > MOST_ATTRIBUTES {
            let span = Span {
                file,
                start: tag,
                end: tag + 1,
            };
            let message = format!("an element has more than {MOST_ATTRIBUTES} attributes");
            return Err(Problem::unsupported(span, message)
                .help("remove those that mean nothing, or add a quotation mark that is missing"));
        }
    }
    Ok(None)
}

/// The element of a node, which is not nested deeper than [`refuse_costly_tags`] lets pass.
fn convert(node: roxmltree::Node<'_, '_>, file: FileId, stray: &mut Vec<Span>) -> Element {
    let tag = node.tag_name().name().to_owned();
    let span = |start, end| Span { file, start, end };
    let start = node.range().start;
    let element_span = span(start, start + 1 + tag.len());
    let attributes = node
        .attributes()
        .map(|a| {
            let (name, value) = (a.range_qname(), a.range_value());
            Attribute {
                name: a.name().into(),
                value: a.value().into(),
                name_span: span(name.start, name.end),
                value_span: span(value.start, value.end),
            }
        })
        .collect();
    let mut children = Vec::new();
    for child in node.children() {
        if child.is_element() {
            children.push(convert(child, file, stray));
        } else if child.is_text() && !child.text().unwrap_or("").trim().is_empty() {
            let blank = child.text().map_or(0, |t| t.len() - t.trim_start().len());
            stray.push(span(child.range().start + blank, child.range().end));
        }
    }
    Element {
        tag,
        span: element_span,
        attributes,
        children,
    }
}

/// The parser's complaint at its place.
fn syntax(text: &str, file: FileId, error: &roxmltree::Error) -> Problem {
    use roxmltree::Error as E;
    let at_end = matches!(
        error,
        E::UnclosedRootNode | E::UnexpectedEndOfStream | E::NoRootNode
    );
    let offset = match at_end {
        true => text.trim_end().len(),
        false => byte_offset(text, error.pos()),
    };
    // The parser's own text ends with the position, which we show in front.
    let complaint = error.to_string();
    let complaint = match complaint.rsplit_once(" at ") {
        Some((words, place)) if place.bytes().all(|b| b.is_ascii_digit() || b == b':') => words,
        _ => &complaint,
    };
    let help = match error {
        E::DtdDetected => "remove the <!DOCTYPE ...>; scene files need none",
        E::UnclosedRootNode | E::UnexpectedEndOfStream => {
            "the file ends too early; close every element"
        }
        E::NoRootNode => "a scene file contains <scene version=\"3.0.0\"> ... </scene>",
        _ => "correct the XML syntax here",
    };
    let span = Span {
        file,
        start: offset,
        end: offset,
    };
    Problem::syntax(span, format!("malformed XML: {complaint}")).help(help)
}

/// The byte at a line and column.
fn byte_offset(text: &str, position: roxmltree::TextPos) -> usize {
    let line_start = match position.row {
        0 | 1 => 0,
        row => text
            .match_indices('\n')
            .nth(row as usize - 2)
            .map_or(text.len(), |(i, _)| i + 1),
    };
    text[line_start..]
        .char_indices()
        .nth(position.col.saturating_sub(1) as usize)
        .map_or(text.len(), |(i, _)| line_start + i)
}
