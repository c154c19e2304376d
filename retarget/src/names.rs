//! Names of links and joints, compared without regard to how programs write them.

/// Returns the letters and digits of a name in lower case, without the word `link`, and without the
/// name of the biped that 3ds Max writes before each joint (`Bip01 L UpperArm`).
pub(crate) fn plain(name: &str) -> String {
    let plain: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    let plain = plain.to_lowercase();
    let biped =
        plain.strip_prefix("bip").map(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
    let plain =
        biped.filter(|rest| rest.len() + 3 < plain.len() && !rest.is_empty()).unwrap_or(&plain);
    plain.strip_suffix("link").unwrap_or(plain).to_owned()
}

/// Returns the index of the first common name among `names`, which are [`plain`]. Names with a
/// prefix, such as `mixamorig:LeftArm`, are found by their ends.
pub(crate) fn find(names: &[String], side: Option<&str>, common: &[&str]) -> Option<usize> {
    common.iter().find_map(|common| {
        let forms = match side {
            None => vec![(*common).to_owned()],
            Some(side) => vec![
                format!("{side}{common}"),
                format!("{}{common}", &side[..1]),
                format!("{common}{side}"),
                format!("{common}{}", &side[..1]),
            ],
        };
        let is = |form: &String| names.iter().position(|name| name == form);
        let ends = |form: &String| names.iter().position(|name| name.ends_with(form.as_str()));
        forms.iter().find_map(is).or_else(|| forms.first().and_then(ends))
    })
}
