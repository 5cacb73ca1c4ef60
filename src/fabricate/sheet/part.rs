//! A part to be cut from a sheet, and its position there.

use crate::fabricate::panel::{perimeter, sides};
use crate::math::plane::{Point2, area, bounds, distance, dot, minus, rotated};
use crate::math::{cosine, sine};

/// The purpose of a line: its layer and its colour in every file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Cut through.
    Cut,
    /// Cut through, inside a part and before its outline.
    Hole,
    /// Scored: a fold that is a ridge seen from the printed side.
    Fold,
    /// Scored from the other side: a fold that is a valley. Drawn as dashes.
    Valley,
    /// Names, as strokes.
    Engrave,
    /// The border of the sheet and its title: not to be cut.
    Sheet,
}

impl Role {
    /// All roles, in the order in which a machine should work: names, folds, holes, then outlines.
    pub const ALL: [Role; 6] =
        [Role::Sheet, Role::Engrave, Role::Fold, Role::Valley, Role::Hole, Role::Cut];

    /// The name of its layer.
    pub fn layer(self) -> &'static str {
        match self {
            Role::Cut => "CUT",
            Role::Hole => "HOLE",
            Role::Fold => "FOLD",
            Role::Valley => "VALLEY",
            Role::Engrave => "ENGRAVE",
            Role::Sheet => "SHEET",
        }
    }

    /// Its AutoCAD colour index.
    pub fn aci(self) -> u8 {
        match self {
            Role::Cut => 1,
            Role::Hole => 30,
            Role::Fold => 5,
            Role::Valley => 6,
            Role::Engrave => 7,
            Role::Sheet => 8,
        }
    }

    /// Its colour as red, green and blue.
    pub fn rgb(self) -> [u8; 3] {
        match self {
            Role::Cut => [255, 0, 0],
            Role::Hole => [255, 127, 0],
            Role::Fold => [0, 0, 255],
            Role::Valley => [255, 0, 255],
            Role::Engrave => [0, 0, 0],
            Role::Sheet => [128, 128, 128],
        }
    }
}

/// What is cut out inside a part, in mm of the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole {
    /// Its centre; of a slot, that of its box along the axes.
    pub centre: Point2,
    /// Its radius; of a slot, the distance of its farthest corner from its centre.
    pub radius: f64,
    /// The outline of a slot, counterclockwise, whose first side is along it; none of a round hole.
    pub slot: Option<Vec<Point2>>,
    /// Of a hole that a panel has in the model, for each side of its outline the name of what lies
    /// beyond it, if it is to be written there; empty of other holes.
    pub neighbours: Vec<Option<String>>,
}

impl Hole {
    /// A round hole.
    pub fn round(centre: Point2, radius: f64) -> Hole {
        Hole { centre, radius, slot: None, neighbours: Vec::new() }
    }

    /// A slot with this outline.
    pub fn slot(outline: Vec<Point2>) -> Hole {
        let [low, high] = bounds(outline.iter().copied());
        let centre = [0, 1].map(|x| 0.5 * (low[x] + high[x]));
        let radius = outline.iter().map(|&corner| distance(centre, corner)).fold(0.0, f64::max);
        Hole { centre, radius, slot: Some(outline), neighbours: Vec::new() }
    }

    /// A hole that a panel has in the model.
    pub fn opening(outline: Vec<Point2>, neighbours: Vec<Option<String>>) -> Hole {
        Hole { neighbours, ..Hole::slot(outline) }
    }

    /// The outline of a hole that a panel has in the model.
    pub fn as_opening(&self) -> Option<&[Point2]> {
        self.slot.as_deref().filter(|_| !self.neighbours.is_empty())
    }

    /// The sides at which a name is to be written, with the part on their left, and the name.
    pub fn named_sides(&self) -> impl Iterator<Item = ([Point2; 2], &str)> {
        let sides = self.as_opening().into_iter().flat_map(sides);
        let named = sides.zip(&self.neighbours);
        named.filter_map(|([p, q], name)| Some(([q, p], name.as_deref()?)))
    }

    /// A closed polygon, also for a circle: machines that sort by closed outlines then find only
    /// polylines.
    pub fn outline(&self) -> Vec<Point2> {
        const CORNERS: u32 = 32;
        self.slot.clone().unwrap_or_else(|| circle(self.centre, self.radius, CORNERS))
    }

    /// The length of its outline.
    pub fn perimeter(&self) -> f64 {
        let round = || std::f64::consts::TAU * self.radius;
        self.slot.as_ref().map_or_else(round, |outline| perimeter(outline))
    }

    /// How far it reaches from a point in the direction of a unit vector.
    pub fn reach(&self, from: Point2, along: Point2) -> f64 {
        let to = |point: Point2| dot(minus(point, from), along);
        match &self.slot {
            None => to(self.centre) + self.radius,
            Some(outline) => {
                outline.iter().map(|&point| to(point)).fold(f64::NEG_INFINITY, f64::max)
            }
        }
    }
}

/// A polygon with so many corners on a circle, counterclockwise; the first is to the right.
pub fn circle(centre: Point2, radius: f64, corners: u32) -> Vec<Point2> {
    let corner = |k: u32| {
        let turns = f64::from(k) / f64::from(corners);
        [centre[0] + radius * cosine(turns), centre[1] + radius * sine(turns)]
    };
    (0..corners).map(corner).collect()
}

/// Where the name of a part is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NamePlace {
    /// Nowhere: there is no room, the part is on no sheet, or no name is requested.
    #[default]
    Nowhere,
    /// On the part.
    OnPart,
    /// On the waste beside it.
    BesidePart,
}

impl NamePlace {
    /// Its words in tables.
    pub fn words(self) -> &'static str {
        match self {
            NamePlace::Nowhere => "nowhere",
            NamePlace::OnPart => "on it",
            NamePlace::BesidePart => "beside it",
        }
    }
}

/// A part in its own plane, in mm of the sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutPart {
    /// Its name, unique among the parts.
    pub name: String,
    /// Where the name is written.
    pub named: NamePlace,
    /// The panels that it is made of, or lies between.
    pub panels: Vec<u32>,
    /// The closed outline that is cut, counterclockwise; the first corner is not repeated.
    pub outline: Vec<Point2>,
    /// The name of what lies beyond each side of the outline, if it is to be written there.
    pub neighbours: Vec<Option<String>>,
    /// For each of them, the bevel there in degrees, if it is to be written too.
    pub bevels: Vec<Option<f64>>,
    /// Where its arrow points, as a unit vector: upwards in the model, or on a fin to its side at the edge
    /// of the model.
    pub arrow: Option<Point2>,
    /// Whether its letters say how it lies: they run along the x axis of the part, however it is
    /// rotated on its sheet.
    pub is_oriented: bool,
    /// Holes in it.
    pub holes: Vec<Hole>,
    /// Engraved polylines.
    pub engraved: Vec<Vec<Point2>>,
    /// Folds that are ridges seen from the printed side.
    pub ridges: Vec<Vec<Point2>>,
    /// Folds that are valleys, one line for each dash.
    pub valleys: Vec<Vec<Point2>>,
}

impl CutPart {
    /// Turns it over, about its y axis. Its sides are as many as its neighbours.
    pub fn turn_over(&mut self) {
        let mirror = |points: &mut Vec<Point2>| points.iter_mut().for_each(|at| at[0] = -at[0]);
        mirror(&mut self.outline);
        // Counterclockwise again; what is beyond stays with its side.
        self.outline.reverse();
        reverse_sides(&mut self.neighbours);
        reverse_sides(&mut self.bevels);
        for hole in &mut self.holes {
            hole.centre[0] = -hole.centre[0];
            if let Some(slot) = &mut hole.slot {
                mirror(slot);
                slot.reverse();
            }
            reverse_sides(&mut hole.neighbours);
        }
        for lines in [&mut self.engraved, &mut self.ridges, &mut self.valleys] {
            lines.iter_mut().for_each(mirror);
        }
        if let Some(arrow) = &mut self.arrow {
            arrow[0] = -arrow[0];
        }
    }

    /// Its area without its holes, in square mm.
    pub fn area(&self) -> f64 {
        self.holes.iter().fold(area(&self.outline), |left, hole| left - area(&hole.outline()))
    }
}

/// Reverses a list of one value for each side of a polygon, whose corners are reversed.
fn reverse_sides<T>(values: &mut [T]) {
    values.reverse();
    if !values.is_empty() {
        values.rotate_left(1);
    }
}

/// A sheet of material, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetSize {
    /// Width and height.
    pub size: [f64; 2],
    /// Free margin at the edges.
    pub margin: f64,
    /// Free gap between parts.
    pub gap: f64,
}

/// Position of a part: rotated about the origin, then translated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The index of the part.
    pub part: usize,
    /// Rotation, as cosine and sine.
    pub turn: Point2,
    /// Translation, in mm from the lower left corner of the sheet.
    pub offset: Point2,
}

impl Place {
    /// Maps a point of the part to the sheet.
    pub fn to_sheet(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.offset[0], y + self.offset[1]]
    }

    /// The lower left corner of the box of its outline on the sheet.
    pub fn corner(&self, outline: &[Point2]) -> Point2 {
        bounds(outline.iter().map(|&point| self.to_sheet(point)))[0]
    }

    /// The inverse of [`Place::to_sheet`].
    pub fn to_part(&self, [x, y]: Point2) -> Point2 {
        let [c, s] = self.turn;
        rotated([x - self.offset[0], y - self.offset[1]], [c, -s])
    }

    /// The axis of the sheet, in either direction, that is nearest to the x axis of the part.
    pub fn axis_along_part(&self) -> Point2 {
        let [c, s] = self.turn;
        if c.abs() >= s.abs() { [c.signum(), 0.0] } else { [0.0, s.signum()] }
    }

    /// The angle by which the part is rotated, in degrees.
    pub fn turn_deg(&self) -> f64 {
        libm::atan2(self.turn[1], self.turn[0]).to_degrees()
    }
}
