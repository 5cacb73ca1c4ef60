//! JSON text to a tree.
//!
//! `serde_json::from_str` is not used, for two reasons. Its exact number parser would be a fiftieth
//! of the solver module and duplicates that of the standard library, which reads mesh files. And it
//! silently keeps the last of several values of one key, where a duplicate key should be an error.

use super::error::JsonError;
use super::tree::Tree;
use serde_json::Number;
use std::collections::BTreeSet;

/// Maximum nesting of arrays and objects; deeper documents would exhaust the stack.
const MOST_LEVELS: usize = 128;

/// Parses a document, with or without a leading byte order mark.
///
/// # Errors
/// Text that is not JSON, or an object with a repeated key; the message has line and column.
pub(crate) fn parse(text: &str) -> Result<Tree, JsonError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut parser = Parser { text, at: 0, level: 0 };
    let read = parser.value().and_then(|value| match parser.next() {
        None => Ok(value),
        Some(_) => Err("unexpected text after the value".to_owned()),
    });
    read.map_err(|fault| {
        let before = text.as_bytes().get(..parser.at).unwrap_or(text.as_bytes());
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let column = before.iter().rev().take_while(|&&byte| byte != b'\n').count() + 1;
        JsonError::new("", format!("line {line}, column {column}: not JSON: {fault}"))
    })
}

struct Parser<'a> {
    text: &'a str,
    /// Byte offset of the next byte, and of the error if parsing fails.
    at: usize,
    level: usize,
}

type Parsed<T> = Result<T, String>;

impl Parser<'_> {
    /// Skips white space and returns the next byte without consuming it.
    fn next(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        let space = rest.iter().take_while(|byte| b" \t\r\n".contains(byte)).count();
        self.at += space;
        rest.get(space).copied()
    }

    fn value(&mut self) -> Parsed<Tree> {
        match self.next() {
            Some(b'{') => {
                let (mut entries, mut keys) = (Vec::new(), BTreeSet::new());
                self.items(b'}', |parser| {
                    let (key, value) = parser.entry(&mut keys)?;
                    entries.push((key, value));
                    Ok(())
                })?;
                Ok(Tree::Object(entries))
            }
            Some(b'[') => {
                let mut items = Vec::new();
                self.items(b']', |parser| parser.value().map(|item| items.push(item)))?;
                Ok(Tree::Array(items))
            }
            Some(b'"') => self.string().map(Tree::Text),
            Some(b'-' | b'0'..=b'9') => self.number().map(Tree::Number),
            _ => {
                let words = [
                    ("null", Tree::Null),
                    ("true", Tree::Bool(true)),
                    ("false", Tree::Bool(false)),
                ];
                let rest = &self.text[self.at..];
                let found = words.into_iter().find(|(word, _)| rest.starts_with(word));
                let (word, value) = found.ok_or_else(|| self.expected("a value"))?;
                self.at += word.len();
                Ok(value)
            }
        }
    }

    fn expected(&mut self, what: &str) -> String {
        let end = if self.next().is_none() { ", found the end" } else { "" };
        format!("expected {what}{end}")
    }

    /// Parses the comma-separated entries between brackets.
    fn items(&mut self, close: u8, mut item: impl FnMut(&mut Self) -> Parsed<()>) -> Parsed<()> {
        if self.level == MOST_LEVELS {
            return Err("recursion: arrays and objects are nested too deeply".to_owned());
        }
        self.level += 1;
        self.at += 1;
        if self.next() != Some(close) {
            loop {
                item(self)?;
                match self.next() {
                    Some(b',') => self.at += 1,
                    Some(byte) if byte == close => break,
                    _ => return Err(self.expected(&format!("`,` or `{}`", char::from(close)))),
                }
            }
        }
        self.at += 1;
        self.level -= 1;
        Ok(())
    }

    fn entry(&mut self, keys: &mut BTreeSet<String>) -> Parsed<(String, Tree)> {
        if self.next() != Some(b'"') {
            return Err(self.expected("a key in quotes"));
        }
        let key = self.string()?;
        if !keys.insert(key.clone()) {
            return Err(format!("the key `{key}` occurs twice"));
        }
        if self.next() != Some(b':') {
            return Err(self.expected("`:`"));
        }
        self.at += 1;
        Ok((key, self.value()?))
    }

    fn string(&mut self) -> Parsed<String> {
        self.at += 1;
        let mut string = String::new();
        loop {
            let rest = &self.text[self.at..];
            let end = rest.find(|c| c == '"' || c == '\\' || c < ' ').unwrap_or(rest.len());
            string.push_str(&rest[..end]);
            self.at += end;
            match rest.as_bytes().get(end) {
                Some(b'"') => break,
                Some(b'\\') => string.push(self.escape()?),
                Some(_) => {
                    return Err("a string contains a line break or control character".to_owned());
                }
                None => return Err("a string is not closed".to_owned()),
            }
        }
        self.at += 1;
        Ok(string)
    }

    /// Parses an escape sequence, from its backslash.
    fn escape(&mut self) -> Parsed<char> {
        let Some(letter) = self.text.as_bytes().get(self.at + 1) else {
            return Err("a string is not closed".to_owned());
        };
        let character = match letter {
            b'"' | b'\\' | b'/' => char::from(*letter),
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => return self.unicode(),
            _ => return Err("invalid escape sequence".to_owned()),
        };
        self.at += 2;
        Ok(character)
    }

    /// Parses `\uXXXX`, or a surrogate pair of two for a character beyond 16 bits.
    fn unicode(&mut self) -> Parsed<char> {
        let unit = |at: usize| {
            let digits = self.text.get(at..at + 6)?.strip_prefix("\\u")?;
            let digits = digits.bytes().all(|b| b.is_ascii_hexdigit()).then_some(digits)?;
            u16::from_str_radix(digits, 16).ok()
        };
        let units = unit(self.at).into_iter().chain(unit(self.at + 6));
        let character = char::decode_utf16(units).next().and_then(Result::ok);
        let character = character.ok_or("invalid escape sequence")?;
        self.at += 6 * character.len_utf16();
        Ok(character)
    }

    fn number(&mut self) -> Parsed<Number> {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || "+-.".contains(c)));
        let word = &rest[..end.unwrap_or(rest.len())];
        let unsigned = word.strip_prefix('-').unwrap_or(word);
        let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => {
                (mantissa, Some(exponent.strip_prefix(['+', '-']).unwrap_or(exponent)))
            }
            None => (unsigned, None),
        };
        let (whole, fraction) = match mantissa.split_once('.') {
            Some((whole, fraction)) => (whole, Some(fraction)),
            None => (mantissa, None),
        };
        let digits =
            |digits: &str| !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        let leading = whole.len() > 1 && whole.starts_with('0');
        if !digits(whole) || leading || ![fraction, exponent].into_iter().flatten().all(digits) {
            return Err("not a valid number".to_owned());
        }
        let number = match (word.parse::<u64>(), word.parse::<i64>()) {
            (Ok(whole), _) => Some(whole.into()),
            // -0 becomes a float, to keep its sign.
            (_, Ok(whole)) if whole != 0 => Some(whole.into()),
            _ => word.parse().ok().and_then(Number::from_f64),
        };
        let number = number.ok_or("the number is out of range")?;
        self.at += word.len();
        Ok(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    #[test]
    fn the_tree_is_that_of_serde_json() {
        for text in [
            r#" { "a" : [ 1, -2, 2.50, 1e3, 1E-3, 0, 0.1, 18446744073709551615 ], "b": {}, "c": [] } "#,
            r#"["", "a\"\\\/\b\f\n\r\t", "\u00e9\ud83d\ude00é😀", null, true, false]"#,
            r#"[1.7976931348623157e308, 5e-324, 123456789012345678901234567890, -0, 0.1e-7, 1e-999]"#,
        ] {
            let value: Value = serde_json::from_str(text).expect(text);
            assert_eq!(parse(text).expect(text), Tree::from(&value));
        }
        let Ok(Tree::Number(zero)) = parse("-0") else { panic!("it is a number") };
        assert_eq!(zero.as_f64().map(f64::to_bits), Some(1 << 63));
        assert_eq!(parse("\u{feff}{}"), Ok(Tree::from(&json!({}))));
    }

    #[test]
    fn what_is_no_json_is_refused_as_serde_json_refuses_it() {
        for text in [
            "",
            "nul",
            "[1,]",
            "[1 2]",
            "{,}",
            "{\"a\"}",
            "{\"a\":}",
            "{a:1}",
            "[",
            "{",
            "\"",
            "1 2",
            "01",
            "-",
            "1.",
            ".5",
            "+1",
            "1e",
            "1e+",
            "--1",
            "0x1",
            "1_0",
            "NaN",
            "Infinity",
            "1e999",
            "\"\n\"",
            r#""\x""#,
            r#""\u12""#,
            r#""\ud800""#,
            r#""\ud800\u0041""#,
            r#""\udc00""#,
            r#""\é""#,
            r#""\u+123""#,
            r#""\"#,
            "[1]]",
            "'a'",
        ] {
            let error = parse(text).expect_err(text);
            assert!(error.message.starts_with("line "), "{text}: {}", error.message);
            assert!(serde_json::from_str::<Value>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_fault_has_its_line_and_column() {
        let fault = |text| parse(text).expect_err(text).message;
        assert!(fault("{\n  \"a\": x,\n}").starts_with("line 2, column 8: "));
        assert!(fault("{\"a\": 1, \"a\": 2}").contains("`a` occurs twice"));
        assert!(fault(&"[".repeat(5000)).contains("recursion"));
        assert!(parse(&format!("{}{}", "[".repeat(128), "]".repeat(128))).is_ok());
    }
}
