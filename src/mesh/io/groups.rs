//! The named, overlapping groups of an OBJ file, and the solids of STL.

use crate::words;
use std::collections::{BTreeMap, BTreeSet};

use crate::math::{argsort, key_of_pair};
use crate::mesh::{ElementKind, Group, GroupKeyword};

/// Maximum number of names kept of one `g` statement. Without a limit, memory could grow with the
/// square of the file size.
const MOST_NAMES: usize = 32;

#[derive(Default)]
pub(crate) struct Groups {
    groups: Vec<Group>,
    by_name: BTreeMap<(GroupKeyword, String), usize>,
    /// For each keyword, the indices in `groups` of the open groups, to which elements are added.
    open: [Vec<usize>; GroupKeyword::STATEMENTS.len()],
    /// Names of objects and groups that were opened again after others.
    reopened: BTreeSet<String>,
}

impl Groups {
    /// Reads the statement of `keyword` in the line `text`. A known name reopens its group; a
    /// statement without a name closes the open groups. Returns whether there are more names than
    /// the limit.
    pub(crate) fn open(&mut self, keyword: GroupKeyword, text: &str) -> bool {
        let open = &mut self.open[keyword as usize];
        let before = std::mem::take(open);
        // A `#` may begin a name: these statements have no comments.
        let mut words = text.split_ascii_whitespace().skip(1);
        let names: Vec<String> = match keyword {
            GroupKeyword::Group => words.by_ref().take(MOST_NAMES).map(str::to_owned).collect(),
            _ => Some(words.by_ref().collect::<Vec<_>>().join(" ")).into_iter().collect(),
        };
        for name in names.into_iter().filter(|name| !name.is_empty()) {
            let new = self.groups.len();
            let group = *self.by_name.entry((keyword, name)).or_insert_with_key(|(_, name)| {
                let name = name.clone();
                self.groups.push(Group { name, keyword, faces: Vec::new(), curves: Vec::new() });
                new
            });
            let is_new = group == new;
            if !is_new && !before.contains(&group) && keyword != GroupKeyword::Material {
                self.reopened.insert(self.groups[group].name.clone());
            }
            if !open.contains(&group) {
                open.push(group);
            }
        }
        words.next().is_some()
    }

    /// Says which names were opened again after others, and are one group each.
    pub(crate) fn note(&self) -> Option<String> {
        const MOST: usize = 3;
        let names: Vec<String> = self.reopened.iter().cloned().collect();
        let several = words::count(names.len(), "name stands", "names stand");
        let some = words::and_more(&names, MOST);
        (!names.is_empty()).then(|| {
            format!(
                "{several} for several groups of the file, which are one group each here: {some}"
            )
        })
    }

    pub(crate) fn add(&mut self, element: ElementKind, index: u32) {
        for &group in self.open.iter().flatten() {
            match element {
                ElementKind::Face => self.groups[group].faces.push(index),
                ElementKind::Curve => self.groups[group].curves.push(index),
                ElementKind::Tetrahedron => unreachable!("OBJ has no tetrahedra"),
            }
        }
    }

    /// Returns the non-empty groups by their first face, else their first curve, so that reading a
    /// file written from them gives the same order.
    pub(crate) fn finish(self) -> Vec<Group> {
        let mut groups = self.groups;
        groups.retain(|group| !(group.faces.is_empty() && group.curves.is_empty()));
        let first = |members: &[u32]| members.first().copied().unwrap_or(u32::MAX);
        let by_keyword = argsort(groups.iter().map(|group| group.keyword as u64));
        let key = |group: &Group| key_of_pair([first(&group.faces), first(&group.curves)]);
        let order = argsort(by_keyword.iter().map(|&group| key(&groups[group as usize])));
        let places = order.into_iter().map(|i| by_keyword[i as usize] as usize);
        let mut groups: Vec<Option<Group>> = groups.into_iter().map(Some).collect();
        places.map(|place| groups[place].take().expect("an order has every place once")).collect()
    }
}
