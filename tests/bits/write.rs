//! Writes `tests/vectors/bits.tsv`, or, with the argument `list`, what the guide lists.

mod list;

fn main() {
    if std::env::args().nth(1).is_some_and(|argument| argument == "list") {
        print!("{}", list::list());
        return;
    }
    let mut lines: Vec<String> = Vec::new();
    dq8_bits::hashes(&mut |name, hash| {
        let line = format!("{}\t{hash:016x}", name.join("\t"));
        if !lines.contains(&line) {
            lines.push(line);
        }
    });
    lines.iter().for_each(|line| println!("{line}"));
}
