//! What the program prints.

use std::fmt::{self, Write};

use crate::clip::Clip;
use crate::contest::Contest;

pub(crate) fn text(clip: &Clip, instances: usize, contest: &Contest) -> Result<String, fmt::Error> {
    let mut text = String::new();
    let (joints, end_sites) = (clip.joints.len(), clip.end_sites());
    // A skeleton that is a single point has no size to compare with.
    let sizes = |difference: f64| if difference == 0.0 { 0.0 } else { difference / contest.size };
    writeln!(text, "{}", clip.title)?;
    writeln!(text, "  joints  {joints}, of them {end_sites} end sites")?;
    writeln!(text, "  frames  {}, timed {instances} ×", clip.frames())?;
    writeln!(text, "  size    {:.4} from a root to its farthest joint", contest.size)?;
    writeln!(text)?;
    writeln!(text, "                    ns per joint   largest difference   in sizes")?;
    for contender in &contest.contenders {
        let (name, ns, difference) = (contender.name, contender.ns_per_joint, contender.difference);
        let sizes = sizes(difference);
        writeln!(text, "  {name:<16} {ns:>13.2} {difference:>20.1e} {sizes:>10.1e}  from f64")?;
    }
    let difference = contest.lanes_to_f32;
    let sizes = sizes(difference);
    writeln!(
        text,
        "  {:<16} {:>13} {difference:>20.1e} {sizes:>10.1e}  from scalar f32",
        "8 lanes f32", ""
    )?;
    Ok(text)
}
