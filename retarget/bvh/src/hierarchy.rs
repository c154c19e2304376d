//! The part between `HIERARCHY` and `MOTION`: the tree of joints.

use std::collections::{HashMap, HashSet};

use crate::clip::{Axis, Channel, Joint};
use crate::error::{BvhError, Short};
use crate::source::{Source, Word};

/// The longest name of a joint in bytes.
const LONGEST_NAME: usize = 1024;

/// Reads the tree and the word `MOTION` behind it. Joints come in file order, so parents before
/// their children.
pub(crate) fn read(source: &mut Source<'_>) -> Result<Vec<Joint>, BvhError> {
    let Some(first) = source.next_word() else {
        return Err(BvhError::new(1, "the file is empty"));
    };
    if !first.is("HIERARCHY") {
        return Err(BvhError::expected("HIERARCHY", first));
    }
    let mut tree = Tree::default();
    loop {
        let Some(word) = source.next_word() else {
            return Err(tree.ends_early(source.line()));
        };
        if word.is("MOTION") {
            break;
        }
        tree.read_entry(word, source)?;
    }
    if let Some(open) = tree.open.last() {
        return Err(open.unclosed(&tree.joints, source.line()));
    }
    let line = source.line();
    if tree.joints.is_empty() {
        return Err(BvhError::new(line, "no ROOT before MOTION"));
    }
    if tree.joints.iter().all(|joint| joint.channels.is_empty()) {
        return Err(BvhError::new(line, "no joint has a channel, so nothing can move"));
    }
    name_end_sites(&mut tree.joints);
    Ok(tree.joints)
}

/// The tree as far as it has been read. The open braces are a list rather than calls within calls:
/// a file may nest deeper than the stack of this program.
#[derive(Default)]
struct Tree {
    joints: Vec<Joint>,
    /// Line of each joint by its name.
    lines: HashMap<String, usize>,
    open: Vec<Open>,
}

/// A joint whose brace is not closed yet.
struct Open {
    joint: usize,
    line: usize,
    has_offset: bool,
    has_channels: bool,
}

impl Open {
    fn unclosed(&self, joints: &[Joint], line: usize) -> BvhError {
        let (joint, opened) = (Short(&joints[self.joint].name), self.line);
        let reason = format!("`{joint}` is not closed: no `}}` for the `{{` of line {opened}");
        BvhError::new(line, reason)
    }
}

impl Tree {
    fn read_entry(&mut self, word: Word<'_>, source: &mut Source<'_>) -> Result<(), BvhError> {
        let Some(open) = self.open.last_mut() else {
            if word.is("ROOT") {
                return self.open_joint("ROOT", word.line, source);
            }
            return Err(BvhError::expected("ROOT or MOTION", word));
        };
        let joint = &mut self.joints[open.joint];
        if word.is("OFFSET") {
            if std::mem::replace(&mut open.has_offset, true) {
                return Err(has(word, joint, "a second OFFSET"));
            }
            joint.offset = read_offset(&joint.name, source)?;
            return Ok(());
        }
        if word.is("CHANNELS") {
            if std::mem::replace(&mut open.has_channels, true) && !joint.end_site {
                return Err(has(word, joint, "a second CHANNELS"));
            }
            joint.channels = read_channels(&joint.name, source)?;
            if joint.end_site && !joint.channels.is_empty() {
                return Err(BvhError::new(word.line, "an end site has no channels"));
            }
            return Ok(());
        }
        // What follows ends the joint's own description: its values come before those of its
        // children.
        let child = word.is("JOINT") || word.is("End");
        if !word.is("}") && (!child || joint.end_site) {
            let what = if joint.end_site {
                "OFFSET or `}`"
            } else {
                "OFFSET, CHANNELS, JOINT, End Site or `}`"
            };
            return Err(BvhError::expected(what, word));
        }
        let needs = [(open.has_offset, "no OFFSET"), (open.has_channels, "no CHANNELS")];
        if let Some((_, missing)) = needs.into_iter().find(|(is_there, _)| !is_there) {
            return Err(has(word, joint, missing));
        }
        if word.is("}") {
            self.open.pop();
            return Ok(());
        }
        if word.is("JOINT") {
            return self.open_joint("JOINT", word.line, source);
        }
        self.open_end_site(source)
    }

    fn open_joint(
        &mut self,
        what: &'static str,
        line: usize,
        source: &mut Source<'_>,
    ) -> Result<(), BvhError> {
        let name = source.next_name();
        if name.is_empty() {
            return Err(BvhError::new(line, format!("{what} without a name")));
        }
        // Each end site has the name of its parent once more.
        if name.len() > LONGEST_NAME {
            let reason = format!("the name `{}` has more than {LONGEST_NAME} bytes", Short(&name));
            return Err(BvhError::new(line, reason));
        }
        if let Some(first) = self.lines.insert(name.clone(), line) {
            let name = Short(&name);
            let reason = format!("a second joint named `{name}`, the first is on line {first}");
            return Err(BvhError::new(line, reason));
        }
        self.open_brace(name, false, source)
    }

    fn open_end_site(&mut self, source: &mut Source<'_>) -> Result<(), BvhError> {
        let word = next(source, "Site")?;
        if !word.is("Site") {
            return Err(BvhError::expected("Site", word));
        }
        // Its name comes later, when those of all joints are known.
        self.open_brace("End Site".into(), true, source)
    }

    fn open_brace(
        &mut self,
        name: String,
        end_site: bool,
        source: &mut Source<'_>,
    ) -> Result<(), BvhError> {
        let brace = next(source, "`{`")?;
        if !brace.is("{") {
            return Err(BvhError::expected("`{`", brace));
        }
        let parent = self.open.last().map(|open| open.joint);
        let joint = self.joints.len();
        self.open.push(Open { joint, line: brace.line, has_offset: false, has_channels: end_site });
        self.joints.push(Joint { end_site, ..Joint::new(name, parent, [0.0; 3], Vec::new()) });
        Ok(())
    }

    fn ends_early(&self, line: usize) -> BvhError {
        match self.open.last() {
            Some(open) => open.unclosed(&self.joints, line),
            None if self.joints.is_empty() => BvhError::ends(line, "ROOT"),
            None => BvhError::ends(line, "MOTION"),
        }
    }
}

fn has(word: Word<'_>, joint: &Joint, what: &str) -> BvhError {
    BvhError::new(word.line, format!("`{}` has {what}", Short(&joint.name)))
}

fn next<'a>(source: &mut Source<'a>, what: &str) -> Result<Word<'a>, BvhError> {
    let line = source.line();
    source.next_word().ok_or_else(|| BvhError::ends(line, what))
}

fn read_offset(joint: &str, source: &mut Source<'_>) -> Result<[f64; 3], BvhError> {
    let mut offset = [0.0; 3];
    for component in &mut offset {
        let word = next(source, "three numbers of an OFFSET")?;
        *component = word.number().ok_or_else(|| {
            let (joint, found) = (Short(joint), Short(word.text));
            let reason = format!("`{found}` is not a finite number (OFFSET of `{joint}`)");
            BvhError::new(word.line, reason)
        })?;
    }
    Ok(offset)
}

fn read_channels(joint: &str, source: &mut Source<'_>) -> Result<Vec<Channel>, BvhError> {
    let count = next(source, "the number of CHANNELS")?;
    let Ok(announced) = count.text.parse::<usize>() else {
        return Err(BvhError::expected("the number of channels", count));
    };
    let mut channels = Vec::new();
    // Everything up to the next keyword is meant as a channel, so that a wrong number is told from
    // a wrong name.
    while let Some(word) = source.peek_word().filter(|word| !is_keyword(*word)) {
        source.next_word();
        let (joint, found) = (Short(joint), Short(word.text));
        let Some(channel) = channel(word) else {
            let reason = format!("`{found}` is no channel (in `{joint}`)");
            return Err(BvhError::new(word.line, reason));
        };
        if matches!(channel, Channel::Position(_)) && channels.contains(&channel) {
            return Err(BvhError::new(word.line, format!("`{joint}` lists {found} twice")));
        }
        channels.push(channel);
    }
    if channels.len() != announced {
        let (joint, found) = (Short(joint), channels.len());
        let reason = format!("`{joint}` announces {announced} channels and lists {found}");
        return Err(BvhError::new(count.line, reason));
    }
    Ok(channels)
}

fn is_keyword(word: Word<'_>) -> bool {
    let keywords = ["{", "}", "ROOT", "JOINT", "End", "OFFSET", "CHANNELS", "MOTION"];
    keywords.iter().any(|keyword| word.is(keyword))
}

fn channel(word: Word<'_>) -> Option<Channel> {
    let channels = [
        ("Xposition", Channel::Position(Axis::X)),
        ("Yposition", Channel::Position(Axis::Y)),
        ("Zposition", Channel::Position(Axis::Z)),
        ("Xrotation", Channel::Rotation(Axis::X)),
        ("Yrotation", Channel::Rotation(Axis::Y)),
        ("Zrotation", Channel::Rotation(Axis::Z)),
    ];
    channels.iter().find(|(name, _)| word.is(name)).map(|&(_, channel)| channel)
}

/// `<Parent>_End`, or `<Parent>_End2` and so on where that name is taken: by another end site of
/// this joint, or by a joint whose own name ends like that.
fn name_end_sites(joints: &mut [Joint]) {
    let mut taken: HashSet<String> = joints.iter().map(|joint| joint.name.clone()).collect();
    let mut next_number = vec![1_usize; joints.len()];
    for index in 0..joints.len() {
        let Some(parent) = joints[index].parent.filter(|_| joints[index].end_site) else {
            continue;
        };
        loop {
            let number = next_number[parent];
            next_number[parent] += 1;
            let suffix = if number == 1 { String::new() } else { number.to_string() };
            let name = format!("{}_End{suffix}", joints[parent].name);
            if taken.insert(name.clone()) {
                joints[index].name = name;
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::clip::{Axis, Channel};
    use crate::source::Source;

    #[test]
    fn several_roots_and_any_channel_order() {
        let text = "HIERARCHY ROOT a {OFFSET 0 0 0\n\
            CHANNELS 4 Xrotation Zposition Zrotation Xrotation}\n\
            ROOT b {CHANNELS 0 OFFSET 1 2 -3. JOINT c {OFFSET .5 +1 1e1\n\
            CHANNELS 1 yROTATION}} MOTION";
        let joints = read(&mut Source::new(text)).unwrap();
        let parents: Vec<_> = joints.iter().map(|joint| joint.parent).collect();
        assert_eq!(parents, [None, None, Some(1)]);
        let (x, z) = (Channel::Rotation(Axis::X), Channel::Rotation(Axis::Z));
        assert_eq!(joints[0].channels, [x, Channel::Position(Axis::Z), z, x]);
        assert_eq!((joints[1].offset, joints[2].offset), ([1.0, 2.0, -3.0], [0.5, 1.0, 10.0]));
    }

    #[test]
    fn end_sites_never_share_a_name() {
        let tip = "End Site {OFFSET 0 0 0}";
        let text = format!(
            "HIERARCHY ROOT Hand {{OFFSET 0 0 0 CHANNELS 1 Xrotation {tip} {tip}\n\
             JOINT Hand_End2 {{OFFSET 0 0 0 CHANNELS 0\n\
             End Site {{OFFSET 1 1 1 CHANNELS 0}}}} {tip}}} MOTION"
        );
        let joints = read(&mut Source::new(&text)).unwrap();
        let names: Vec<_> = joints.iter().map(|joint| joint.name.as_str()).collect();
        let expected = ["Hand", "Hand_End", "Hand_End3", "Hand_End2", "Hand_End2_End", "Hand_End4"];
        assert_eq!(names, expected);
    }

    #[test]
    fn a_tree_without_joints_or_channels_is_refused() {
        let refused = |text| read(&mut Source::new(text)).unwrap_err().to_string();
        assert!(refused("HIERARCHY MOTION").contains("no ROOT"));
        assert!(
            refused("HIERARCHY ROOT a {OFFSET 0 0 0 CHANNELS 0} MOTION")
                .contains("nothing can move")
        );
    }
}
