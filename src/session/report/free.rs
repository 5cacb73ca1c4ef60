//! Vertices that nothing acts on: they stay where they are, whatever the rest does.

use crate::scene::ClosenessTo;
use crate::session::state::Session;

impl Session {
    /// The vertices on which neither a constraint nor closeness, smoothness, or a handle acts, ascending.
    pub fn free(&self) -> Vec<u32> {
        let count = self.mesh.positions.len();
        let mut acted_on = vec![false; count];
        let mut act_on = |vertices: &[u32]| {
            vertices.iter().for_each(|&vertex| acted_on[vertex as usize] = true);
        };
        let weights = self.document.weights;
        let acting =
            |row: &&crate::session::ResolvedRow| row.enabled && row.constraints.weight > 0.0;
        for row in self.rows.iter().filter(acting).filter(|_| weights.shape > 0.0) {
            act_on(row.constraints.members.indices());
        }
        self.solver.handles().iter().for_each(|handle| act_on(&[handle.vertex]));
        if weights.smooth > 0.0 {
            act_on(self.topology.edges().as_flattened());
        }
        let closeness = &self.document.closeness;
        if weights.close > 0.0 {
            let factors = closeness.factors(&self.mesh, &self.topology, &self.document.sets);
            let factors = factors.expect("the document was resolved when it was taken over");
            let mut hold = |vertex: u32| {
                acted_on[vertex as usize] |= factors[vertex as usize] > 0.0;
            };
            if closeness.to != ClosenessTo::None {
                (0..count as u32).for_each(&mut hold);
            } else if closeness.boundary.is_some() {
                let loops = self.topology.boundary_loops();
                loops.indices().iter().copied().for_each(&mut hold);
            }
        }
        (0..).zip(acted_on).filter(|(_, acted_on)| !acted_on).map(|(vertex, _)| vertex).collect()
    }
}
