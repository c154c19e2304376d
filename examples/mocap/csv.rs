//! World positions as a table: one row per frame, three columns per joint.

use std::fmt::Write;

use crate::clip::Clip;

/// `positions` are `[frame][joint]`.
pub(crate) fn table(clip: &Clip, positions: &[[f64; 3]]) -> Result<String, std::fmt::Error> {
    let mut text = String::from("time");
    for joint in &clip.joints {
        for axis in ["x", "y", "z"] {
            write!(text, ",{}", quoted(&format!("{}.{axis}", joint.name)))?;
        }
    }
    text.push('\n');
    for (frame, positions) in positions.chunks_exact(clip.joints.len()).enumerate() {
        write!(text, "{:.6}", clip.time(frame))?;
        for coordinate in positions.iter().flatten() {
            write!(text, ",{coordinate:.6}")?;
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
    use crate::clip::{Axis, Channel, Clip, Joint};

    #[test]
    fn a_row_a_frame_in_file_order_with_six_decimals() {
        let joint = |name: &str, parent, channels| Joint {
            name: name.into(),
            parent,
            offset: [0.0; 3],
            channels,
            end_site: false,
        };
        let clip = Clip {
            title: String::new(),
            joints: vec![
                joint("a", None, vec![Channel::Rotation(Axis::X)]),
                joint("b,\"c\"", Some(0), vec![]),
            ],
            frame_time: 0.008333333,
            values: vec![0.0; 2],
        };
        let positions = [[1.0, 2.0, 3.0], [0.0000004, -1.5, 1e6], [0.0; 3], [0.1234567, 0.0, 0.0]];
        let expected = "time,a.x,a.y,a.z,\"b,\"\"c\"\".x\",\"b,\"\"c\"\".y\",\"b,\"\"c\"\".z\"\n\
            0.000000,1.000000,2.000000,3.000000,0.000000,-1.500000,1000000.000000\n\
            0.008333,0.000000,0.000000,0.000000,0.123457,0.000000,0.000000\n";
        assert_eq!(table(&clip, &positions).unwrap(), expected);
    }
}
