//! The offset as points in space, while its distance or the shape changes, and the places on sheets
//! where elements exceed a limit.

use super::build::{Build, all_flat};
use super::check_card::Failed;
use super::offset::check;
use super::sheet::Sheet;
use crate::math::marked;
use crate::math::plane::Point2;

impl Build {
    /// The vertices of the offset (`#V by 3`), in the coordinates of the mesh; vertices of no panel
    /// stay. None if offsets are not available.
    pub fn layer(&self) -> Option<Vec<[f64; 3]>> {
        let (axes, _) = self.offset.as_ref()?;
        let distance = self.distance();
        let points = self.surface.positions.iter().zip(&axes.axes);
        Some(points.map(|(v, n)| (*v + self.surface.centre + *n * distance).into()).collect())
    }

    /// Changes the distance, keeping the axes. The choice of axes and the fins may depend on it:
    /// the next build computes them anew.
    pub fn move_layer(&mut self, distance: f64) {
        self.settings.distance = Some(distance);
        if let Some((axes, found)) = &mut self.offset {
            *found = check(&self.surface, &axes.axes, axes.kind, distance);
        }
    }

    /// Moves the shape to `positions` (`#V by 3`) with its offset of the same kind and the flatness
    /// of panels. Parts, sheets and types are those of the previous shape until the next build.
    pub fn reshape(&mut self, positions: &[[f64; 3]]) {
        self.surface.move_to(positions);
        self.flat = all_flat(&self.surface);
        if self.offset.is_none() {
            // Its first fault is the reason, which may no longer hold.
            self.faults.remove(0);
        }
        let before = self.offset.as_ref().map(|(axes, _)| axes.kind);
        self.make_offset(self.settings.kind.or(before));
    }

    /// For each sheet, the sides of panels whose beams fail, and as single points the corners whose
    /// nodes fail, in mm of the sheet.
    pub fn failed_sides(&self, failed: &Failed) -> Vec<Vec<Vec<Point2>>> {
        let edges = marked(self.surface.edges.len(), &failed.edges);
        let nodes = marked(self.surface.positions.len(), &failed.nodes);
        let of_sheet = |sheet: &Sheet| {
            let mut found = Vec::new();
            for place in &sheet.places {
                let Some(&panel) = self.parts[place.part].panels.first() else { continue };
                let f = panel as usize;
                // Empty for other products than panels. A piece has not all sides of its panel.
                let Some(Some(cut)) = self.cut.get(f) else { continue };
                if cut.pieces > 1 {
                    continue;
                }
                let corner =
                    |k: usize| place.to_sheet(self.on_part(cut.whole[k % cut.whole.len()]));
                let sides = self.surface.sides.row(f).iter().enumerate();
                let failed = sides.filter(|(_, e)| edges[**e as usize]);
                found.extend(failed.map(|(k, _)| vec![corner(k), corner(k + 1)]));
                let corners = self.surface.faces.row(f).iter().enumerate();
                let failed = corners.filter(|(_, v)| nodes[**v as usize]);
                found.extend(failed.map(|(k, _)| vec![corner(k)]));
            }
            found
        };
        self.layout.sheets.iter().map(of_sheet).collect()
    }
}
