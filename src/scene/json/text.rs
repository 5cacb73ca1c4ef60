//! The text of a JSON document (RFC 8259) as a tree of [`Node`]s.
//!
//! A reader of our own: that of `serde_json` brings a second reader of numbers along, which is most
//! of its size, and knows neither the order of keys nor keys that occur twice.

use super::node::Node;
use serde_json::Number;
use std::collections::BTreeSet;

/// Arrays and objects inside one another: more are refused, so that no text overflows the stack.
const DEEPEST: usize = 127;

/// Why a text is not JSON.
#[derive(Debug, PartialEq)]
pub(super) struct Fault {
    pub(super) message: String,
    /// From one on.
    pub(super) line: usize,
    /// Bytes from the beginning of the line to the fault.
    pub(super) column: usize,
}

/// Reads a document.
pub(super) fn read(text: &str) -> Result<Node, Fault> {
    let mut reader = Reader { text, at: 0, depth: 0 };
    let node = reader.value()?;
    match reader.peek_word() {
        None => Ok(node),
        Some(_) => Err(reader.fault_ahead("trailing characters")),
    }
}

struct Reader<'a> {
    text: &'a str,
    /// Bytes that have been read.
    at: usize,
    depth: usize,
}

const END_OF_VALUE: &str = "EOF while parsing a value";
const END_OF_STRING: &str = "EOF while parsing a string";

impl Reader<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// The next byte that is not white space.
    fn peek_word(&mut self) -> Option<u8> {
        while matches!(self.peek(), Some(b' ' | b'\n' | b'\t' | b'\r')) {
            self.at += 1;
        }
        self.peek()
    }

    fn take(&mut self) -> Option<u8> {
        let byte = self.peek()?;
        self.at += 1;
        Some(byte)
    }

    /// A fault at the last byte that was read.
    fn fault(&self, message: impl Into<String>) -> Fault {
        let before = &self.text.as_bytes()[..self.at];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        let column = before.iter().rev().take_while(|&&byte| byte != b'\n').count();
        Fault { message: message.into(), line, column }
    }

    /// A fault at the byte that is next.
    fn fault_ahead(&mut self, message: &str) -> Fault {
        self.at = self.text.len().min(self.at + 1);
        self.fault(message)
    }

    fn value(&mut self) -> Result<Node, Fault> {
        match self.peek_word() {
            Some(b'n') => self.word("null", Node::Null),
            Some(b't') => self.word("true", Node::Bool(true)),
            Some(b'f') => self.word("false", Node::Bool(false)),
            Some(b'-' | b'0'..=b'9') => self.number().map(Node::Number),
            Some(b'"') => self.string().map(Node::Text),
            Some(b'[' | b'{') if self.depth == DEEPEST => {
                Err(self.fault_ahead("recursion limit exceeded"))
            }
            Some(open @ (b'[' | b'{')) => {
                self.at += 1;
                self.depth += 1;
                let node = if open == b'[' { self.array()? } else { self.object()? };
                self.depth -= 1;
                Ok(node)
            }
            Some(_) => Err(self.fault_ahead("expected value")),
            None => Err(self.fault_ahead(END_OF_VALUE)),
        }
    }

    fn word(&mut self, word: &str, node: Node) -> Result<Node, Fault> {
        for expected in word.bytes() {
            match self.take() {
                Some(byte) if byte == expected => {}
                Some(_) => return Err(self.fault("expected ident")),
                None => return Err(self.fault(END_OF_VALUE)),
            }
        }
        Ok(node)
    }

    fn array(&mut self) -> Result<Node, Fault> {
        let mut items = Vec::new();
        loop {
            match self.peek_word() {
                Some(b']') => break,
                Some(b',') if !items.is_empty() => {
                    self.at += 1;
                    if self.peek_word() == Some(b']') {
                        return Err(self.fault_ahead("trailing comma"));
                    }
                }
                Some(_) if items.is_empty() => {}
                Some(_) => return Err(self.fault_ahead("expected `,` or `]`")),
                None => return Err(self.fault_ahead("EOF while parsing a list")),
            }
            items.push(self.value()?);
        }
        self.at += 1;
        Ok(Node::Array(items))
    }

    fn object(&mut self) -> Result<Node, Fault> {
        const END: &str = "EOF while parsing an object";
        let mut entries = Vec::new();
        let mut seen = BTreeSet::new();
        loop {
            match self.peek_word() {
                Some(b'}') => break,
                Some(b',') if !entries.is_empty() => {
                    self.at += 1;
                    match self.peek_word() {
                        Some(b'}') => return Err(self.fault_ahead("trailing comma")),
                        None => return Err(self.fault_ahead(END_OF_VALUE)),
                        Some(_) => {}
                    }
                }
                Some(_) if entries.is_empty() => {}
                Some(_) => return Err(self.fault_ahead("expected `,` or `}`")),
                None => return Err(self.fault_ahead(END)),
            }
            if self.peek() != Some(b'"') {
                return Err(self.fault_ahead("key must be a string"));
            }
            let key = self.string()?;
            let next = self.peek_word();
            if !seen.insert(key.clone()) {
                return Err(self.fault(format!("the key `{key}` occurs twice")));
            }
            match next {
                Some(b':') => self.at += 1,
                Some(_) => return Err(self.fault_ahead("expected `:`")),
                None => return Err(self.fault_ahead(END)),
            }
            entries.push((key, self.value()?));
        }
        self.at += 1;
        Ok(Node::Object(entries))
    }

    fn string(&mut self) -> Result<String, Fault> {
        self.at += 1;
        let mut text = String::new();
        loop {
            let rest = &self.text[self.at..];
            let special = |byte: u8| byte == b'"' || byte == b'\\' || byte < 0x20;
            let plain = rest.bytes().position(special).unwrap_or(rest.len());
            text.push_str(&rest[..plain]);
            self.at += plain;
            match self.take() {
                Some(b'"') => return Ok(text),
                Some(b'\\') => text.push(self.escaped()?),
                Some(_) => {
                    return Err(self.fault(
                        "control character (\\u0000-\\u001F) found while parsing a string",
                    ));
                }
                None => return Err(self.fault(END_OF_STRING)),
            }
        }
    }

    /// What stands after a backslash.
    fn escaped(&mut self) -> Result<char, Fault> {
        Ok(match self.take() {
            Some(byte @ (b'"' | b'\\' | b'/')) => char::from(byte),
            Some(b'b') => '\u{8}',
            Some(b'f') => '\u{c}',
            Some(b'n') => '\n',
            Some(b'r') => '\r',
            Some(b't') => '\t',
            Some(b'u') => return self.unicode(),
            Some(_) => return Err(self.fault("invalid escape")),
            None => return Err(self.fault(END_OF_STRING)),
        })
    }

    /// The character of `\uXXXX`, or of two such that are the halves of one.
    fn unicode(&mut self) -> Result<char, Fault> {
        const LONE: &str = "lone leading surrogate in hex escape";
        let high = self.hex()?;
        let mut code = high;
        if (0xD800..0xDC00).contains(&high) {
            for expected in *b"\\u" {
                match self.take() {
                    Some(byte) if byte == expected => {}
                    Some(_) => return Err(self.fault("unexpected end of hex escape")),
                    None => return Err(self.fault(END_OF_STRING)),
                }
            }
            let low = self.hex()?;
            if !(0xDC00..0xE000).contains(&low) {
                return Err(self.fault(LONE));
            }
            code = 0x1_0000 + ((high - 0xD800) << 10) + (low - 0xDC00);
        }
        char::from_u32(code).ok_or_else(|| self.fault(LONE))
    }

    /// Four hexadecimal digits.
    fn hex(&mut self) -> Result<u32, Fault> {
        let digits = self.text.as_bytes().get(self.at..self.at + 4);
        self.at = self.text.len().min(self.at + 4);
        let Some(digits) = digits else { return Err(self.fault(END_OF_STRING)) };
        let digit = |&byte: &u8| char::from(byte).to_digit(16);
        let code = digits.iter().try_fold(0, |code, byte| Some(16 * code + digit(byte)?));
        code.ok_or_else(|| self.fault("invalid escape"))
    }

    fn number(&mut self) -> Result<Number, Fault> {
        let start = self.at;
        if self.peek() == Some(b'-') {
            self.at += 1;
        }
        match self.take() {
            Some(b'0') => {
                if matches!(self.peek(), Some(b'0'..=b'9')) {
                    return Err(self.fault_ahead("invalid number"));
                }
            }
            Some(b'1'..=b'9') => self.skip_digits(),
            Some(_) => return Err(self.fault("invalid number")),
            None => return Err(self.fault(END_OF_VALUE)),
        }
        let mut whole = true;
        if self.peek() == Some(b'.') {
            whole = false;
            self.at += 1;
            self.digits()?;
        }
        if matches!(self.peek(), Some(b'e' | b'E')) {
            whole = false;
            self.at += 1;
            if matches!(self.peek(), Some(b'+' | b'-')) {
                self.at += 1;
            }
            self.digits()?;
        }
        let text = &self.text[start..self.at];
        // Minus zero is no whole number: it would lose its sign.
        if whole && text != "-0" {
            if let Ok(value) = text.parse::<u64>() {
                return Ok(value.into());
            }
            if let Ok(value) = text.parse::<i64>() {
                return Ok(value.into());
            }
        }
        let value = text.parse().ok().and_then(Number::from_f64);
        value.ok_or_else(|| self.fault("number out of range"))
    }

    fn skip_digits(&mut self) {
        while matches!(self.peek(), Some(b'0'..=b'9')) {
            self.at += 1;
        }
    }

    /// At least one digit.
    fn digits(&mut self) -> Result<(), Fault> {
        match self.peek() {
            Some(b'0'..=b'9') => self.skip_digits(),
            Some(_) => return Err(self.fault_ahead("invalid number")),
            None => return Err(self.fault_ahead(END_OF_VALUE)),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: &str = r#" {"a": [0, -0, 12, -7, 3.25, 1e-7, 18446744073709551615, 9007199254740993.0],
        "b\u00e9\ud83d\ude00\n\"\\\/\b\f\r\t": {"x": null, "y": true, "z": false, "é": "ü\u0041"},
        "c": [], "d": {}, "e": [[1, 2], [3E+4, 5.5e2]], "f": 123456789012345678901234567890} "#;

    /// That `serde_json` says the same of the text: the same tree, or the same fault at the same place.
    fn check(text: &str) {
        let known: Result<serde_json::Value, _> = serde_json::from_str(text);
        match (read(text), known) {
            (Ok(node), Ok(value)) => assert_eq!(node.to_value(), value, "{text}"),
            (Err(fault), Ok(_)) => assert!(fault.message.ends_with("occurs twice"), "{text}"),
            (Ok(node), Err(error)) => panic!("{text}: found {node:?}, expected {error}"),
            (Err(Fault { message, .. }), Err(_)) if message.ends_with("occurs twice") => {}
            (Err(Fault { message, line, column }), Err(error)) => {
                let found = format!("{message} at line {line} column {column}");
                // An exponent that is too large is found before its last digit.
                let early = message == "number out of range";
                assert!(found == error.to_string() || early, "{text}: {found}, expected {error}");
            }
        }
    }

    #[test]
    fn every_beginning_of_a_document_is_read_as_serde_json_reads_it() {
        check(DOCUMENT);
        for (end, _) in DOCUMENT.char_indices() {
            check(&DOCUMENT[..end]);
        }
    }

    #[test]
    fn a_document_with_one_character_changed_is_read_as_serde_json_reads_it() {
        for (at, old) in DOCUMENT.char_indices() {
            for new in "{}[]:,\"\\/-+.0159eEuntfD \n\u{1}é".chars() {
                check(&format!("{}{new}{}", &DOCUMENT[..at], &DOCUMENT[at + old.len_utf8()..]));
                check(&format!("{}{new}{}", &DOCUMENT[..at], &DOCUMENT[at..]));
            }
        }
    }

    #[test]
    fn numbers_are_read_to_the_last_bit() {
        for text in [
            "1e308",
            "-1.7976931348623157e308",
            "1e309",
            "-1e999",
            "4.9e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "1e-400",
            "9007199254740993",
            "-9223372036854775808",
            "-9223372036854775809",
            "18446744073709551616",
            "0.1000000000000000055511151231257827021181583404541015625",
            "8.5000000000000000000000000000000000000001e15",
            "-0",
            "-0.0",
        ] {
            check(text);
            let read = read(text).ok().map(|node| node.to_value().as_f64().unwrap().to_bits());
            let expected = text.parse::<f64>().ok().filter(|value| value.is_finite());
            assert_eq!(read, expected.map(f64::to_bits), "{text}");
        }
    }

    #[test]
    fn nesting_has_an_end() {
        for deep in [126, 127, 128, 100_000] {
            check(&format!("{}{}", "[".repeat(deep), "]".repeat(deep)));
            check(&"{\"a\":".repeat(deep));
        }
    }

    #[test]
    fn a_key_occurs_once() {
        let fault = read("{\"a\": 1,\n \"a\": 2}").unwrap_err();
        assert_eq!((fault.line, fault.column), (2, 4));
        assert_eq!(fault.message, "the key `a` occurs twice");
    }
}
