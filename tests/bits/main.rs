//! Writes `tests/vectors/bits.tsv`, or, with the argument `list`, the list of the guide.

fn main() {
    let mut lines: Vec<String> = Vec::new();
    dq8_bits::hashes(&mut |name, hash| {
        let line = format!("{}\t{hash:016x}", name.join("\t"));
        if !lines.contains(&line) {
            lines.push(line);
        }
    });
    lines.iter().for_each(|line| println!("{line}"));
}
