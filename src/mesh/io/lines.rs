//! The text of a mesh file as lines and words, for any encoding and line ending.

use std::borrow::Cow;
use std::str::SplitAsciiWhitespace;

/// Decodes a file: UTF-16 with a byte order mark, else UTF-8. Bytes that are not UTF-8, as in names
/// by older programs, are read as Latin-1, so that different names stay different.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let utf16 = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    match bytes {
        [0xFF, 0xFE, rest @ ..] => Cow::Owned(utf16(rest, u16::from_le_bytes)),
        [0xFE, 0xFF, rest @ ..] => Cow::Owned(utf16(rest, u16::from_be_bytes)),
        [0xEF, 0xBB, 0xBF, rest @ ..] | rest => match str::from_utf8(rest) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => Cow::Owned(rest.utf8_chunks().fold(String::new(), |mut text, chunk| {
                text.push_str(chunk.valid());
                text.extend(chunk.invalid().iter().map(|&byte| char::from(byte)));
                text
            })),
        },
    }
}

/// Returns the lines with their numbers from one, ended by LF, CR LF, CR or the end of the text.
pub(crate) fn lines(text: &str) -> Lines<'_> {
    Lines { rest: text, number: 0 }
}

#[derive(Clone)]
pub(crate) struct Lines<'a> {
    rest: &'a str,
    number: usize,
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let end = memchr::memchr2(b'\n', b'\r', self.rest.as_bytes());
        let length = end.unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(length);
        self.rest = rest.strip_prefix("\r\n").or(rest.get(1..)).unwrap_or_default();
        self.number += 1;
        Some((self.number, line))
    }
}

/// What a statement of OBJ is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Statement {
    /// A shape, or a part of one.
    Shape,
    /// Something else, whose rest is a name, which may end in a backslash, as a folder does.
    Name,
    /// A setting for the elements after it.
    Setting,
    /// Nothing here: it does not affect the shape, or only free-form elements.
    Other,
}

/// The statements that a line may begin with.
const STATEMENTS: [(Statement, &str); 4] = [
    (Statement::Shape, "v f fo l p cstype deg curv curv2 surf"),
    (Statement::Name, "o g usemtl mtllib maplib usemap"),
    (Statement::Setting, "s mg bevel c_interp d_interp lod"),
    (
        Statement::Other,
        "vt vn vp parm trim hole scrv sp end con bmat step ctech stech shadow_obj trace_obj call csh",
    ),
];

impl Statement {
    /// The one that begins with this word.
    pub(crate) fn of(word: &str) -> Option<Statement> {
        let is_it = |words: &str| words.split(' ').any(|known| known == word);
        STATEMENTS.iter().find(|(_, words)| is_it(words)).map(|(statement, _)| *statement)
    }
}

/// Returns the lines of OBJ, joining those that end in a backslash with the next and numbered by the
/// first. Neither comments, which may end in a Windows folder path, nor names that end in a backslash
/// are continued, nor is a line continued if the next begins with a statement.
pub(crate) fn joined_lines(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = lines(text);
    std::iter::from_fn(move || {
        let (number, first) = lines.next()?;
        let Some(length) = backslash(first) else {
            return Some((number, Cow::Borrowed(first)));
        };
        let statement = first.split_ascii_whitespace().next().unwrap_or_default();
        if statement.starts_with('#') {
            return Some((number, Cow::Borrowed(first)));
        }
        let of_name = Statement::of(statement) == Some(Statement::Name);
        let is_own_word = first[..length].ends_with([' ', '\t']);
        if (of_name && !is_own_word) || !lines.goes_on(of_name) {
            let rest = if of_name { first } else { &first[..length] };
            return Some((number, Cow::Borrowed(rest)));
        }
        let mut joined = first[..length].to_owned();
        while let Some((_, next)) = lines.next() {
            joined.push(' ');
            let length = backslash(next);
            joined.push_str(&next[..length.unwrap_or(next.len())]);
            if length.is_none() || !lines.goes_on(of_name) {
                break;
            }
        }
        Some((number, Cow::Owned(joined)))
    })
}

/// Returns the length of a line without the backslash at its end; `None` without one.
fn backslash(line: &str) -> Option<usize> {
    line.trim_ascii_end().strip_suffix('\\').map(str::len)
}

impl Lines<'_> {
    /// Whether the next line can be the rest of the line before: of names, or of numbers.
    fn goes_on(&self, of_names: bool) -> bool {
        let next = Lines { rest: self.rest, number: 0 }.next().map_or("", |(_, line)| line);
        let word = next.split_ascii_whitespace().next().unwrap_or_default();
        let is_empty = word.is_empty() || word.starts_with('#');
        !(Statement::of(word).is_some() || of_names && is_empty)
    }
}

/// Returns the words of a line up to a comment: a `#` that begins a word, unlike in `1.#IND`.
pub(crate) fn words(line: &str) -> SplitAsciiWhitespace<'_> {
    let bytes = line.as_bytes();
    let begins = |&at: &usize| at == 0 || bytes[at - 1].is_ascii_whitespace();
    let end = memchr::memchr_iter(b'#', bytes).find(begins).unwrap_or(line.len());
    line[..end].split_ascii_whitespace()
}

/// Returns the text of line `number`, shortened, for a message.
pub(crate) fn excerpt(text: &str, number: usize) -> String {
    const LONGEST: usize = 60;
    let line = lines(text).nth(number - 1).map_or("", |(_, line)| line.trim());
    match line.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &line[..end]),
        None => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(text: &str) -> Vec<(usize, String)> {
        joined_lines(text).map(|(number, line)| (number, line.into_owned())).collect()
    }

    #[test]
    fn a_line_ends_at_every_convention() {
        let found: Vec<_> = lines("a\nb\r\nc\rd\n\ne").collect();
        assert_eq!(found, [(1, "a"), (2, "b"), (3, "c"), (4, "d"), (5, ""), (6, "e")]);
        assert_eq!(lines("a\n").count(), 1);
    }

    #[test]
    fn a_backslash_joins_lines_but_not_comments() {
        let found = joined("f 1 2 \\\r\n 3\\  \n4\n# C:\\models\\\nv\\");
        let line = |number, text: &str| (number, text.to_owned());
        assert_eq!(found, [line(1, "f 1 2   3 4"), line(4, "# C:\\models\\"), line(5, "v")]);
    }

    #[test]
    fn a_backslash_at_the_end_of_a_name_is_part_of_it() {
        let line = |number, text: &str| (number, text.to_owned());
        for name in ["usemtl Wood\\", "o a\\", "g roof\\", "mtllib C:\\tex\\", "usemtl Wood \\"] {
            for next in ["f 1 2 3", "usemtl b", "v 0 0 0", "g", "s 1", "bevel on", "lod 3"] {
                let found = joined(&format!("{name}\n{next}\n"));
                assert_eq!(found, [line(1, name), line(2, next)]);
            }
            assert_eq!(joined(name), [line(1, name)]);
            assert_eq!(joined(&format!("{name}\r\n\r\n# c\r\n"))[0], line(1, name));
        }
        // Names of a group go on in the next line after a word of their own.
        assert_eq!(joined("g a \\\nb\nf 1"), [line(1, "g a  b"), line(3, "f 1")]);
    }

    #[test]
    fn a_statement_is_no_continuation() {
        let found = joined("f 1 2 3\\\nf 2 3 4 \\\nv 0 0 0\n");
        let line = |number, text: &str| (number, text.to_owned());
        assert_eq!(found, [line(1, "f 1 2 3"), line(2, "f 2 3 4 "), line(3, "v 0 0 0")]);
        // Statements that are ignored were joined with a face, which was skipped then.
        for (_, words) in STATEMENTS {
            for word in words.split(' ') {
                assert_eq!(joined(&format!("f 1 2 3\\\n{word} a"))[0], line(1, "f 1 2 3"));
            }
        }
    }

    #[test]
    fn a_comment_begins_with_a_word() {
        assert_eq!(words(" v 1.#IND 2 #3 4").collect::<Vec<_>>(), ["v", "1.#IND", "2"]);
        assert_eq!(words("# v").count(), 0);
    }

    #[test]
    fn every_encoding_gives_the_same_text() {
        let text = "g D\u{e4}cher\n";
        let units: Vec<u16> = text.encode_utf16().collect();
        let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        assert_eq!(decode(text.as_bytes()), text);
        assert_eq!(decode(&[b"\xEF\xBB\xBF", text.as_bytes()].concat()), text);
        assert_eq!(decode(&[b"\xFE\xFF", &big[..]].concat()), text);
        assert_eq!(decode(&[b"\xFF\xFE", &little[..]].concat()), text);
        assert_eq!(decode(b"g D\xE4cher\n"), text);
    }

    #[test]
    fn an_excerpt_is_short_and_whole_characters() {
        assert_eq!(excerpt("a\n  f 1 2 \n", 2), "f 1 2");
        assert_eq!(excerpt(&"\u{e4}".repeat(1000), 1), format!("{}...", "\u{e4}".repeat(60)));
    }
}
