//! The target of a constraint: a selector, which may refer to a set without a name.

use crate::constraint::{Selector, Set, Sets};

/// The target of a constraint: a selector, which may refer to a set without a name.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintTarget {
    /// The selector.
    pub on: Selector,
    /// The set that [`ConstraintTarget::UNNAMED`] stands for in the selector.
    pub set: Option<Set>,
}

impl ConstraintTarget {
    /// The placeholder for `set` in the selector.
    pub const UNNAMED: &str = "";

    /// Returns the selector with the name that its set has in `sets`. If it has none, chooses an
    /// unused name and also returns it with the set.
    pub(crate) fn named_in(self, sets: &Sets) -> (Selector, Option<(String, Set)>) {
        let ConstraintTarget { mut on, set } = self;
        let Some(set) = set else { return (on, None) };
        let known = sets.iter().find(|(_, other)| **other == set);
        let name = match known {
            Some((name, _)) => name.clone(),
            None => (1..)
                .map(|k| format!("selection {k}"))
                .find(|name| !sets.contains_key(name))
                .expect("some number is free"),
        };
        if let Selector::Each { within: Some(within), .. } = &mut on {
            within.clone_from(&name);
        }
        let is_new = known.is_none();
        (on, is_new.then_some((name, set)))
    }
}
