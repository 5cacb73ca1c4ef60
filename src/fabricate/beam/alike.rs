//! Nodes that are the same: as many beams, and every angle from one beam to the next and above the plane of the
//! node equal within a tolerance, from whichever beam one starts, and in a mirror where that is asked for.

use super::node::Node;

/// Nodes sorted into types.
#[derive(Clone, Debug, Default)]
pub struct NodeTypes {
    /// The type of each node, by vertices; none where there is no node.
    pub of_nodes: Vec<Option<u32>>,
    /// The first node of each type, which the others are compared with.
    pub leaders: Vec<u32>,
    /// How many nodes each type has.
    pub counts: Vec<u32>,
    /// The largest difference of an angle to that of the leader, in degrees.
    pub worst_deg: Vec<f64>,
}

/// Sorts nodes: in their order each joins the nearest leader within `tolerance_deg`, else becomes one.
pub fn node_types(nodes: &[Option<Node>], tolerance_deg: f64, mirror: bool) -> NodeTypes {
    let mut types = NodeTypes::default();
    let mut leaders: Vec<Angles> = Vec::new();
    for (node, v) in nodes.iter().zip(0..) {
        let Some(node) = node else {
            types.of_nodes.push(None);
            continue;
        };
        let own = Angles::of(node);
        let nearest = (0..)
            .zip(&leaders)
            .map(|(k, leader)| (own.difference(leader, mirror, tolerance_deg), k))
            .filter(|(difference, _)| *difference <= tolerance_deg)
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let kind = match nearest {
            Some((difference, k)) => {
                types.counts[k] += 1;
                types.worst_deg[k] = types.worst_deg[k].max(difference);
                k
            }
            None => {
                leaders.push(own);
                types.leaders.push(v);
                types.counts.push(1);
                types.worst_deg.push(0.0);
                leaders.len() - 1
            }
        };
        types.of_nodes.push(Some(kind as u32));
    }
    types
}

/// Of every beam its elevation and the gap to the next one.
struct Angles {
    elevations: Vec<f64>,
    gaps: Vec<f64>,
}

impl Angles {
    fn of(node: &Node) -> Angles {
        Angles {
            elevations: node.spokes.iter().map(|spoke| spoke.elevation_deg).collect(),
            gaps: node.gaps_deg().collect(),
        }
    }

    /// The least over all starts of the largest difference of an angle; something above `most` where it is above.
    fn difference(&self, other: &Angles, mirror: bool, most: f64) -> f64 {
        let n = self.gaps.len();
        if other.gaps.len() != n {
            return f64::INFINITY;
        }
        let mut least = f64::INFINITY;
        for start in 0..n {
            for mirrored in [false, true].into_iter().take(1 + usize::from(mirror)) {
                let mut worst: f64 = 0.0;
                for k in 0..n {
                    // In a mirror one goes round the other way, and meets a gap before its beam.
                    let (beam, gap) = match mirrored {
                        false => ((start + k) % n, (start + k) % n),
                        true => ((start + n - k) % n, (start + 2 * n - k - 1) % n),
                    };
                    worst = worst.max((self.elevations[k] - other.elevations[beam]).abs());
                    worst = worst.max((self.gaps[k] - other.gaps[gap]).abs());
                    if worst > least.min(most) {
                        break;
                    }
                }
                least = least.min(worst);
            }
        }
        least
    }
}
