//! The ghost and the ground of a view, its projection, and its depth range.

use super::{FittedShape, ViewState, half_diagonal};
use crate::view::appearance::LineKind;
use crate::view::camera::{CameraProjection, Section, depth_range};
use crate::view::model::{ViewError, check_length, read_points};
use crate::view::overlay::Ground;
use glam::{DVec3, Vec3};

/// Distance of the ground below the mesh, as a fraction of its size as it was opened; a flat mesh does
/// not touch it.
const BELOW: f32 = 0.008;

impl ViewState {
    /// Sets the positions of the mesh as it was opened: #V by 3 in file coordinates.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite.
    pub fn set_rest(&mut self, coordinates: &[f64]) -> Result<(), ViewError> {
        let expected = self.content.mesh.exact.len() * 3;
        check_length("positions at rest", coordinates.len(), expected)?;
        self.around.rest = read_points(coordinates)?;
        self.around.extent = extent(self.content.mesh.used_of(&self.around.rest));
        self.surround();
        Ok(())
    }

    /// Shows or hides the ghost and the ground.
    pub fn set_surroundings(&mut self, ghost: bool, ground: bool) {
        if (ghost, ground) != (self.around.ghost, self.around.ground) {
            (self.around.ghost, self.around.ground) = (ghost, ground);
            self.surround();
        }
    }

    /// Removes the rest positions of the previous mesh. Until those of the new one are known, it counts
    /// as opened where it is.
    pub(crate) fn leave_surroundings(&mut self) {
        self.around.rest.clear();
        self.around.extent = extent(self.content.mesh.used_of(&self.content.mesh.exact));
        self.surround();
    }

    /// Returns the height of the ground, relative to the view's centre: slightly below the mesh, now
    /// and as it was opened, so that neither passes through it. It moves only where the lowest point of
    /// both does.
    pub fn floor(&self) -> f32 {
        let [_, _, sky] = self.viewpoint.camera.up.axes();
        let rest = self.around.extent.map(|point| self.content.mesh.relative(point));
        let lowest = rest[0].dot(sky).min(self.bounds()[0].dot(sky));
        lowest - BELOW * half_diagonal(rest)
    }

    /// Returns the grid around the mesh as it was opened, if it is shown.
    fn ground(&self) -> Ground {
        if self.around.rest.is_empty() || !self.around.ground {
            return Ground::default();
        }
        let (up, centre) = (self.viewpoint.camera.up, self.content.mesh.centre);
        let [_, _, sky] = up.axes();
        let floor = f64::from(self.floor()) + centre.dot(sky.as_dvec3());
        Ground::new(self.around.extent, floor, up, centre)
    }

    /// Lowers or lifts the grid after the mesh has moved.
    pub(crate) fn keep_ground(&mut self) {
        if self.around.ground && self.ground() != self.around.grid {
            self.surround();
        }
    }

    /// Recomputes the grid, and extends the depth range to include it.
    pub(crate) fn surround(&mut self) {
        self.around.grid = self.ground();
        self.changes.around = true;
        self.keep_reach();
        self.view_changed();
    }

    /// Returns the points of the ghost, then those of the grid, relative to the view's centre.
    pub fn surrounding_points(&self) -> impl Iterator<Item = Vec3> + '_ {
        let mesh = &self.content.mesh;
        self.ghost().iter().map(|&point| mesh.relative(point)).chain(self.grid())
    }

    /// Returns the rest positions, `#V by 3` in file coordinates, if the ghost is shown.
    fn ghost(&self) -> &[DVec3] {
        if self.around.ghost { &self.around.rest } else { &[] }
    }

    fn grid(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.around.grid.lines.iter().flatten().copied()
    }

    /// Returns the points beside the mesh that are drawn: targets and grid; ghost and layer without their
    /// stray vertices; and the corners of boxes around fitted shapes.
    fn drawn_beside(&self) -> impl Iterator<Item = Vec3> + '_ {
        let mesh = &self.content.mesh;
        let points = mesh.used_of(self.ghost()).chain(mesh.used_of(&self.layer.points));
        // Of a shallow arc or cap the circle or sphere is much larger than the model.
        let shapes = self.content.shapes.iter().filter(|_| self.look.display.shapes);
        let points = points.map(|point| mesh.relative(point));
        let points = self.targets().chain(self.grid()).chain(points);
        points.chain(shapes.flat_map(FittedShape::corners))
    }

    /// Returns the lines of ghost and grid: their ends among [`ViewState::surrounding_points`], and
    /// their [`LineKind`].
    pub fn surrounding_lines(&self) -> Vec<[u32; 3]> {
        let mut lines = Vec::new();
        let mut first = 0;
        if self.around.ghost && !self.around.rest.is_empty() {
            let kind = LineKind::Ghost as u32;
            lines.extend(self.content.mesh.edges.iter().map(|e| [e.ends[0], e.ends[1], kind]));
            let curves = self.content.mesh.curves.iter();
            lines.extend(curves.flat_map(|c| c.windows(2).map(|ends| [ends[0], ends[1], kind])));
            first = self.around.rest.len() as u32;
        }
        let grid = (0..self.around.grid.lines.len() as u32).map(|line| first + 2 * line);
        lines.extend(grid.map(|start| [start, start + 1, LineKind::Ground as u32]));
        lines
    }

    /// Selects perspective or parallel projection. Pivot, and sizes at its depth, stay the same.
    pub fn set_parallel(&mut self, parallel: bool) {
        let is_parallel = self.viewpoint.camera.projection != CameraProjection::Perspective;
        if parallel == is_parallel {
            return;
        }
        self.viewpoint.camera.projection = if parallel {
            CameraProjection::Parallel { reach: 1.5 * self.reach() }
        } else {
            CameraProjection::Perspective
        };
        self.refit();
        self.view_changed();
    }

    /// Cuts the model open with a plane across an axis of the file (0 to 2), at a fraction (0 to 1)
    /// of its extent. The side before the plane along the axis is kept, or the other one if the
    /// flag is set. `None` shows the whole model.
    ///
    /// # Errors
    /// An axis that does not exist.
    pub fn set_section(&mut self, plane: Option<(usize, f32, bool)>) -> Result<(), ViewError> {
        let bounds = self.bounds();
        self.viewpoint.camera.section = match plane {
            Some((axis, part, is_turned)) => Some(Section::across(axis, part, is_turned, bounds)?),
            None => None,
        };
        self.view_changed();
        Ok(())
    }

    /// In parallel projection, keeps the eye behind everything that is drawn.
    pub(crate) fn keep_reach(&mut self) {
        if let CameraProjection::Parallel { reach } = self.viewpoint.camera.projection {
            let needed = self.reach();
            if !(needed..=4.0 * needed).contains(&reach) {
                self.viewpoint.camera.projection =
                    CameraProjection::Parallel { reach: 1.5 * needed };
            }
        }
    }

    /// Returns the near and far depth of everything that is drawn.
    pub fn depth_range(&self) -> (f32, f32) {
        let [mut low, mut high] = self.bounds();
        // Projections lie beside their vertices, and are lifted by their displacement.
        let displacements =
            self.content.projections.points.iter().map(|point| point.displacement.length_squared());
        let beside = 2.0 * displacements.fold(0.0, f32::max).sqrt();
        (low, high) = (low - beside, high + beside);
        let corners = (0..8).map(|i| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
            Vec3::new(pick(0), pick(1), pick(2))
        });
        depth_range(&self.viewpoint.camera, corners.chain(self.drawn_beside()))
    }

    /// Returns a radius around the view's centre that contains everything drawn, with a margin.
    fn reach(&self) -> f32 {
        let all = self.content.mesh.used_positions().chain(self.drawn_beside());
        let farthest = all.map(Vec3::length_squared).fold(0.0, f32::max).sqrt();
        farthest + 0.1 * self.size()
    }
}

/// Returns the corners of the box around some points, in file coordinates; the origin without any.
fn extent(points: impl Iterator<Item = DVec3> + Clone) -> [DVec3; 2] {
    [points.clone().reduce(DVec3::min), points.reduce(DVec3::max)].map(Option::unwrap_or_default)
}
