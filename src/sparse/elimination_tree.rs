//! The elimination tree of a symmetric matrix, its postorder, and the column counts of its factor (Davis,
//! *Direct Methods for Sparse Linear Systems*, sections 4.1 to 4.5).
//!
//! The parent of a column is the row of the first entry below the diagonal in its column of `L`. A
//! column depends only on its descendants.

/// Parent of a root.
pub(crate) const NONE: u32 = u32::MAX;

/// Returns the parent of each of `n` columns in the elimination order, or [`NONE`] (Liu 1986, with
/// path compression). `row(k)` iterates over the columns with an entry in row `k` of the matrix;
/// those from `k` on are ignored.
pub(crate) fn elimination_tree<R: Iterator<Item = u32>>(
    n: usize,
    row: impl Fn(usize) -> R,
) -> Vec<u32> {
    let (mut parents, mut ancestors) = (vec![NONE; n], vec![NONE; n]);
    for k in 0..n as u32 {
        for mut i in row(k as usize) {
            while i < k {
                let next = ancestors[i as usize];
                ancestors[i as usize] = k;
                if next == NONE {
                    parents[i as usize] = k;
                    break;
                }
                i = next;
            }
        }
    }
    parents
}

/// Returns a postorder: children before parents, each subtree contiguous.
pub(crate) fn postorder(parents: &[u32]) -> Vec<u32> {
    let n = parents.len();
    let (mut first_child, mut next_sibling) = (vec![NONE; n], vec![NONE; n]);
    for v in (0..n as u32).rev() {
        let parent = parents[v as usize];
        if parent != NONE {
            next_sibling[v as usize] = first_child[parent as usize];
            first_child[parent as usize] = v;
        }
    }
    let mut order = Vec::with_capacity(n);
    let mut path = Vec::new();
    for root in (0..n as u32).filter(|&v| parents[v as usize] == NONE) {
        path.push(root);
        while let Some(&v) = path.last() {
            let child = first_child[v as usize];
            if child == NONE {
                path.pop();
                order.push(v);
            } else {
                first_child[v as usize] = next_sibling[child as usize];
                path.push(child);
            }
        }
    }
    order
}

/// Returns the number of entries of each column of `L` below its diagonal, without forming `L`
/// (Gilbert, Ng and Peyton 1994). The columns must be in a postorder of the tree; `column(c)`
/// returns the rows of the matrix below the diagonal in column `c`.
pub(crate) fn column_heights<'a>(parents: &[u32], column: impl Fn(usize) -> &'a [u32]) -> Vec<u32> {
    let n = parents.len();
    // The first descendant of each column in the postorder. Leaves start with a count of one.
    let mut first = vec![NONE; n];
    let mut counts = vec![0i64; n];
    for c in 0..n {
        counts[c] = i64::from(first[c] == NONE);
        let mut v = c as u32;
        while v != NONE && first[v as usize] == NONE {
            first[v as usize] = c as u32;
            v = parents[v as usize];
        }
    }
    let mut ancestors: Vec<u32> = (0..n as u32).collect();
    // The greatest first descendant and the last leaf so far of each row.
    let (mut greatest, mut last_leaf) = (vec![NONE; n], vec![NONE; n]);
    for c in 0..n {
        let parent = parents[c];
        if parent != NONE {
            counts[parent as usize] -= 1;
        }
        for &row in column(c) {
            let row = row as usize;
            if greatest[row] != NONE && first[c] <= greatest[row] {
                continue;
            }
            // A leaf of the subtree of this row: its path begins here and joins that of the
            // previous leaf at their least common ancestor.
            greatest[row] = first[c];
            counts[c] += 1;
            let before = std::mem::replace(&mut last_leaf[row], c as u32);
            if before != NONE {
                let mut joined = before;
                while ancestors[joined as usize] != joined {
                    joined = ancestors[joined as usize];
                }
                let mut v = before;
                while v != joined {
                    v = std::mem::replace(&mut ancestors[v as usize], joined);
                }
                counts[joined as usize] -= 1;
            }
        }
        if parent != NONE {
            ancestors[c] = parent;
        }
    }
    for c in 0..n {
        if parents[c] != NONE {
            counts[parents[c] as usize] += counts[c];
        }
    }
    // The counts include the diagonal.
    counts.into_iter().map(|count| count as u32 - 1).collect()
}
