//! Where constraints may be: a selector, which may be about a set that has no name yet.

use crate::constraint::{Selector, Set};
use crate::scene::Scene;

/// Where constraints may be: what a selector says, which may be about a set that has no name yet.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintTarget {
    /// The selector.
    pub on: Selector,
    /// What [`ConstraintTarget::UNNAMED`] stands for in the selector.
    pub set: Option<Set>,
}

impl ConstraintTarget {
    /// The name in the selector that stands for `set`.
    pub const UNNAMED: &str = "";

    /// The selector when the set is in `document`, which gets it under a name of its own.
    pub(crate) fn name_in(self, document: &mut Scene) -> Selector {
        let ConstraintTarget { mut on, set } = self;
        if let Some(set) = set {
            let known = document.sets.iter().find(|(_, other)| **other == set);
            let name = match known {
                Some((name, _)) => name.clone(),
                None => (1..)
                    .map(|k| format!("selection {k}"))
                    .find(|name| !document.sets.contains_key(name))
                    .expect("some number is free"),
            };
            if let Selector::Each { within: Some(within), .. } = &mut on {
                within.clone_from(&name);
            }
            document.sets.insert(name, set);
        }
        on
    }
}
