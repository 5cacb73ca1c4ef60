//! Checks of a scene beyond its form: ranges of numbers, and indices and names against the mesh.

use super::{
    ClosenessTo, ConstraintSpec, HandleSpec, Hold, NamedEnum, Scene, SceneError, Slide, Target,
    Variant, Variants, Weighting,
};
use crate::constraint::{Element, Selector};
use crate::json::push_key;
use crate::math::argsort;
use crate::mesh::{LARGEST_COORDINATE, Laplacian, Mesh, first_out_of_range};
use crate::solve::Require;
use std::collections::BTreeSet;

/// Maximum number of steps that accelerators store, each as large as the mesh.
const MOST_WINDOW: u32 = 50;

impl Scene {
    /// Checks the scene against `mesh`, the mesh that [`Scene::mesh`] refers to.
    ///
    /// # Errors
    /// The first error: its JSON path, the fault and what was expected.
    pub fn validate(&self, mesh: &Mesh) -> Result<(), SceneError> {
        self.check_numbers()?;
        let vertices = mesh.positions.len();
        self.check_extent(mesh)?;
        if let Some(current) = &self.current
            && current.len() != vertices
        {
            let found = current.len();
            return error(
                "current",
                format!(
                    "found {found} positions, expected one for each of the {vertices} vertices"
                ),
            );
        }
        self.check_variants(vertices)?;
        self.check_steps()?;
        self.check_sets(mesh)?;
        self.check_selectors(mesh)?;
        self.check_handles(vertices)?;
        self.check_weighting(mesh)?;
        self.check_pose(vertices)?;
        self.check_target()?;
        self.check_build(mesh)
    }

    /// Checks that the edges among the settings of Build are edges of the mesh.
    pub(crate) fn check_build(&self, mesh: &Mesh) -> Result<(), SceneError> {
        let Some(build) = &self.build else { return Ok(()) };
        build.check_edges(mesh).or_else(|(key, message)| error(&format!("build.{key}"), message))
    }

    fn check_variants(&self, vertices: usize) -> Result<(), SceneError> {
        let Variants { kept, design } = &self.variants;
        let count = kept.len();
        if count > Variants::MOST {
            let most = Variants::MOST;
            return error("variants.kept", format!("found {count}, expected {most} at most"));
        }
        for (i, Variant { positions, .. }) in kept.iter().enumerate() {
            let found = positions.len();
            let path = format!("variants.kept[{i}].positions");
            if found != vertices {
                return error(
                    &path,
                    format!(
                        "found {found} positions, expected one for each of the {vertices} vertices"
                    ),
                );
            }
            if let Some(vertex) = first_out_of_range(positions) {
                return error(&format!("{path}[{vertex}]"), out_of_range("the position"));
            }
        }
        match design.filter(|index| *index >= count) {
            Some(index) => error(
                "variants.design",
                format!("found {index}, expected the index of one of the {count} kept variants"),
            ),
            None => Ok(()),
        }
    }

    /// Checks that the steps of the presentation refer to existing variants and have valid weights.
    pub(crate) fn check_steps(&self) -> Result<(), SceneError> {
        let (count, kept) = (self.steps.len(), self.variants.kept.len());
        if count > Slide::MOST {
            return error("steps", format!("found {count}, expected {} at most", Slide::MOST));
        }
        for (i, Slide { original, variant, weights, .. }) in self.steps.iter().enumerate() {
            let path = format!("steps[{i}].variant");
            match variant {
                Some(index) if *index >= kept => {
                    let expected = format!("the index of one of the {kept} kept variants");
                    return error(&path, format!("found {index}, expected {expected}"));
                }
                Some(_) if *original => {
                    return error(
                        &path,
                        "the step already has \"original\", expected only one of them",
                    );
                }
                _ => {}
            }
            for (key, weight) in weights
                .iter()
                .flat_map(|w| [("shape", w.shape), ("close", w.close), ("smooth", w.smooth)])
            {
                from_zero(&format!("steps[{i}].weights.{key}"), weight)?;
            }
        }
        Ok(())
    }

    fn check_pose(&self, vertices: usize) -> Result<(), SceneError> {
        let Some(pose) = &self.pose else { return Ok(()) };
        let Some(positions) = pose.positions() else {
            return error("pose.file", "the file was not read, expected positions in the scene");
        };
        if positions.len() != vertices {
            let found = positions.len();
            return error(
                "pose.positions",
                format!("found {found}, expected one for each of the {vertices} vertices"),
            );
        }
        match first_out_of_range(positions) {
            Some(vertex) => {
                error(&format!("pose.positions[{vertex}]"), out_of_range("the position"))
            }
            None => Ok(()),
        }
    }

    fn check_target(&self) -> Result<(), SceneError> {
        let at_mesh = |message: String| error("closeness.to.mesh", message);
        match (self.closeness.to, &self.closeness.target) {
            (ClosenessTo::Target, None) => error(
                "closeness.to",
                "there is no other surface yet: first read one (Fit to another surface)",
            ),
            (ClosenessTo::Target, Some(Target::File(path))) => at_mesh(format!(
                "the mesh file {path} was not read, expected the mesh itself in the scene"
            )),
            (ClosenessTo::Target, Some(Target::Mesh(mesh))) => {
                if mesh.faces.is_empty() && mesh.curves.is_empty() {
                    return at_mesh("it has neither faces nor curves to be close to".to_owned());
                }
                if let Some(vertex) = first_out_of_range(&mesh.positions) {
                    let path = format!("closeness.to.mesh.positions[{vertex}]");
                    return error(&path, out_of_range("the position"));
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Checks that every number but coordinates is finite and in its range; needs no mesh.
    pub(super) fn check_numbers(&self) -> Result<(), SceneError> {
        for (i, spec) in self.constraints.iter().enumerate() {
            from_zero(&format!("constraints[{i}].weight"), spec.weight)?;
            let within = match spec.require {
                Require::Within(length) => Some(("require", length)),
                Require::Soft | Require::Exact => None,
            };
            let eased = spec.eased.as_ref().map(|eased| ("eased", eased.within));
            for (key, length) in within.into_iter().chain(eased) {
                if !(length > 0.0 && length.is_finite()) {
                    let path = format!("constraints[{i}].{key}.within");
                    return error(&path, format!("found {length}, expected a length above 0"));
                }
            }
        }
        let smoother = self.attempt.smoother;
        if !(smoother > 0.0 && smoother.is_finite()) {
            return error(
                "attempt.smoother",
                format!("found {smoother}, expected a number above 0"),
            );
        }
        for (i, handle) in self.handles.iter().enumerate() {
            check_handle_numbers(i, handle)?;
        }
        for (i, entry) in self.closeness.weights.iter().enumerate() {
            from_zero(&format!("closeness.weights[{i}].weight"), entry.weight)?;
        }
        let boundary = self.closeness.boundary;
        if !(0.0..=180.0).contains(&boundary.corners) {
            return error(
                "closeness.boundary.corners",
                format!("found {}, expected an angle in degrees from 0 to 180", boundary.corners),
            );
        }
        from_zero("closeness.boundary.weight", boundary.weight)?;
        check_tolerance(self.tolerance)?;
        from_zero("weights.shape", self.weights.shape)?;
        from_zero("weights.close", self.weights.close)?;
        from_zero("weights.smooth", self.weights.smooth)?;
        from_zero("solver.tolerance", self.solver.tolerance)?;
        if let Some(ratio) = self.solver.shortest_edge
            && !(0.0..=1.0).contains(&ratio)
        {
            let message = format!("found {ratio}, expected a number from 0 to 1, or null");
            return error("solver.shortest_edge", message);
        }
        if let Some(build) = &self.build {
            build.check().or_else(|(key, message)| error(&format!("build.{key}"), message))?;
        }
        if self.solver.window > MOST_WINDOW {
            let found = self.solver.window;
            let message = format!("found {found}, expected a whole number from 0 to {MOST_WINDOW}");
            return error("solver.window", message);
        }
        Ok(())
    }

    fn check_extent(&self, mesh: &Mesh) -> Result<(), SceneError> {
        if let Some(vertex) = first_out_of_range(&mesh.positions) {
            return error("mesh", out_of_range(&format!("vertex {vertex}")));
        }
        if let Some(i) = self.current.as_deref().and_then(first_out_of_range) {
            return error(&format!("current[{i}]"), out_of_range("the position"));
        }
        for (i, handle) in self.handles.iter().enumerate() {
            if let Some(k) = handle.targets.as_deref().and_then(first_out_of_range) {
                let path = format!("handles[{i}].targets[{k}]");
                return error(&path, out_of_range("the target"));
            }
        }
        Ok(())
    }

    /// Checks that the weighting of the Laplacian is defined on the faces.
    fn check_weighting(&self, mesh: &Mesh) -> Result<(), SceneError> {
        const MOST: usize = Laplacian::MOST_CORNERS;
        let (fits, needed, others): (fn(usize) -> bool, _, _) = match self.smoothness.weighting {
            Weighting::Auto | Weighting::Uniform => return Ok(()),
            Weighting::Cotangent => {
                (|corners| corners == 3, "a triangle mesh".to_owned(), "\"polygon\", ")
            }
            Weighting::Polygon => {
                (|corners| corners <= MOST, format!("faces of at most {MOST} corners"), "")
            }
        };
        let weighting = self.smoothness.weighting;
        let reason = match mesh.faces.iter().position(|face| !fits(face.len())) {
            Some(face) => format!("face {face} has {} corners", mesh.faces.row(face).len()),
            None if weighting == Weighting::Cotangent && !Laplacian::has_cotangents(mesh) => {
                "the mesh has no faces".to_owned()
            }
            None => return Ok(()),
        };
        let weighting = weighting.word();
        error(
            "smoothness.weighting",
            format!(
                "{weighting} weights need {needed}, but {reason}, expected {others}\"auto\" or \"uniform\""
            ),
        )
    }

    /// Checks the indices of named sets.
    ///
    /// # Errors
    /// As [`Scene::validate`].
    pub(crate) fn check_sets(&self, mesh: &Mesh) -> Result<(), SceneError> {
        for (name, set) in &self.sets {
            let mut path = "sets".to_owned();
            push_key(&mut path, name);
            check_indices(
                &format!("{path}.vertices"),
                "vertex",
                &set.vertices,
                mesh.positions.len(),
            )?;
            check_indices(&format!("{path}.faces"), "face", &set.faces, mesh.faces.len())?;
        }
        Ok(())
    }

    fn check_selectors(&self, mesh: &Mesh) -> Result<(), SceneError> {
        let groups = mesh.groups.iter().map(|group| group.name.as_str());
        let mut names: BTreeSet<&str> = BTreeSet::new();
        names.extend(self.sets.keys().map(String::as_str).chain(groups));
        for (i, spec) in self.constraints.iter().enumerate() {
            check_selector(&format!("constraints[{i}].on"), &spec.on, &names, mesh)?;
            check_eased(&format!("constraints[{i}].eased"), spec, mesh)?;
        }
        for (i, entry) in self.closeness.weights.iter().enumerate() {
            check_selector(&format!("closeness.weights[{i}].on"), &entry.on, &names, mesh)?;
        }
        Ok(())
    }

    fn check_handles(&self, vertices: usize) -> Result<(), SceneError> {
        /// Marks a vertex without a handle.
        const FREE: u32 = u32::MAX;
        let mut held = vec![FREE; vertices];
        for (i, handle) in self.handles.iter().enumerate() {
            check_indices(&format!("handles[{i}].vertices"), "vertex", &handle.vertices, vertices)?;
            for (k, &vertex) in handle.vertices.iter().enumerate() {
                let earlier = std::mem::replace(&mut held[vertex as usize], i as u32);
                if earlier != FREE {
                    return error(
                        &format!("handles[{i}].vertices[{k}]"),
                        format!(
                            "vertex {vertex} is in handles[{earlier}] already, expected each vertex in one handle at most"
                        ),
                    );
                }
            }
        }
        Ok(())
    }
}

fn out_of_range(what: &str) -> String {
    const MOST: f64 = LARGEST_COORDINATE;
    format!("{what} is too far out, expected coordinates from -{MOST:e} to {MOST:e}")
}

/// Checks the eased faces, which are allowed only on constraints on faces with a tolerance.
fn check_eased(path: &str, spec: &ConstraintSpec, mesh: &Mesh) -> Result<(), SceneError> {
    let Some(eased) = &spec.eased else { return Ok(()) };
    let on_faces = matches!(spec.on, Selector::Each { element: Element::Face, radius: 0, .. });
    if !on_faces || !matches!(spec.require, Require::Within(_)) {
        return error(path, "expected it only on faces with \"require\": { \"within\": LENGTH }");
    }
    check_indices(&format!("{path}.faces"), "face", &eased.faces, mesh.faces.len())
}

/// Checks the names and indices of a selector; `names` are the names of sets and groups.
fn check_selector(
    path: &str,
    on: &Selector,
    names: &BTreeSet<&str>,
    mesh: &Mesh,
) -> Result<(), SceneError> {
    let (key, name) = match on {
        Selector::Set(name) => ("set", name),
        Selector::Each { within: Some(name), .. } => ("in", name),
        Selector::Each { within: None, .. } => return Ok(()),
        Selector::Vertices(vertices) => {
            let path = format!("{path}.vertices");
            return check_indices(&path, "vertex", vertices, mesh.positions.len());
        }
    };
    if names.contains(name.as_str()) {
        return Ok(());
    }
    let known: Vec<_> = names.iter().copied().collect();
    let known = match known.as_slice() {
        [] => "there are none".to_owned(),
        known => format!("there are: {}", known.join(", ")),
    };
    error(
        &format!("{path}.{key}"),
        format!("found {name:?}, expected the name of a set or of a group of the mesh; {known}"),
    )
}

pub(super) fn check_handle_numbers(i: usize, handle: &HandleSpec) -> Result<(), SceneError> {
    if let Hold::Soft { weight } = handle.hold
        && !(weight.is_finite() && weight > 0.0)
    {
        return error(
            &format!("handles[{i}].weight"),
            format!("found {weight}, expected a number above 0"),
        );
    }
    let expected = handle.vertices.len();
    match handle.targets.as_ref().map(Vec::len).filter(|found| *found != expected) {
        Some(found) => error(
            &format!("handles[{i}].targets"),
            format!("found {found} targets, expected one for each of the {expected} vertices"),
        ),
        None => Ok(()),
    }
}

/// Checks that every index is below `count`, and that none is listed twice.
fn check_indices(path: &str, what: &str, indices: &[u32], count: usize) -> Result<(), SceneError> {
    if let Some(k) = indices.iter().position(|&index| index as usize >= count) {
        let index = indices[k];
        return error(
            &format!("{path}[{k}]"),
            format!(
                "there is no {what} {index}, expected an index below {count}: the mesh has {count}, counted from 0"
            ),
        );
    }
    let order = argsort(indices.iter().map(|&index| u64::from(index)));
    let twice =
        order.windows(2).filter(|pair| indices[pair[0] as usize] == indices[pair[1] as usize]);
    match twice.map(|pair| pair[1]).min() {
        None => Ok(()),
        Some(k) => error(
            &format!("{path}[{k}]"),
            format!("{what} {} is listed twice, expected it once", indices[k as usize]),
        ),
    }
}

/// Checks the tolerance of panels.
pub(crate) fn check_tolerance(tolerance: Option<f64>) -> Result<(), SceneError> {
    match tolerance {
        Some(length) if !(length.is_finite() && length > 0.0) => {
            error("tolerance", format!("found {length}, expected a length above 0"))
        }
        _ => Ok(()),
    }
}

fn from_zero(path: &str, value: f64) -> Result<(), SceneError> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => error(path, format!("found {value}, expected a number from 0")),
    }
}

fn error(path: &str, message: impl Into<String>) -> Result<(), SceneError> {
    Err(SceneError { path: path.to_owned(), message: message.into() })
}
