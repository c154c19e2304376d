//! World positions as a table: one row per frame, three columns per joint.

use std::fmt::Write;

use crate::positions::Positions;
use dq8_bvh::Clip;

pub(crate) fn table(clip: &Clip, positions: &Positions) -> Result<String, std::fmt::Error> {
    let mut text = String::from("time");
    for joint in &clip.joints {
        for axis in ["x", "y", "z"] {
            write!(text, ",{}", quoted(&format!("{}.{axis}", joint.name)))?;
        }
    }
    text.push('\n');
    for (frame, world) in positions.world.chunks_exact(clip.joints.len()).enumerate() {
        write!(text, "{:.6}", clip.time(frame))?;
        for &coordinate in world.iter().flatten() {
            write!(text, ",{}", positions.digits(coordinate))?;
        }
        text.push('\n');
    }
    Ok(text)
}

/// As RFC 4180 has it: names of joints may hold commas and quotes.
fn quoted(field: &str) -> String {
    if field.contains([',', '"']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::table;
    use crate::positions::Positions;
    use dq8_bvh::{Axis, Channel, Clip, Joint};

    #[test]
    fn a_row_a_frame_in_file_order_with_the_digits_of_f32() {
        let clip = Clip {
            title: String::new(),
            joints: vec![
                Joint::new("a", None, [0.0; 3], vec![Channel::Rotation(Axis::X)]),
                Joint::new("b,\"c\"", Some(0), [0.0; 3], vec![]),
            ],
            frame_time: 0.008333333,
            values: vec![0.0; 2],
        };
        let world = vec![
            [1.0, 2.0, 3.0],
            [0.0000004, -1.5, 1e6],
            [390.123_45_f32.into(), 0.0, -0.3],
            [0.1234567, 400.0, 123_456.789_012_345],
        ];
        let positions = Positions { world, size: 390.5, difference: 0.0 };
        let expected = "time,a.x,a.y,a.z,\"b,\"\"c\"\".x\",\"b,\"\"c\"\".y\",\"b,\"\"c\"\".z\"\n\
            0.000000,1.0,2.0,3.0,4e-7,-1.5,1000000.00000\n\
            0.008333,390.12344,0.0,-0.3,0.1234567,400.00000,123456.78901\n";
        assert_eq!(table(&clip, &positions).unwrap(), expected);
    }
}
