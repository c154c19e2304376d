//! The list of the guide.

/// What the guide lists: the names of `bits.tsv`, a paragraph for each entry.
pub(crate) fn list() -> String {
    let mut list = String::new();
    for (entry, title) in [
        ("scalar", "**Functions**, scalar and, where there are, on lanes"),
        ("job", "**Jobs and kernels**"),
        ("trajectory", "**Trajectories**, which need a heap"),
        ("example", "**The example**"),
    ] {
        let of_entry = |line: &&str| line.starts_with(&format!("f32\t{entry}\t"));
        let lines = dq8_bits::KNOWN.lines().filter(of_entry);
        let mut names: Vec<&str> = Vec::new();
        for name in lines.filter_map(|line| line.split(['\t', ',']).nth(2)) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        list += &format!("{title}: `{}`.\n\n", names.join("`, `"));
    }
    list
}
