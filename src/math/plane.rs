//! Points and vectors of the plane.

/// A point or vector of the plane.
pub type Point2 = [f64; 2];

/// `a - b`.
pub fn minus([a, b]: Point2, [c, d]: Point2) -> Point2 {
    [a - c, b - d]
}

/// The dot product.
pub fn dot([a, b]: Point2, [c, d]: Point2) -> f64 {
    a * c + b * d
}

/// The cross product: positive if the second vector is to the left of the first.
pub fn cross([a, b]: Point2, [c, d]: Point2) -> f64 {
    a * d - b * c
}

/// The length of a vector.
pub fn length([a, b]: Point2) -> f64 {
    (a * a + b * b).sqrt()
}

/// The distance of two points.
pub fn distance(a: Point2, b: Point2) -> f64 {
    length(minus(b, a))
}

/// A point rotated about the origin by the angle with this cosine and sine.
pub fn rotated([x, y]: Point2, [c, s]: Point2) -> Point2 {
    [c * x - s * y, s * x + c * y]
}

/// Least and greatest coordinates of points; infinite without points.
pub fn bounds(points: impl IntoIterator<Item = Point2>) -> [Point2; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for [x, y] in points {
        low = [low[0].min(x), low[1].min(y)];
        high = [high[0].max(x), high[1].max(y)];
    }
    [low, high]
}

/// The signed area of a polygon, positive if counterclockwise.
pub fn area(polygon: &[Point2]) -> f64 {
    let Some(&first) = polygon.first() else { return 0.0 };
    // Relative to a corner: far from the origin the products would lose digits.
    let sides = super::polygon_sides(polygon);
    let twice: f64 = sides.map(|[p, q]| cross(minus(p, first), minus(q, first))).sum();
    0.5 * twice
}

/// The first coordinates of the points where the sides of a polygon cross the line of the second
/// coordinate `y`.
pub fn crossings(polygon: &[Point2], y: f64) -> impl Iterator<Item = f64> + '_ {
    super::polygon_sides(polygon)
        .filter(move |[p, q]| (p[1] > y) != (q[1] > y))
        .map(move |[p, q]| p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
}

/// Whether a point is inside a polygon: a ray from it crosses an odd number of sides.
pub fn is_inside(polygon: &[Point2], [x, y]: Point2) -> bool {
    crossings(polygon, y).filter(|crossing| x < *crossing).count() % 2 == 1
}
