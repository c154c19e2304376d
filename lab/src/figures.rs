//! The figures of the papers, drawn by what is computed: Kenwright's chain and biped, Jia's line
//! and screw, Arends' four vectors.

mod biped;
mod canvas;
mod chain;
mod lines;
mod vectors;

pub use biped::{LIMITS, Limit, limit_of};
pub use canvas::{Canvas, Side, View, colour};

use crate::report::{Section, paragraph};
use std::error::Error;

/// Draws and writes up.
///
/// # Errors
/// If a chart cannot be drawn.
pub fn section() -> Result<Section, Box<dyn Error>> {
    let (chains, deviations) = chain::figures();
    let stance = biped::figure()?;
    let mut body = paragraph(
        "Kenwright's figures 2 to 4. The ideal chain takes every step exactly; the others take the same steps in \
         single precision, as matrices. Boxes stand around the links. Rounding could not be seen, so all \
         deviations from the ideal chain, of places and of axes, are drawn a thousand times as large.",
    );
    body += &chains;
    body += &paragraph(
        "Kenwright's figure 5, the biped of 16 links and 36 degrees of freedom in its stance. He gives the two \
         numbers; lengths are those of the example mocap, and the limits of joints, which he mentions and does \
         not give, are round numbers within what clinicians find on adults. Sectors are bending about \
         the axis across (from the side) and leaning about the axis ahead (from the front).",
    );
    body += &stance;
    body += &paragraph(
        "Jia's figures 1 and 2. A line has the direction l and the moment m = p × l, the same for each of its \
         points p; l × m is its point nearest to the origin. Every motion is a screw about such a line.",
    );
    body += &lines::plucker();
    body += &lines::screw();
    body += &paragraph(
        "Arends' four vectors (appendix A, animate). In his program the vector of SLERP turns by 1.575° per frame \
         and the others by 1°. In the left half all are as he has them, in the right half all are told 1°. Marks are the \
         tips in every tenth frame; browsers move the vectors.",
    );
    body += &vectors::windows();
    body += &vectors::angles()?;
    Ok(Section {
        title: "Figures of the papers",
        tried: "What the papers show in figures is computed and drawn: a chain that follows a target, ideal, \
                drifted and repaired; the biped in its stance with the limits of its joints; a line and a \
                screw in their coordinates; four vectors that turn by four representations."
            .to_owned(),
        claimed: vec![
            "Kenwright, figures 2 to 4: drifted matrices skew and scale the links; orthonormal ones leave the end \
             off the ideal one, and joints jump.",
            "Kenwright, figure 5: 16 links with 36 degrees of freedom, with joint limits.",
            "Jia, figures 1 and 2: Plücker coordinates; every motion is a turn about a line and a slide along it.",
            "Arends, chapter 6: the vector of SLERP turns much faster than the others.",
        ],
        found: deviations.into_iter().chain(vectors::found()).collect(),
        verdict: "The pictures of the chain are as Kenwright's, but only a thousand times enlarged: what is drawn \
                  skewed is, at its worst, a thousandth of a right angle. Made orthonormal, links are boxes again, \
                  and the end is still beside the ideal one, nearer than before. No joint jumps (see the first \
                  section). Arends' vector of SLERP is faster because it is told to be; told the same, all four \
                  are equally fast.",
        body,
    })
}
