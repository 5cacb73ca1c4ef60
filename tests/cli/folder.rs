//! A folder in which the program runs, the result of a run, and the roof as its input.

use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;

/// A separate folder for each test, removed at its end.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("shape-up-cli-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) -> &Folder {
        std::fs::write(self.0.join(name), text).unwrap();
        self
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap()
    }

    pub(crate) fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.read(name)).unwrap()
    }

    /// Names of the files in it, hidden ones included.
    pub(crate) fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> =
            entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Ended {
        let output = Command::new(env!("CARGO_BIN_EXE_shape-up"))
            .args(arguments)
            .current_dir(&self.0)
            .output()
            .unwrap();
        Ended {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[derive(Debug)]
pub(crate) struct Ended {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Ended {
    #[track_caller]
    pub(crate) fn done(self) -> String {
        assert_eq!((self.code, self.err.as_str()), (Some(0), ""), "{}", self.out);
        self.out
    }

    /// Checks that the input was at fault: one line on standard error with these words, and nothing
    /// else.
    #[track_caller]
    pub(crate) fn refused(self, words: &[&str]) {
        assert_eq!(self.code, Some(1), "{self:?}");
        assert_eq!(self.out, "", "{self:?}");
        assert_eq!(self.err.lines().count(), 1, "{self:?}");
        for word in words {
            assert!(self.err.contains(word), "expected `{word}` in {:?}", self.err);
        }
    }

    #[track_caller]
    pub(crate) fn misused(self, word: &str) {
        assert_eq!((self.code, self.out.as_str()), (Some(2), ""), "{self:?}");
        let first = self.err.lines().next().unwrap();
        assert!(first.contains(word), "expected `{word}` in {first:?}");
        assert!(self.err.lines().count() == 3 && self.err.contains("shape-up --help"), "{self:?}");
    }
}

/// Four bent quads with everything that must be preserved: a group of two words, a polyline, its
/// own names, and positions without a short decimal form.
pub(crate) const ROOF: &str = "\
o roof
v 0 0 0
v 1 0 0.1
v 2 0 0
v 0 1 0.30000000000000004
v 1.1 1 0.7
v 2 1 0.2
v 0 2 0
v 1 2 0.1
v 2 2 -0.3
g left shared
f 1 2 5 4
f 4 5 8 7
g right
usemtl glass
f 2 3 6 5
f 5 6 9 8
l 1 2 3
";

/// A scene file on the roof, with the keys in `rest` appended.
pub(crate) fn scene(rest: &str) -> String {
    format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "units": "m", "mesh": {{ "file": "roof.obj" }}{rest} }}"#
    )
}

pub(crate) const PLANES: &str = r#", "constraints": [{ "kind": "plane", "on": "faces" }]"#;
