//! One pass over the bytes before the XML reader sees them: limits, and elements that are never closed.

use super::problem::{Problem, Source};

/// The largest text that is read, in bytes.
pub const MOST_BYTES: usize = 2_000_000;
/// The deepest nesting of elements, the outer element counted as 1.
pub const DEEPEST: usize = 256;
/// The most attributes of one element; the XML reader compares each with all others.
pub const MOST_ATTRIBUTES: usize = 1000;

/// The most namespaces of a text, which have no meaning here; the XML reader compares each with all others.
const MOST_NAMESPACES: usize = 100;

/// Checks the limits without recursion and finds document types, which are refused.
///
/// Returns the byte and the name of the innermost element that is still open at the end. Texts that are not
/// well-formed may come through: the XML reader refuses them.
pub(super) fn scan<'a>(source: &Source<'a>) -> Result<Option<(usize, &'a str)>, Problem> {
    let text = source.text;
    if let Some((at, _)) = text.match_indices("xmlns").nth(MOST_NAMESPACES) {
        let message = format!("expected at most {MOST_NAMESPACES} namespaces, found more");
        return Err(Problem::fault("xml", source.place(at), message));
    }
    let mut open: Vec<(usize, &str)> = Vec::new();
    let mut at = 0;
    while let Some(found) = text.get(at..).and_then(|rest| rest.find('<')) {
        at += found;
        let rest = &text[at..];
        let past = |end: &str| rest.find(end).map(|found| at + found + end.len());
        let next = if rest.starts_with("<!--") {
            past("-->")
        } else if rest.starts_with("<![CDATA[") {
            past("]]>")
        } else if rest.starts_with("<?") {
            past("?>")
        } else if rest.starts_with("<!") {
            let message = "expected an element, found a document type or other <! markup, which is not supported";
            return Err(Problem::fault("xml", source.place(at), message));
        } else if rest.starts_with("</") {
            open.pop();
            past(">")
        } else {
            let tag = Tag::read(rest);
            if tag.attributes > MOST_ATTRIBUTES {
                let message = format!("expected at most {MOST_ATTRIBUTES} attributes, found {}", tag.attributes);
                return Err(Problem::fault("xml", source.place(at), message));
            }
            if open.len() == DEEPEST {
                let message = format!("expected at most {DEEPEST} elements inside each other, found more");
                return Err(Problem::fault("depth", source.place(at), message));
            }
            if !tag.is_empty {
                open.push((at, element_name(rest)));
            }
            tag.length.map(|length| at + length)
        };
        let Some(next) = next else { break };
        at = next;
    }
    Ok(open.pop())
}

/// The name of the element that begins here, with its prefix.
pub(super) fn element_name(from_angle: &str) -> &str {
    let name = from_angle.strip_prefix('<').unwrap_or(from_angle);
    name.find(|c: char| c.is_ascii_whitespace() || c == '/' || c == '>').map_or(name, |end| &name[..end])
}

/// What a start tag looks like from outside.
struct Tag {
    /// Bytes from `<` to behind `>`; none when it does not end.
    length: Option<usize>,
    attributes: usize,
    is_empty: bool,
}

impl Tag {
    fn read(from_angle: &str) -> Self {
        let mut tag = Self { length: None, attributes: 0, is_empty: false };
        let mut quote = None;
        let mut before = b'<';
        for (at, byte) in from_angle.bytes().enumerate() {
            match (quote, byte) {
                (Some(open), _) if open == byte => quote = None,
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => tag.attributes += 1,
                (None, b'>') => {
                    tag.length = Some(at + 1);
                    tag.is_empty = before == b'/';
                    return tag;
                }
                (Some(_) | None, _) => {}
            }
            before = byte;
        }
        tag
    }
}
