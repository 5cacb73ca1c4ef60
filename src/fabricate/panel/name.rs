//! Names of panels: short, stable, the same on every sheet and in every list.
//!
//! `P12` is face 12 of the mesh, counted from 0 as everywhere; faces of the file that are left as they
//! are, [`crate::mesh::Mesh::untouched`], do not count. On a mesh that is one grid of quads,
//! names by row and column (`C-07`) are an option, because builders work in rows. On every mesh they may
//! be numbered in the order of assembly: `A1` to `A12` stand on the ground, `B1` is above. Then nodes with fins
//! have numbers in this order, too, and fins the numbers of their nodes.

use crate::fabricate::surface::PanelSurface;
use crate::math::{argsort, key_of_pair};
use crate::scene::Names;

/// The names of all panels, which are assembled in these rows, and whether they are as asked for: names
/// by row and column need a grid.
pub fn panel_names(
    surface: &PanelSurface,
    names: Names,
    assembly: &[Vec<u32>],
) -> (Vec<String>, bool) {
    let grid = match names {
        Names::Rows => grid_places(surface),
        Names::Index => None,
        Names::Assembly => {
            let mut found = vec![String::new(); surface.faces.len()];
            // Nodes, pieces of paper and types have these names.
            let free = (0..).map(letters).filter(|row| !["N", "S", "T"].contains(&&**row));
            for (own, row) in assembly.iter().zip(free) {
                for (&f, number) in own.iter().zip(1..) {
                    found[f as usize] = format!("{row}{number}");
                }
            }
            return (found, true);
        }
    };
    match grid {
        Some(places) => {
            let columns = places.iter().map(|place| place[1]).max().unwrap_or(0) + 1;
            let digits = columns.to_string().len().max(2);
            let name =
                |&[row, column]: &[u32; 2]| format!("{}-{:0digits$}", letters(row), column + 1);
            (places.iter().map(name).collect(), true)
        }
        None => {
            let numbered = (0..surface.faces.len()).map(|f| format!("P{f}")).collect();
            (numbered, names == Names::Index)
        }
    }
}

/// Letters: A, B, ..., Z, AA, AB, ...
fn letters(row: u32) -> String {
    let mut rest = row + 1;
    let mut name = String::new();
    while rest > 0 {
        rest -= 1;
        name.insert(0, char::from(b'A' + (rest % 26) as u8));
        rest /= 26;
    }
    name
}

/// Row and column of each face if all faces are quads of one connected grid; else none.
fn grid_places(surface: &PanelSurface) -> Option<Vec<[u32; 2]>> {
    if surface.faces.iter().any(|face| face.len() != 4) {
        return None;
    }
    // Row and column of each face, and its side towards the next column.
    let mut found: Vec<Option<([i64; 2], usize)>> = vec![None; surface.faces.len()];
    *found.first_mut()? = Some(([0, 0], 1));
    let (mut queue, mut next) = (vec![0_u32], 0);
    const STEPS: [[i64; 2]; 4] = [[0, 1], [1, 0], [0, -1], [-1, 0]];
    while let Some(&f) = queue.get(next) {
        next += 1;
        let (place, ahead) = found[f as usize]?;
        let sides = surface.sides.row(f as usize);
        for (k, step) in STEPS.iter().enumerate() {
            let e = *sides.get((ahead + k) % 4)?;
            let Some(across) = surface.edges[e as usize].across(f) else { continue };
            let back = surface.sides.row(across as usize).iter().position(|&side| side == e)?;
            // There the edge is on the near side; the opposite side continues in the same
            // direction.
            let own = ([place[0] + step[0], place[1] + step[1]], (back + 2 + 4 - k) % 4);
            match found[across as usize] {
                None => {
                    found[across as usize] = Some(own);
                    queue.push(across);
                }
                Some(other) if other != own => return None,
                Some(_) => {}
            }
        }
    }
    let places: Vec<[i64; 2]> =
        found.into_iter().map(|found| found.map(|(place, _)| place)).collect::<Option<_>>()?;
    let low = [0, 1].map(|k| places.iter().map(|place| place[k]).min().unwrap_or(0));
    let places: Vec<[u32; 2]> =
        places.iter().map(|place| [0, 1].map(|k| (place[k] - low[k]) as u32)).collect();
    let sorted = argsort(places.iter().map(|&place| key_of_pair(place)));
    let are_two = |pair: &[u32]| places[pair[0] as usize] != places[pair[1] as usize];
    sorted.windows(2).all(are_two).then_some(places)
}

#[cfg(test)]
mod tests {
    use super::letters;

    #[test]
    fn rows_are_lettered_as_in_a_table() {
        assert_eq!([0, 25, 26, 701, 702].map(letters), ["A", "Z", "AA", "ZZ", "AAA"]);
    }
}
