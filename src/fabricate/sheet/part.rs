//! A part to be cut from a sheet.

use crate::fabricate::panel::Point2;

/// What a line is for: its layer and its colour in every file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Cut through.
    Cut,
    /// Scored: a fold that is a ridge seen from the printed side.
    Fold,
    /// Scored from the other side: a fold that is a valley. Drawn as dashes.
    Valley,
    /// Names, as strokes.
    Engrave,
    /// The edge of the sheet and its title: not to be cut.
    Sheet,
}

impl Role {
    /// All of them, in the order in which a machine should work: names, folds, then outlines.
    pub const ALL: [Role; 5] = [Role::Sheet, Role::Engrave, Role::Fold, Role::Valley, Role::Cut];

    /// The name of its layer.
    pub fn layer(self) -> &'static str {
        match self {
            Role::Cut => "CUT",
            Role::Fold => "FOLD",
            Role::Valley => "VALLEY",
            Role::Engrave => "ENGRAVE",
            Role::Sheet => "SHEET",
        }
    }

    /// Its number among the colours of AutoCAD.
    pub fn aci(self) -> u8 {
        match self {
            Role::Cut => 1,
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
            Role::Fold => [0, 0, 255],
            Role::Valley => [255, 0, 255],
            Role::Engrave => [0, 0, 0],
            Role::Sheet => [128, 128, 128],
        }
    }
}

/// A part in a plane of its own, in mm of the sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutPart {
    /// Its name, different from all others.
    pub name: String,
    /// The panels that it is made of, or that it lies between.
    pub panels: Vec<u32>,
    /// The closed outline that is cut, counterclockwise; the first corner is not repeated.
    pub outline: Vec<Point2>,
    /// Engraved polylines.
    pub engraved: Vec<Vec<Point2>>,
    /// Folds that are ridges seen from the printed side.
    pub ridges: Vec<Vec<Point2>>,
    /// Folds that are valleys, each dash a line.
    pub valleys: Vec<Vec<Point2>>,
}
