//! Gathers points into lanes from rows of coordinates that are apart in memory, and adds lanes to
//! rows. The fourth number of a row is padding.

use super::register::Register;
use crate::math::{LANES, Lanes, Vec3};

impl Vec3<Lanes> {
    /// Gathers the points of these rows, one in each lane.
    #[inline(always)]
    pub fn of_rows(rows: &[[f64; 4]], at: &[u32; LANES]) -> Self {
        let mut points = Self::zero();
        for k in 0..LANES / 2 {
            let [a, b] = [rows[at[2 * k] as usize], rows[at[2 * k + 1] as usize]];
            let [xy, next_xy] = [Register::new(a[0], a[1]), Register::new(b[0], b[1])];
            points.x.0[k] = xy.lows(next_xy);
            points.y.0[k] = xy.highs(next_xy);
            points.z.0[k] = Register::new(a[2], b[2]);
        }
        points
    }

    /// Adds the vector of each lane to its row, one lane after another, since lanes may share a
    /// row.
    #[inline(always)]
    pub fn add_to_rows(self, rows: &mut [[f64; 4]], at: &[u32; LANES]) {
        for k in 0..LANES / 2 {
            let (x, y, z) = (self.x.0[k], self.y.0[k], self.z.0[k]);
            let halves = [(x.lows(y), z.low()), (x.highs(y), z.high())];
            for (half, (xy, z)) in halves.into_iter().enumerate() {
                let row = &mut rows[at[2 * k + half] as usize];
                let sum = Register::new(row[0], row[1]).add(xy);
                (row[0], row[1]) = (sum.low(), sum.high());
                row[2] += z;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::math::{LANES, Lane, Vec3};

    #[test]
    fn points_come_from_rows_and_sums_go_back_where_lanes_share_one() {
        let rows = [[1.0, 2.0, 3.0, 9.0], [4.0, 5.0, 6.0, 9.0], [7.0, 8.0, 10.0, 9.0]];
        let at: [u32; LANES] = [2, 0, 2, 1];
        let points = Vec3::of_rows(&rows, &at);
        for (lane, &row) in at.iter().enumerate() {
            assert_eq!(
                [points.x, points.y, points.z].map(|x| x.lane(lane)),
                rows[row as usize][..3]
            );
        }
        let mut sums = rows;
        points.add_to_rows(&mut sums, &at);
        let expected = [[2.0, 4.0, 6.0, 9.0], [8.0, 10.0, 12.0, 9.0], [21.0, 24.0, 30.0, 9.0]];
        assert_eq!(sums, expected);
    }
}
