//! Elimination of linear equations with small integer coefficients between unknowns of which some are
//! integers, so that every solution has integers where they are demanded.
//!
//! Each equation is solved for a continuous unknown if it has one, else for an integer one with the
//! coefficient one or minus one. If there is none, unknowns are combined as in Euclid's algorithm
//! until there is: `v = v' - q w` with a new integer v' is invertible in integers.

/// A sum of unknowns with coefficients, ascending by unknown, none zero.
pub(super) type Row = Vec<(u32, f64)>;

/// Unknowns, and those that are expressed by others.
pub(super) struct Elimination {
    is_integer: Vec<bool>,
    /// What an eliminated unknown equals.
    known: Vec<Option<Row>>,
}

impl Elimination {
    /// Creates unknowns, `is_integer` of each.
    pub(super) fn new(is_integer: Vec<bool>) -> Elimination {
        Elimination { known: vec![None; is_integer.len()], is_integer }
    }

    /// Whether an unknown is an integer.
    pub(super) fn is_integer(&self, unknown: u32) -> bool {
        self.is_integer[unknown as usize]
    }

    /// Imposes that the sum is zero.
    pub(super) fn impose(&mut self, row: &[(u32, f64)]) {
        loop {
            let mut row = self.expand(row);
            let whole = row.iter().all(|&(v, _)| self.is_integer(v));
            if whole {
                divide_by_common_factor(&mut row);
            }
            // Least is best: continuous before integer, coefficient one before others, then the
            // latest unknown.
            let rank = |&(v, c): &(u32, f64)| (self.is_integer(v), c.abs() != 1.0, u32::MAX - v);
            let Some(&(pivot, factor)) = row.iter().min_by_key(|entry| rank(entry)) else { return };
            if !whole || factor.abs() == 1.0 || row.len() == 1 {
                let others = row.iter().filter(|&&(v, _)| v != pivot);
                let value = others.map(|&(v, c)| (v, -c / factor)).collect();
                self.known[pivot as usize] = Some(value);
                return;
            }
            self.combine(&row);
        }
    }

    /// Replaces the unknown with the least coefficient by a new one, such that the coefficients of
    /// the others become remainders.
    fn combine(&mut self, row: &Row) {
        let least = row.iter().min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let &(pivot, factor) = least.expect("the row is not empty");
        let new = self.is_integer.len() as u32;
        self.is_integer.push(true);
        self.known.push(None);
        let others = row.iter().filter(|&&(v, _)| v != pivot);
        let quotients = others.map(|&(v, c)| (v, -(c / factor).floor()));
        let mut value: Row = quotients.filter(|&(_, q)| q != 0.0).collect();
        value.push((new, 1.0));
        self.known[pivot as usize] = Some(value);
    }

    /// What an unknown equals, in unknowns that are not eliminated.
    pub(super) fn value(&mut self, unknown: u32) -> Row {
        if self.known[unknown as usize].is_none() {
            return vec![(unknown, 1.0)];
        }
        // From what it depends on to itself, without recursion: chains along a seam are long.
        let mut waiting = vec![unknown];
        while let Some(&v) = waiting.last() {
            let row = self.known[v as usize].as_ref().expect("only eliminated unknowns wait");
            let depends = |&&(w, _): &&(u32, f64)| self.is_deep(w);
            let deep: Vec<u32> = row.iter().filter(depends).map(|&(w, _)| w).collect();
            if !deep.is_empty() {
                waiting.extend(deep);
                continue;
            }
            waiting.pop();
            let mut entries = Vec::new();
            for &(w, c) in row {
                match &self.known[w as usize] {
                    None => entries.push((w, c)),
                    Some(value) => entries.extend(value.iter().map(|&(u, d)| (u, c * d))),
                }
            }
            self.known[v as usize] = Some(collected(entries));
        }
        self.known[unknown as usize].clone().expect("it is eliminated")
    }

    /// Whether an unknown is eliminated, and by unknowns that are eliminated themselves.
    fn is_deep(&self, unknown: u32) -> bool {
        let row = self.known[unknown as usize].as_ref();
        row.is_some_and(|row| row.iter().any(|&(w, _)| self.known[w as usize].is_some()))
    }

    fn expand(&mut self, row: &[(u32, f64)]) -> Row {
        let mut entries = Vec::new();
        for &(v, c) in row {
            entries.extend(self.value(v).into_iter().map(|(w, d)| (w, c * d)));
        }
        collected(entries)
    }
}

/// Sorts a sum, and adds the coefficients of each unknown.
fn collected(mut entries: Row) -> Row {
    entries.sort_by_key(|&(v, _)| v);
    let mut sums: Row = Vec::with_capacity(entries.len());
    for (v, c) in entries {
        match sums.last_mut() {
            Some(last) if last.0 == v => last.1 += c,
            _ => sums.push((v, c)),
        }
    }
    sums.retain(|&(_, c)| c != 0.0);
    sums
}

fn divide_by_common_factor(row: &mut Row) {
    let gcd = |mut a: f64, mut b: f64| {
        while b != 0.0 {
            (a, b) = (b, a - b * (a / b).floor());
        }
        a
    };
    // Coefficients may be halves or quarters.
    let common = row.iter().fold(0.0, |common, &(_, c)| gcd(4.0 * c.abs(), common));
    if common > 0.0 {
        row.iter_mut().for_each(|(_, c)| *c *= 4.0 / common);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Whatever the equations, integers for the free unknowns give integers for all that must
        /// be, and every equation holds.
        #[test]
        fn solutions_are_integers(
            rows in proptest::collection::vec(
                proptest::collection::vec((0u32..9, -3i32..4), 1..5), 1..6),
            free in proptest::collection::vec(-5i32..6, 40),
        ) {
            let rows: Vec<Row> = rows
                .into_iter()
                .map(|row| collected(row.into_iter().map(|(v, c)| (v, f64::from(c))).collect()))
                .collect();
            let mut elimination = Elimination::new(vec![true; 9]);
            rows.iter().for_each(|row| elimination.impose(row));
            let values: Vec<f64> = (0..9)
                .map(|v| {
                    let value = elimination.value(v);
                    value.iter().map(|&(w, c)| c * f64::from(free[w as usize % 40])).sum()
                })
                .collect();
            for row in &rows {
                let sum: f64 = row.iter().map(|&(v, c)| c * values[v as usize]).sum();
                prop_assert_eq!(sum, 0.0, "{:?}: {:?}", row, values);
            }
            prop_assert!(values.iter().all(|value| value.fract() == 0.0), "{:?}", values);
        }
    }

    #[test]
    fn a_continuous_unknown_goes_before_an_integer_one() {
        let mut elimination = Elimination::new(vec![true, false, true]);
        elimination.impose(&[(0, 1.0), (1, 2.0), (2, -1.0)]);
        assert_eq!(elimination.value(1), [(0, -0.5), (2, 0.5)]);
        // An integer that equals a continuous unknown makes it one.
        elimination.impose(&[(1, 1.0), (0, -1.0)]);
        assert_eq!(elimination.value(2), [(0, 3.0)]);
        assert_eq!(elimination.value(1), [(0, 1.0)]);
    }
}
