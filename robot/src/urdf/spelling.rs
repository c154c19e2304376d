//! Names that are probably meant to be others.

/// Words near those of the format that are words of their own.
const OTHER_WORDS: [&str; 3] = ["line", "point", "power"];

/// Which of these names is probably meant: one that differs in case, in the order of its letters,
/// or in few of them (lost, added, changed, or exchanged with their neighbours): none of one or two
/// letters, one of up to five, two of more.
pub(crate) fn meant(
    found: &str,
    names: impl IntoIterator<Item = &'static str>,
) -> Option<&'static str> {
    let found = found.to_ascii_lowercase();
    let letters: Vec<char> = found.chars().collect();
    let own_word = OTHER_WORDS.contains(&found.as_str());
    names.into_iter().find(|name| *name == found || !own_word && near(&letters, name))
}

fn near(found: &[char], name: &str) -> bool {
    let name: Vec<char> = name.chars().collect();
    let allowed = match name.len() {
        ..=2 => 0,
        3..=5 => 1,
        _ => 2,
    };
    let sorted = |letters: &[char]| {
        let mut letters = letters.to_vec();
        letters.sort_unstable();
        letters
    };
    found.len().abs_diff(name.len()) <= allowed
        && (distance(found, &name) <= allowed || sorted(found) == sorted(&name))
}

/// How many letters must be added, removed, changed or exchanged with the next one (optimal string
/// alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    // Row i: the distances of the first i letters of `a` from all beginnings of `b`.
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = changed.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    fn meant(found: &str) -> Option<&'static str> {
        let names = "lower upper origin axis limit mimic multiplier xyz rpy x link";
        super::meant(found, names.split(' '))
    }

    #[test]
    fn other_words_are_not() {
        let all = "power effort velocity damping friction stiffness dont_collapse type line xx lower_limit_switch \
                   orientation dynamics physics joint_properties unit";
        for found in all.split_whitespace().chain([""]) {
            assert_eq!(meant(found), None, "{found}");
        }
    }
}
