//! Lexer of the command line: files, options, and the typed values of options.

use lexopt::Arg;
use serde_json::{Value, json};
use shape_up::constraint::{KINDS, Set};
use shape_up::fabricate::ReportView;
use shape_up::mesh::FileFormat;
use shape_up::scene::{
    BUILD_PRESETS, BoundaryRequire, BuildForm, BuildPreset, BuildSetting, NamedEnum, PresetOf,
};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// The word for the absent value of a setting.
const AUTO: &str = "auto";

/// Values of settings of Build, by their paths.
pub(super) type Settings = Vec<(&'static str, Value)>;

/// The remaining arguments of a command.
pub(super) struct Tokens {
    parser: lexopt::Parser,
    /// The options so far, to reject repetitions.
    seen: Vec<String>,
}

pub(super) enum Token {
    File(OsString),
    /// The name, including its dashes.
    Option(String),
}

impl Tokens {
    pub(super) fn new(arguments: Vec<OsString>) -> Tokens {
        Tokens { parser: lexopt::Parser::from_args(arguments), seen: Vec::new() }
    }

    /// Returns the next file or option; none at the end.
    pub(super) fn next(&mut self) -> Result<Option<Token>, String> {
        let name = match self.parser.next().map_err(|error| error.to_string())? {
            None => return Ok(None),
            Some(Arg::Value(file)) => return Ok(Some(Token::File(file))),
            // `_` stands for `-`, as in the ids of scenes, which the tables of a build have.
            Some(Arg::Long(name)) => format!("--{}", name.replace('_', "-")),
            Some(Arg::Short(letter)) => format!("-{letter}"),
        };
        if self.seen.contains(&name) {
            return Err(format!("{name} is given twice"));
        }
        self.seen.push(name.clone());
        Ok(Some(Token::Option(name)))
    }

    /// Returns the next option of a command that takes one file, and stores the file in `place`.
    pub(super) fn option(&mut self, place: &mut Option<PathBuf>) -> Result<Option<String>, String> {
        loop {
            match self.next()? {
                None => return Ok(None),
                Some(Token::Option(name)) => return Ok(Some(name)),
                Some(Token::File(file)) => {
                    let file = input(file)?;
                    if let Some(first) = place.replace(file) {
                        let first = first.display();
                        return Err(format!("expected one file, found a second after `{first}`"));
                    }
                }
            }
        }
    }

    /// Returns true for an option that takes no value.
    pub(super) fn flag(&mut self, name: &str) -> Result<bool, String> {
        match self.parser.optional_value() {
            None => Ok(true),
            Some(value) => {
                Err(format!("{name} takes no value, found `{}`", value.to_string_lossy()))
            }
        }
    }

    /// Returns the value of an option: after its `=`, or the next argument.
    fn value(&mut self, name: &str) -> Result<OsString, String> {
        let present = |v: &OsString| !v.is_empty() && !v.as_encoded_bytes().starts_with(b"--");
        let value = self.parser.value().ok().filter(present);
        value.ok_or_else(|| format!("{name} needs a value"))
    }

    /// Returns the value of an option that takes the name of a file to read.
    pub(super) fn file(&mut self, name: &str) -> Result<PathBuf, String> {
        input(self.value(name)?)
    }

    /// Returns the value of an option that takes the name of a file or folder to write.
    pub(super) fn output(&mut self, name: &str) -> Result<PathBuf, String> {
        self.value(name).map(PathBuf::from)
    }

    /// Returns the value of an option that takes the name of a mesh file to write.
    pub(super) fn mesh(&mut self, name: &str) -> Result<PathBuf, String> {
        self.file_with(name, &FileFormat::written_meshes())
    }

    /// Returns the value of an option that takes the name of a mesh file or a scene to write.
    pub(super) fn mesh_or_scene(&mut self, name: &str) -> Result<PathBuf, String> {
        self.file_with(name, &[&FileFormat::written_meshes()[..], &["json"]].concat())
    }

    /// Returns the value of an option that takes the name of a file to write, with one of these
    /// endings or without one.
    pub(super) fn file_with(&mut self, name: &str, formats: &[&str]) -> Result<PathBuf, String> {
        let path = self.output(name)?;
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        if ending.is_some_and(|ending| !formats.contains(&&*ending)) {
            let formats: Vec<_> = formats.iter().map(|format| format!(".{format}")).collect();
            let known = match formats.split_last() {
                Some((last, others)) if !others.is_empty() => {
                    format!("{} or {last}", others.join(", "))
                }
                _ => formats.join(""),
            };
            return Err(format!("{name} writes {known}, found `{}`", path.display()));
        }
        Ok(path)
    }

    /// Returns the value of an option that takes the name of an HTML file to write.
    pub(super) fn page(&mut self, name: &str) -> Result<PathBuf, String> {
        let path = self.output(name)?;
        match path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html")) {
            true => Ok(path),
            false => Err(format!("{name} writes .html, found `{}`", path.display())),
        }
    }

    /// Returns the value of an option that takes a whole number from `least` on.
    pub(super) fn whole(&mut self, name: &str, least: u32) -> Result<u32, String> {
        let value = self.text(name)?;
        let number = value.parse().ok().filter(|&number| number >= least);
        number.ok_or_else(|| format!("{name} takes a whole number from {least}, found `{value}`"))
    }

    /// Returns the value of an option that takes an `expected` number, which `fits`.
    fn number_that(
        &mut self,
        name: &str,
        expected: &str,
        fits: fn(f64) -> bool,
    ) -> Result<f64, String> {
        let value = self.text(name)?;
        finite(&value)
            .filter(|&number| fits(number))
            .ok_or_else(|| format!("{name} takes {expected}, found `{value}`"))
    }

    /// Returns the value of an option that takes a non-negative number.
    pub(super) fn not_negative(&mut self, name: &str) -> Result<f64, String> {
        self.number_that(name, "a number from 0", |number| number >= 0.0)
    }

    /// Returns the value of an option that takes a number from 0 to 1.
    pub(super) fn share(&mut self, name: &str) -> Result<f64, String> {
        self.number_that(name, "a number from 0 to 1", |number| (0.0..=1.0).contains(&number))
    }

    /// Returns the value of an option that takes any number.
    pub(super) fn number(&mut self, name: &str) -> Result<f64, String> {
        self.number_that(name, "a number", |_| true)
    }

    /// Returns the value of an option that says how the boundary is held, and with which weight.
    pub(super) fn boundary(&mut self, name: &str) -> Result<(BoundaryRequire, f64), String> {
        let value = self.text(name)?;
        if value == BoundaryRequire::Exact.word() {
            return Ok((BoundaryRequire::Exact, 1.0));
        }
        let weight = finite(&value).filter(|&weight| weight > 0.0);
        let expected = || format!("{name} takes `exact` or a weight above 0, found `{value}`");
        weight.map(|weight| (BoundaryRequire::Soft, weight)).ok_or_else(expected)
    }

    /// Returns the value of an option that takes a positive number.
    pub(super) fn positive(&mut self, name: &str) -> Result<f64, String> {
        match self.not_negative(name)? {
            0.0 => Err(format!("{name} takes a number above 0, found 0")),
            number => Ok(number),
        }
    }

    /// Returns the value of an option that takes a positive number, or none for `auto`.
    pub(super) fn positive_or_auto(&mut self, name: &str) -> Result<Option<f64>, String> {
        let value = self.text(name)?;
        if value == "auto" {
            return Ok(None);
        }
        finite(&value)
            .filter(|&number| number > 0.0)
            .map(Some)
            .ok_or_else(|| format!("{name} takes a number above 0, or `auto`, found `{value}`"))
    }

    /// Returns the settings of a preset of Build, by its id.
    pub(super) fn preset(&mut self, name: &str, of: PresetOf) -> Result<Settings, String> {
        let value = self.text(name)?;
        let known = BuildPreset::named(of, &value).map(BuildPreset::settings);
        known.ok_or_else(|| {
            let all = BUILD_PRESETS.iter().filter(|preset| preset.of == of);
            let ids: Vec<_> = all.map(|preset| preset.id).collect();
            format!("{name} takes {}, found `{value}`", ids.join(" or "))
        })
    }

    /// Returns the settings of a sheet: those of a preset, or a width and a height.
    pub(super) fn sheet(&mut self, name: &str) -> Result<Settings, String> {
        let value = self.text(name)?;
        if let Some(preset) = BuildPreset::named(PresetOf::Sheet, &value.to_lowercase()) {
            return Ok(preset.settings());
        }
        let sides = value.split_once(['x', 'X']).and_then(|(width, height)| {
            let side = |text: &str| finite(text).filter(|&side| side > 0.0);
            Some(vec![("sheet[0]", side(width)?.into()), ("sheet[1]", side(height)?.into())])
        });
        sides.ok_or_else(|| {
            format!(
                "{name} takes a width and a height in mm, such as 1200x600, or a3, found `{value}`"
            )
        })
    }

    /// Returns the settings of a material: those of a preset, or its name.
    pub(super) fn material(&mut self, name: &str) -> Result<Settings, String> {
        let value = self.text(name)?;
        let preset = BuildPreset::named(PresetOf::Material, &value).map(BuildPreset::settings);
        Ok(preset.unwrap_or_else(|| vec![("material", value.into())]))
    }

    /// Returns the value of the option of a declared setting of Build, as in a scene: `auto` for
    /// one that may be absent; `1:50` or `50` for the scale.
    pub(super) fn setting(&mut self, name: &str, setting: &BuildSetting) -> Result<Value, String> {
        if matches!(setting.form, BuildForm::Switch) {
            return Ok(self.switch(name)?.into());
        }
        let text = self.text(name)?;
        let may_be_absent = !setting.absent.is_empty();
        if may_be_absent && text == AUTO {
            return Ok(Value::Null);
        }
        let value = match setting.form {
            BuildForm::Number { .. } => {
                let digits = text.strip_prefix("1:").filter(|_| setting.id == "scale");
                finite(digits.unwrap_or(&text)).map(Value::from)
            }
            BuildForm::Choice { options } => {
                options.iter().find(|one| one.word == text).map(|one| one.word.into())
            }
            BuildForm::Edges => edges(&text).map(|edges| json!(edges)),
            BuildForm::Switch | BuildForm::Text => Some(text.clone().into()),
        };
        let or_auto = if may_be_absent { format!(" or {AUTO}") } else { String::new() };
        let expected = || format!("{name} takes {}{or_auto}, found `{text}`", setting.expected());
        let value = value.ok_or_else(expected)?;
        match value.as_f64().and_then(|number| setting.fault(number)) {
            Some(fault) => Err(format!("{name}: {fault}")),
            None => Ok(value),
        }
    }

    /// Returns the value of an option that is on, or followed by on or off.
    fn switch(&mut self, name: &str) -> Result<bool, String> {
        let known = |value: &OsStr| match value.to_str() {
            Some("on" | "true") => Some(true),
            Some("off" | "false") => Some(false),
            _ => None,
        };
        if let Some(value) = self.parser.optional_value() {
            let found = value.to_string_lossy();
            return known(&value).ok_or_else(|| format!("{name} takes on or off, found `{found}`"));
        }
        let next = self.parser.try_raw_args();
        let next = next.and_then(|mut next| next.next_if(|value| known(value).is_some()));
        Ok(next.and_then(|value| known(&value)).unwrap_or(true))
    }

    /// Returns the value of an option that takes the `word` of one of `all`.
    pub(super) fn word_of<'a, T>(
        &mut self,
        name: &str,
        all: &'a [T],
        word: fn(&T) -> &'static str,
    ) -> Result<&'a T, String> {
        let value = self.text(name)?;
        let known = || all.iter().map(word).collect::<Vec<_>>().join(" or ");
        let found = all.iter().find(|one| word(one) == value);
        found.ok_or_else(|| format!("{name} takes {}, found `{value}`", known()))
    }

    /// Returns the value of an option that takes the id of a kind.
    pub(super) fn kind(&mut self, name: &str) -> Result<&'static str, String> {
        self.word_of(name, KINDS, |info| info.id).map(|info| info.id)
    }

    /// Returns the value of an option that takes a word of a named enum.
    pub(super) fn one_of<T: NamedEnum>(&mut self, name: &str) -> Result<T, String> {
        let value = self.text(name)?;
        let expected = || format!("{name} takes {}, found `{value}`", T::list(" or "));
        T::of_word(&value).ok_or_else(expected)
    }

    /// Returns the value of an option that takes a list of indices, such as `0-4,7`.
    pub(super) fn indices(&mut self, name: &str) -> Result<Vec<u32>, String> {
        // Either list of a set is read so.
        let set = json!({ "vertices": self.text(name)? });
        let set: Set = serde_json::from_value(set).map_err(|fault| format!("{name}: {fault}"))?;
        Ok(set.vertices.to_vec())
    }

    /// Returns the value of an option that takes an address of the web.
    pub(super) fn address(&mut self, name: &str) -> Result<String, String> {
        let value = self.text(name)?;
        match ReportView::is_web_address(&value) {
            true => Ok(value),
            false => Err(format!(
                "{name} takes an address that begins with https:// or http://, found `{value}`"
            )),
        }
    }

    /// Returns the value of an option that takes any text.
    pub(super) fn text(&mut self, name: &str) -> Result<String, String> {
        let value = self.value(name)?;
        let text = |value: &OsStr| value.to_str().map(str::to_owned);
        text(&value).ok_or_else(|| format!("the value of {name} is not UTF-8 text"))
    }
}

/// Returns the name of a file that is read, and that may be an example.
pub(super) fn input(file: OsString) -> Result<PathBuf, String> {
    match file.is_empty() {
        true => Err("the name of a file is empty".to_owned()),
        false => Ok(file.into()),
    }
}

/// Returns the finite number that a text states.
fn finite(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Returns the edges that a text such as `3-4,4-9`, or `none`, states by their vertices.
fn edges(text: &str) -> Option<Vec<[u32; 2]>> {
    if text == "none" {
        return Some(Vec::new());
    }
    let index = |text: &str| text.trim().parse::<u32>().ok();
    let edge = |text: &str| {
        let (from, to) = text.split_once('-')?;
        Some([index(from)?, index(to)?])
    };
    text.split(',').map(edge).collect()
}
