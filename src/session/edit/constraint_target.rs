//! Where constraints may be: a selector, which may be about a set that has no name yet.

use crate::constraint::{Selector, Set, Sets};

/// Where constraints may be: what a selector says, which may be about a set that has no name yet.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintTarget {
    /// The selector.
    pub on: Selector,
    /// The set that [`ConstraintTarget::UNNAMED`] names in the selector.
    pub set: Option<Set>,
}

impl ConstraintTarget {
    /// The name in the selector that stands for `set`.
    pub const UNNAMED: &str = "";

    /// The selector by the name that its set has in `sets`, or else by a name that is free there, with the
    /// set that is to have it.
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
