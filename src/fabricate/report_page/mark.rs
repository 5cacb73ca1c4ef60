//! The marks on a page, in mm from its lower left corner, y upwards.

use super::helvetica::width;
use crate::math::plane::Point2;

/// Red, green and blue.
pub(super) type Colour = [u8; 3];

pub(super) const BLACK: Colour = [28, 30, 36];
pub(super) const GREY: Colour = [104, 108, 118];
pub(super) const PALE: Colour = [205, 208, 215];
pub(super) const RED: Colour = [190, 30, 45];

/// An element of a page.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Mark {
    Text(Text),
    Shape(Shape),
    /// An area that opens an address when clicked: two corners, and the address.
    Link([Point2; 2], String),
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Text {
    /// The left end of its baseline.
    pub(super) at: Point2,
    /// The font size.
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) colour: Colour,
    pub(super) words: String,
}

/// Lines or areas of one style.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shape {
    pub(super) paths: Vec<Vec<Point2>>,
    /// Fill colour of closed paths; none for lines.
    pub(super) fill: Option<Colour>,
    /// Width and colour of the lines.
    pub(super) pen: Option<(f64, Colour)>,
}

/// Text from `at` to the right.
pub(super) fn text(at: Point2, size: f64, colour: Colour, words: &str) -> Mark {
    Mark::Text(Text { at, size, bold: false, colour, words: words.to_owned() })
}

/// Text that ends at `at`.
pub(super) fn text_to([x, y]: Point2, size: f64, colour: Colour, words: &str) -> Mark {
    text([x - width(words, size), y], size, colour, words)
}

/// Bold text from `at` to the right.
pub(super) fn heading(at: Point2, size: f64, words: &str) -> Mark {
    Mark::Text(Text { at, size, bold: true, colour: BLACK, words: words.to_owned() })
}

/// A straight line.
pub(super) fn line(ends: [Point2; 2], pen: f64, colour: Colour) -> Mark {
    Mark::Shape(Shape { paths: vec![ends.into()], fill: None, pen: Some((pen, colour)) })
}

/// A filled box, by its lower left corner and size.
pub(super) fn block([x, y]: Point2, [w, h]: [f64; 2], fill: Colour) -> Mark {
    let corners = vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
    Mark::Shape(Shape { paths: vec![corners], fill: Some(fill), pen: None })
}
