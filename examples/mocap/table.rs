//! What the program prints.

use std::fmt::{self, Write};

use crate::positions::{Positions, distance};
use dq8_bvh::Clip;

pub(crate) fn text(clip: &Clip, positions: &Positions) -> Result<String, fmt::Error> {
    let mut text = String::new();
    let Positions { world, size, difference } = positions;
    let (joints, end_sites, frames) = (clip.joints.len(), clip.end_sites(), clip.frames());
    writeln!(text, "{}", clip.title)?;
    writeln!(text, "  joints      {joints}, of them {end_sites} end sites")?;
    writeln!(text, "  frames      {frames}, {:.2} s", frames as f64 * clip.frame_time)?;
    writeln!(text, "  size        {size:.4} from a root to its farthest joint")?;
    for (index, root) in clip.joints.iter().enumerate().filter(|(_, joint)| joint.parent.is_none())
    {
        let path: Vec<_> = world.iter().skip(index).step_by(joints).copied().collect();
        let length: f64 = path.windows(2).map(|step| distance(step[0], step[1])).sum();
        let (Some(&first), Some(&last)) = (path.first(), path.last()) else { continue };
        let apart = distance(first, last);
        let name = &root.name;
        writeln!(
            text,
            "  root        {name}: a path of {length:.4}, ends {apart:.4} from its start"
        )?;
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let (least, most) =
            world.iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p[axis]), b.max(p[axis])));
        let [least, most] = [least, most].map(|coordinate| positions.digits(coordinate));
        writeln!(text, "  {name}           {least} to {most}")?;
    }
    // A skeleton that is a single point has no size to compare with.
    let sizes = if *difference == 0.0 { 0.0 } else { difference / size };
    writeln!(text, "  f32 to f64  {difference:.1e} at most, {sizes:.1e} of the size")?;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::text;
    use crate::biped;
    use crate::positions::Positions;

    #[test]
    fn the_biped_goes_four_strides_and_stays_on_the_ground() {
        let clip = biped::clip();
        let text = text(&clip, &Positions::of(&clip).unwrap()).unwrap();
        assert!(text.contains("joints      21, of them 5 end sites"), "{text}");
        assert!(text.contains("frames      256, 4.27 s"), "{text}");
        // 1.2 m each, but for the step from the last frame to the first.
        assert!(text.contains("root        Pelvis: a path of 4.8460, ends 4.7813 from"), "{text}");
        assert!(text.contains("y           -0.000541"), "{text}");
        assert!(text.contains(" to 1.76796"), "{text}");
    }
}
