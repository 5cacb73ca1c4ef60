//! Unit and up axis of a mesh file. The formats define neither: they are read from comments, or
//! else guessed from the shape (the axis in `up_guess`). Coordinates are never changed.

use super::{NamedEnum, Scene, SceneError, Up};
use crate::mesh::{Mesh, Point, decode, diagonal, lines};

/// Least diagonal of the bounding box of a mesh taken as a building in metres.
const METRES_FROM: f64 = 3.0;
/// Least diagonal of the bounding box of a mesh taken as a building in millimetres.
const MILLIMETRES_FROM: f64 = 500.0;

/// Unit and up axis, if known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UnitsAndUp {
    /// Unit of length.
    pub units: Option<String>,
    /// The axis that points up.
    pub up: Option<Up>,
}

/// Bytes of a file in which unit and axis are looked for: the rest may be long, and no text.
const HEADER: usize = 1 << 16;

impl UnitsAndUp {
    /// Reads unit and up axis from the comments at the beginning of a mesh file, such as
    /// `# units: m` and `# up: y`.
    pub fn stated(file: &[u8]) -> UnitsAndUp {
        let mut frame = UnitsAndUp::default();
        let is_ply = file.starts_with(b"ply");
        let file = &file[..file.len().min(HEADER)];
        for (_, line) in lines(&decode(file)) {
            let line = line.trim_ascii();
            let comment = match is_ply {
                true if line == "end_header" => break,
                true => line.strip_prefix("comment").unwrap_or_default(),
                false => match line.strip_prefix('#') {
                    Some(comment) => comment,
                    None => break,
                },
            };
            match comment.split_once(':').map(|(key, value)| (key.trim(), value.trim())) {
                Some(("units", units)) if !units.is_empty() => frame.units = Some(units.to_owned()),
                Some(("up", axis)) => frame.up = Up::of_word(axis).or(frame.up),
                _ => {}
            }
        }
        frame
    }

    /// Fills in unknown values from `other`.
    pub fn or(self, other: UnitsAndUp) -> UnitsAndUp {
        UnitsAndUp { units: self.units.or(other.units), up: self.up.or(other.up) }
    }

    /// Sets the unit of a scene without one to the unit that its mesh file states.
    pub fn complete(self, scene: &mut Scene) {
        if scene.units.is_empty() {
            scene.units = self.units.unwrap_or_default();
        }
    }

    /// Checks what the second file `name` of a scene, a surface or a pose, states: its coordinates are
    /// taken as those of the model, of which the mesh file states `own`. A statement that agrees with the
    /// mesh file or with the scene is accepted. The unit is not checked if the scene has none, the axis
    /// not if the mesh file states none.
    ///
    /// # Errors
    /// If it is another unit or another axis.
    pub fn check_second(
        &self,
        name: &str,
        own: &UnitsAndUp,
        scene: &Scene,
    ) -> Result<(), SceneError> {
        let refused = |what: &str, stated: &str, expected: &str| {
            let message = format!(
                "{name} states the {what} {stated}, expected that of the model, {expected}: give the \
                 model the same {what} first if the coordinates agree"
            );
            Err(SceneError { path: String::new(), message })
        };
        if let Some(units) = &self.units
            && self.units != own.units
            && *units != scene.units
            && !scene.units.is_empty()
        {
            return refused("unit", units, &scene.units);
        }
        match (self.up, own.up) {
            (Some(up), Some(of_model)) if up != of_model && up != scene.up => {
                refused("up axis", up.word(), scene.up.word())
            }
            _ => Ok(()),
        }
    }

    /// Returns the comments that state unit and up axis of a mesh, a line each. An empty unit gives no
    /// line, and neither do an unknown axis, and z where it would be guessed.
    pub fn comments(units: &str, up: Option<Up>, mesh: &Mesh) -> Vec<String> {
        let units: String = units.chars().filter(|c| !c.is_control()).collect();
        let units = (!units.is_empty()).then(|| format!("units: {units}"));
        let is_said = |up: &Up| *up == Up::Y || UnitsAndUp::guess_up(mesh) != *up;
        let up = up.filter(is_said).map(|up| format!("up: {}", up.word()));
        units.into_iter().chain(up).collect()
    }

    /// Returns those of unit and axis that would be guessed otherwise of a file of this mesh.
    pub fn not_guessable(&self, mesh: &Mesh) -> UnitsAndUp {
        let is_lost = |units: &String| !units.is_empty() && *units != UnitsAndUp::guess_units(mesh);
        UnitsAndUp {
            units: self.units.clone().filter(is_lost),
            up: self.up.filter(|up| *up != UnitsAndUp::guess_up(mesh)),
        }
    }

    /// Guesses the unit of a mesh from its size; empty if it is not clear.
    pub fn guess_units(mesh: &Mesh) -> &'static str {
        let size = diagonal(&mesh.body_of(&mesh.positions));
        if size >= MILLIMETRES_FROM {
            "mm"
        } else if size >= METRES_FROM {
            "m"
        } else {
            ""
        }
    }
}

/// Range of coordinates along one axis.
pub(super) struct Extent {
    pub(super) low: f64,
    high: f64,
}

impl Extent {
    /// Returns the range of `points` along `axis`.
    pub(super) fn of(points: impl Iterator<Item = Point>, axis: usize) -> Extent {
        let start = Extent { low: f64::INFINITY, high: f64::NEG_INFINITY };
        points.fold(start, |all, point| Extent {
            low: all.low.min(point[axis]),
            high: all.high.max(point[axis]),
        })
    }

    /// Returns the length of the range; 0 without points.
    pub(super) fn length(&self) -> f64 {
        (self.high - self.low).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Ragged;

    fn points(positions: Vec<Point>) -> Mesh {
        Mesh { positions, faces: Ragged::default(), ..Mesh::default() }
    }

    fn block(sides: Point) -> Mesh {
        let corners = (0..8).map(|i| [0, 1, 2].map(|axis| sides[axis] * f64::from(i >> axis & 1)));
        points(corners.collect())
    }

    #[test]
    fn what_is_written_is_read_back() {
        for (units, up) in [("m", Up::Y), ("", Up::Y), ("ft", Up::Z), ("", Up::Z)] {
            let comments = UnitsAndUp::comments(units, Some(up), &points(Vec::new()));
            let comments: String = comments.iter().map(|line| format!("# {line}\n")).collect();
            let text = comments + "v 0 0 0\n# units: km\n";
            let frame = UnitsAndUp::stated(text.as_bytes());
            assert_eq!(frame.units.unwrap_or_default(), units);
            assert_eq!(frame.up.unwrap_or(Up::Z), up);
        }
        // A wall that would be taken as a roof on its back.
        let wall = block([9.0, 0.3, 6.0]);
        assert_eq!(UnitsAndUp::guess_up(&wall), Up::Y);
        assert_eq!(UnitsAndUp::comments("", Some(Up::Z), &wall), ["up: z"]);
        let foreign = b"# Blender 4.2\r\n#\r\n# units: cm\r\n# a: b: c\r\nmtllib x.mtl\r\n";
        assert_eq!(UnitsAndUp::stated(foreign).units.as_deref(), Some("cm"));
        assert_eq!(UnitsAndUp::stated(b""), UnitsAndUp::default());
    }

    #[test]
    fn no_encoding_or_line_ending_hides_the_unit() {
        let text = "# units: m\u{b2}\n# up: y\nv 0 0 0\n";
        let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        for file in [
            [b"\xEF\xBB\xBF", text.as_bytes()].concat(),
            [b"\xFF\xFE", &utf16[..]].concat(),
            text.replace('\n', "\r").into_bytes(),
        ] {
            let expected = UnitsAndUp { units: Some("m\u{b2}".to_owned()), up: Some(Up::Y) };
            assert_eq!(UnitsAndUp::stated(&file), expected);
        }
    }

    #[test]
    fn a_building_is_in_metres_or_millimetres_and_a_unit_cube_in_nothing() {
        assert_eq!(UnitsAndUp::guess_units(&block([1.0, 1.0, 1.0])), "");
        assert_eq!(UnitsAndUp::guess_units(&block([20.0, 15.0, 4.0])), "m");
        assert_eq!(UnitsAndUp::guess_units(&block([20e3, 15e3, 4e3])), "mm");
        assert_eq!(UnitsAndUp::guess_units(&points(Vec::new())), "");
    }
}
