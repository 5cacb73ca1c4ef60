//! The operations of a closed form, counted by running it: the speed page puts an iteration beside them.

use crate::support::random::{Random, centred};
use serde_json::json;
use shape_up::constraint::{Kind, KindVisitor, Projection};
use shape_up::math::{Lane, Vec3, cosine, sine};
use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

thread_local! {
    /// Additions and multiplications, then divisions and roots.
    static COUNTS: Cell<[usize; 2]> = const { Cell::new([0; 2]) };
}

/// A number that counts what is done with it. Comparisons and signs are free.
#[derive(Clone, Copy, Debug)]
struct Counted(f64);

fn counted(kind: usize, value: f64) -> Counted {
    COUNTS.with(|counts| {
        let mut now = counts.get();
        now[kind] += 1;
        counts.set(now);
    });
    Counted(value)
}

macro_rules! operators {
    ($($op:ident $method:ident $kind:literal),*) => {$(
        impl $op for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                counted($kind, self.0.$method(other.0))
            }
        }
    )*};
}
operators!(Add add 0, Sub sub 0, Mul mul 0, Div div 1);

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Counted(-self.0)
    }
}
impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl SubAssign for Counted {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Lane for Counted {
    const WIDTH: usize = 1;
    fn splat(x: f64) -> Self {
        Counted(x)
    }
    fn sqrt(self) -> Self {
        counted(1, self.0.sqrt())
    }
    fn abs(self) -> Self {
        Counted(self.0.abs())
    }
    fn max(self, other: Self) -> Self {
        Counted(Lane::max(self.0, other.0))
    }
    fn min(self, other: Self) -> Self {
        Counted(Lane::min(self.0, other.0))
    }
    fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
        if self.0 > bound.0 { yes } else { no }
    }
    fn all_greater(self, bound: Self) -> bool {
        self.0 > bound.0
    }
    fn lane(self, _: usize) -> f64 {
        self.0
    }
    fn set_lane(&mut self, _: usize, x: f64) {
        self.0 = x;
    }
}

/// Counts for so many points near their rest shape, where the closed form is accurate.
struct Count {
    points: usize,
}

impl KindVisitor for Count {
    type Output = [usize; 2];
    fn visit<P: Projection>(self, operator: &P) -> [usize; 2] {
        let mut random = Random::new(7);
        let round = |k: usize| {
            let turns = k as f64 / self.points as f64;
            Vec3::new(cosine(turns), sine(turns), 0.0)
        };
        let rest = centred(&(0..self.points).map(round).collect::<Vec<_>>());
        let moved: Vec<_> = rest.iter().map(|&p| p + random.vector() * 0.02).collect();
        let lanes = |points: &[Vec3<f64>]| -> Vec<Vec3<Counted>> {
            points.iter().map(|&p| Vec3::splat(p)).collect()
        };
        let (rest, v) = (lanes(&rest), lanes(&centred(&moved)));
        let mut projected = v.clone();
        COUNTS.with(|counts| counts.set([0; 2]));
        assert!(operator.closed_form(&rest, &v, &mut projected), "it is accurate");
        COUNTS.with(Cell::get)
    }
}

/// The counts `[each, once]` of additions and multiplications, then of divisions and roots.
fn counts(id: &str) -> [[usize; 2]; 2] {
    let kind = Kind::new(id, json!({})).expect("it needs no parameters");
    let count = |points| kind.visit(Count { points });
    let (four, five) = (count(4), count(5));
    let forms = [0, 1].map(|k| [five[k] - four[k], 5 * four[k] - 4 * five[k]]);
    for points in 6..10 {
        let expected = forms.map(|[each, once]| once + points * each);
        assert_eq!(count(points), expected, "{id}, {points} points");
    }
    forms
}

#[test]
fn the_speed_page_says_how_many_operations_a_projection_has() {
    let lines = ["circle", "rigid"].map(|id| {
        let form = |[each, once]: [usize; 2]| match each {
            0 => format!("{once}"),
            _ => format!("{once} + {each} p"),
        };
        let [operations, divisions] = counts(id).map(form);
        format!("\n| {id} | {operations} | {divisions} |")
    });
    assert!(include_str!("../../src/solve/performance.md").contains(&lines.concat()), "{lines:?}");
}
