//! A frame in each triangle, its first axis along the first side, and what is measured in it.

use crate::math::Vec3;
use crate::mesh::form_on;
use crate::quads::surface::Prepared;
use crate::quads::{Side, Triangulation};

/// A vector in the frame of a triangle.
pub(crate) type Complex = nalgebra::Complex<f64>;

/// The number of absolute value one in the same direction; `None` of zero.
pub(crate) fn unit(z: Complex) -> Option<Complex> {
    let scale = z.re.abs().max(z.im.abs());
    if scale == 0.0 || !scale.is_finite() {
        return None;
    }
    let z = z / scale;
    Some(z / z.norm_sqr().sqrt())
}

/// The angle in radians, from -pi to pi, of the same bits natively and in wasm.
pub(crate) fn argument(z: Complex) -> f64 {
    libm::atan2(z.im, z.re)
}

/// The frames of a triangulation, `#T` each.
pub(crate) struct Frames {
    /// Area, in the squared unit of the mesh.
    pub area: Vec<f64>,
    /// First axis.
    pub x: Vec<Vec3<f64>>,
    /// Second axis, counterclockwise.
    pub y: Vec<Vec3<f64>>,
    /// Directions of the sides as complex numbers of absolute value one.
    pub sides: Vec<[Complex; 3]>,
    /// Angles of the sides, in radians from -pi to pi.
    pub angles: Vec<[f64; 3]>,
}

impl Frames {
    /// Computes the frames. Triangles have an area.
    pub(crate) fn new(surface: &Triangulation) -> Frames {
        let n = surface.triangles.len();
        let mut frames = Frames {
            area: Vec::with_capacity(n),
            x: Vec::with_capacity(n),
            y: Vec::with_capacity(n),
            sides: Vec::with_capacity(n),
            angles: Vec::with_capacity(n),
        };
        for triangle in 0..n {
            let (doubled, normal) = surface.area_vector(triangle).length_and_direction();
            let (_, x) = surface.along(Side { triangle, side: 0 }).length_and_direction();
            let x = x.unwrap_or_else(|| Vec3::new(1.0, 0.0, 0.0));
            let normal = normal.unwrap_or_else(|| x.across());
            let y = normal.cross(x);
            let side = |side: usize| {
                let along = surface.along(Side { triangle, side });
                unit(Complex::new(along.dot(x), along.dot(y))).unwrap_or(Complex::new(1.0, 0.0))
            };
            let sides = [side(0), side(1), side(2)];
            frames.area.push(0.5 * doubled);
            frames.x.push(x);
            frames.y.push(y);
            frames.angles.push(sides.map(argument));
            frames.sides.push(sides);
        }
        frames
    }

    /// A vector in the frame of a triangle.
    pub(crate) fn of(&self, triangle: usize, vector: Vec3<f64>) -> Complex {
        Complex::new(vector.dot(self.x[triangle]), vector.dot(self.y[triangle]))
    }

    /// The direction of the feature along a side, in the frame of its triangle: that of its tangent,
    /// or of the side where the tangent is normal to the triangle.
    pub(crate) fn tangent(&self, prepared: &Prepared, Side { triangle, side }: Side) -> Complex {
        let tangent = prepared.tangents[triangle][side];
        let flat = self.of(triangle, tangent);
        let seen = flat.norm_sqr() > 1e-6 * tangent.length_squared();
        unit(flat).filter(|_| seen).unwrap_or(self.sides[triangle][side])
    }

    /// The traceless part of the second fundamental form in each triangle, `(k1 - k2)/2 e^(2 i theta)`
    /// with the angle `theta` of the first principal direction: the mean of its corners.
    pub(crate) fn anisotropy(&self, prepared: &Prepared) -> Vec<Complex> {
        let of_triangle = |t: usize| {
            let mut tensor = [0.0; 6];
            for v in prepared.surface.triangles[t] {
                tensor
                    .iter_mut()
                    .zip(prepared.tensors[v])
                    .for_each(|(sum, part)| *sum += part / 3.0);
            }
            let on = |a: Vec3<f64>, b: Vec3<f64>| form_on(&tensor, a, b);
            let (x, y) = (self.x[t], self.y[t]);
            Complex::new(0.5 * (on(x, x) - on(y, y)), on(x, y))
        };
        (0..self.area.len()).map(of_triangle).collect()
    }

    /// The factor by which the n-th power of a direction in the triangle of a side is multiplied in
    /// the frame of the neighbour, which has the side as `back`; n is even.
    pub(crate) fn transport(&self, side: Side, back: Side, power: u32) -> Complex {
        let from = self.sides[side.triangle][side.side];
        let to = self.sides[back.triangle][back.side];
        let turn = to * from.conj();
        (1..power).fold(turn, |product, _| product * turn)
    }
}
