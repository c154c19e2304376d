//! Writes what is generated: `bounds.toml`, and scripts for Gappa and Coq.

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["bounds"] => print!("{}", dq8_proofs::table::text()),
        ["gappa", folder] => dq8_proofs::gappa::write(folder).expect("a folder to write to"),
        ["coq", folder] => dq8_proofs::coq::write(folder.as_ref()).expect("a folder to write to"),
        _ => {
            eprintln!("usage: dq8-proofs bounds | gappa FOLDER | coq FOLDER");
            std::process::exit(2);
        }
    }
}
