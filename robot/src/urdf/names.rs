//! Names, and the index of each. A hash map would answer as quickly, but is several kilobytes of
//! code, which web pages wait for.

/// The indices of names, in the order of the names.
#[derive(Clone)]
pub(super) struct Names(Vec<usize>);

impl Names {
    pub(super) fn new<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        let names: Vec<_> = names.collect();
        let mut order: Vec<_> = (0..names.len()).collect();
        order.sort_unstable_by_key(|&index| (names[index], index));
        Self(order)
    }

    /// Returns the index of the first name that equals an earlier one, and the index of that
    /// earlier one. `name_of` has the names of which the order was made.
    pub(super) fn twice<'n>(&self, name_of: impl Fn(usize) -> &'n str) -> Option<[usize; 2]> {
        let pairs = self.0.windows(2).map(|pair| [pair[1], pair[0]]);
        pairs.filter(|&[second, first]| name_of(second) == name_of(first)).min()
    }

    pub(super) fn find<'n>(
        &self,
        wanted: &str,
        name_of: impl Fn(usize) -> &'n str,
    ) -> Option<usize> {
        let at = self.0.binary_search_by(|&index| name_of(index).cmp(wanted));
        at.ok().map(|at| self.0[at])
    }

    /// Inserts a name, with the next index.
    pub(super) fn push<'n>(&mut self, name: &str, name_of: impl Fn(usize) -> &'n str) {
        let at = self.0.partition_point(|&index| name_of(index) < name);
        self.0.insert(at, self.0.len());
    }
}
