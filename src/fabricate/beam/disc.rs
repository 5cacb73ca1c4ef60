//! Node discs: plates perpendicular to the axis of a node, with a slot for the tenon of each of its
//! fins. All fins of a node contain its axis, so that its tenons are parallel, and the disc is pushed
//! onto all of them at once, whatever the other nodes do. It lies on the side away from the surface,
//! where nothing else is fixed to the fins.
//!
//! With the thickness `T` of plates, the clearance `c` on each side, and the least wall `w`, all in
//! the plane of the disc:
//!
//! - A slot is as wide as the fin and its drift through the disc, `g = T / cos d + T |tan d| + 2 c`
//!   (see `seat`), and lies where the plane of the fin crosses the middle of the disc at the height `Z`:
//!   to the left of the radius by `s = (Z + T/2) tan d`. With `u = g/2 + |s|` for the wider of two fins,
//!   whose directions differ by `f`, a wall `w` is left between the inner corners of their slots if these
//!   begin at the radius `(w + 2 u cos(f/2)) / (2 sin(f/2))` or farther out.
//! - A tenon begins there plus `c`, or where its fin ends if that is farther out. Its slot ends where
//!   a wall is left to the rim, of radius `R`: at `sqrt((R - w)^2 - u^2)`, and the tenon `c` before.
//!   The smallest disc is that on which the shortest tenon has its least length.
//! - The seat `Z` is the greatest height up to which all fins of the node have material as far as
//!   `R + c`. Those that rise beyond it end there in a wall along the axis.
//!
//! A disc is made only if no wall is thinner, nor the fins below it lower, than is said below, and it
//! keeps clear of other discs and of fins that do not end at its node.

use super::fin::Fin;
use super::near::Near;
use super::node::Node;
use super::seat::{FinEnd, Seat, seated};
use super::size::{DiscSize, FrameSize};
use crate::fabricate::panel::is_simple;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use crate::math::plane::Point2;

/// Least height of a fin below its seat, relative to its height at the node.
const LEAST_NECK: f64 = 1.0 / 3.0;
/// Sine of half the angle between two fins below which they have the same direction.
const SAME: f64 = 1e-3;

/// A slot of a disc.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// The edge of the fin.
    pub edge: u32,
    /// Its corners in the plane of the disc, counterclockwise seen from outside: about the axis, with
    /// x along [`Node::across`]. The first two are on the right, seen along the fin from the node.
    pub corners: [Point2; 4],
}

/// A disc, in the unit of the mesh.
#[derive(Clone, Debug)]
pub struct Disc {
    /// The vertex of its node.
    pub vertex: u32,
    /// Its radius.
    pub radius: f64,
    /// The position along the axis of the side that lies on the fins; negative inwards.
    pub seat: f64,
    /// A slot for each fin, in the order of the node.
    pub slots: Vec<Slot>,
    /// The least height of a fin below it.
    pub neck: f64,
    /// The largest angle between the axis and the plane of a fin, in degrees.
    pub lean_deg: f64,
}

/// The fins of a node that have an end there: edge, and which of its ends.
type EndsOfNode = Vec<(u32, usize, FinEnd)>;

/// The disc of each node that is an end of fins, or the reason why there is none. Fins get their seats.
pub(super) fn discs(
    (surface, axes): (&PanelSurface, &[Vec3<f64>]),
    nodes: &[Option<Node>],
    fins: &mut [Result<Fin, &'static str>],
    size: FrameSize,
    own: DiscSize,
) -> Vec<Option<Result<Disc, &'static str>>> {
    let thick = size.height.signum() * size.thickness;
    let mut near = Near::new(surface, axes, fins);
    let mut seats: Vec<[Option<(FinEnd, Seat)>; 2]> = vec![[None; 2]; fins.len()];
    let mut found = Vec::new();
    for node in nodes {
        let Some(node) = node else {
            found.push(None);
            continue;
        };
        let end_of = |edge: u32| {
            let fin = fins[edge as usize].as_ref().ok()?;
            let end = usize::from(surface.edges[edge as usize].ends[1] == node.vertex);
            let place = (surface, axes);
            let found = FinEnd::new(place, (edge, end), fin, size.height, size.thickness)?;
            Some((edge, end, found))
        };
        let ends: EndsOfNode = node.spokes.iter().filter_map(|spoke| end_of(spoke.edge)).collect();
        if ends.is_empty() {
            found.push(None);
            continue;
        }
        let made = planned(node, &ends, size, own).and_then(|(disc, own_seats)| {
            for ((edge, end, place), seat) in ends.iter().zip(&own_seats) {
                let e = *edge as usize;
                let Ok(fin) = &fins[e] else { continue };
                let mut both = seats[e];
                both[*end] = Some((*place, *seat));
                fits(surface, fin, *edge, &both, own.wall)?;
            }
            let (middle, half) = (disc.seat + 0.5 * thick, 0.5 * size.thickness);
            let radius = (disc.radius * disc.radius + half * half).sqrt();
            let centre = surface.at(node.vertex) + node.axis * middle;
            near.take(node.vertex, (centre, radius), half)?;
            for ((edge, end, place), seat) in ends.iter().zip(own_seats) {
                seats[*edge as usize][*end] = Some((*place, seat));
            }
            Ok(disc)
        });
        found.push(Some(made));
    }
    for ((fin, both), edge) in fins.iter_mut().zip(&seats).zip(&surface.edges) {
        if let Ok(fin) = fin {
            fin.cut = outline(fin, edge.ends, both);
        }
    }
    found
}

/// The outline of a fin with the seats at the first and the second node of its edge.
fn outline(fin: &Fin, nodes: [u32; 2], both: &[Option<(FinEnd, Seat)>; 2]) -> Vec<Point2> {
    let at = |side: usize| {
        let end = usize::from(nodes[1] == fin.ends[side]);
        both[end].as_ref().map(|(end, seat)| (end, seat))
    };
    seated(fin, [at(0), at(1)])
}

/// Whether a fin has room for these seats, with a wall between them.
fn fits(
    surface: &PanelSurface,
    fin: &Fin,
    edge: u32,
    both: &[Option<(FinEnd, Seat)>; 2],
    wall: f64,
) -> Result<(), &'static str> {
    if let [Some((first, one)), Some((second, other))] = both {
        let [left, right] = [first.extent(one)[1], second.extent(other)[0]];
        if right - left < wall {
            return Err("a fin is too short for its seat and that of the next disc");
        }
    }
    match is_simple(&outline(fin, surface.edges[edge as usize].ends, both)) {
        true => Ok(()),
        false => Err("a fin has no room for its seat"),
    }
}

/// The disc of a node by itself, and the seats on its fins.
fn planned(
    node: &Node,
    ends: &EndsOfNode,
    size: FrameSize,
    own: DiscSize,
) -> Result<(Disc, Vec<Seat>), &'static str> {
    if ends.len() < 2 {
        return Err("it joins fewer than two fins");
    }
    let DiscSize { clearance, wall, .. } = own;
    let thickness = size.thickness;
    let width = |end: &FinEnd| {
        thickness / end.lean.cosine + thickness * end.lean.drift.abs() + 2.0 * clearance
    };
    let highest = ends.iter().map(|(.., end)| end.height.max(end.level(end.back)));
    let highest = highest.fold(0.0, f64::max);
    // From the radius to the farther side of a slot: the seat is nowhere higher than the fins.
    let half = |end: &FinEnd| 0.5 * width(end) + end.lean.drift.abs() * (highest + thickness);
    let mut starts = Vec::new();
    for (k, (.., end)) in ends.iter().enumerate() {
        let mut start = end.back;
        for (j, (.., other)) in ends.iter().enumerate() {
            if j == k {
                continue;
            }
            let between = end.lean.along.dot(other.lean.along).clamp(-1.0, 1.0);
            let [sine, cosine] = [-1.0, 1.0].map(|sign| (0.5 * (1.0 + sign * between)).sqrt());
            if sine < SAME {
                return Err("two of its fins have the same direction");
            }
            let wider = half(end).max(half(other));
            start = start.max((wall + 2.0 * wider * cosine) / (2.0 * sine) + clearance);
        }
        starts.push(start);
    }
    let needed = ends.iter().zip(&starts).map(|((.., end), start)| {
        let (along, across) = (start + own.tenon + clearance, half(end));
        (along * along + across * across).sqrt() + wall
    });
    let needed = needed.fold(0.0, f64::max);
    let radius = match own.diameter {
        Some(diameter) if 0.5 * diameter < needed => return Err("its slots need a larger disc"),
        Some(diameter) => 0.5 * diameter,
        None => 0.5 * own.step * (2.0 * needed / own.step).ceil(),
    };
    let rim = radius + clearance;
    if ends.iter().any(|(.., end)| end.reach < rim + wall) {
        return Err("a fin is too short for its seat");
    }
    let level = ends.iter().map(|(.., end)| end.level(end.back).min(end.level(rim)));
    let level = level.fold(f64::INFINITY, f64::min);
    let side = size.height.signum();
    let (mut slots, mut seats, mut neck) = (Vec::new(), Vec::new(), f64::INFINITY);
    for ((edge, _, end), start) in ends.iter().zip(starts) {
        let across = half(end);
        let stop = ((radius - wall) * (radius - wall) - across * across).sqrt();
        let seat = end.seat(level, [start, stop - clearance], rim);
        let below = end.neck(&seat);
        if below < wall.max(LEAST_NECK * end.height) {
            return Err("its fins are too low for a seat there");
        }
        neck = neck.min(below);
        seats.push(seat);
        let along = end.lean.along;
        let x = [along.dot(node.across), along.dot(node.axis.cross(node.across))];
        let shift = side * (level + 0.5 * thickness) * end.lean.drift;
        let [right, left] = [-1.0, 1.0].map(|sign| shift + sign * 0.5 * width(end));
        let put = |r: f64, y: f64| [r * x[0] - y * x[1], r * x[1] + y * x[0]];
        let from = start - clearance;
        let corners = [put(from, right), put(stop, right), put(stop, left), put(from, left)];
        slots.push(Slot { edge: *edge, corners });
    }
    let steepest = ends.iter().map(|(.., end)| end.lean.drift.abs()).fold(0.0, f64::max);
    let disc = Disc {
        vertex: node.vertex,
        radius,
        seat: side * level,
        slots,
        neck,
        lean_deg: libm::atan(steepest).to_degrees(),
    };
    Ok((disc, seats))
}

impl Disc {
    /// A point over its plane, at a height along the axis of the node, in space.
    pub fn in_space(
        &self,
        surface: &PanelSurface,
        node: &Node,
        [x, y]: Point2,
        height: f64,
    ) -> Vec3<f64> {
        let left = node.axis.cross(node.across);
        surface.at(self.vertex) + node.axis * height + node.across * x + left * y
    }
}
