//! Curves in panels below each other, as SVG.

use std::fmt::Write;

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 420.0;
const MARGIN: f64 = 60.0;
const COLOURS: [&str; 2] = ["#888888", "#d55e00"];

/// Panels, one below the other.
#[derive(Default)]
pub(super) struct Drawing {
    body: String,
    panels: usize,
}

impl Drawing {
    /// Curves over labelled axes, each with its name; with `true` a unit is as long on both axes.
    pub(super) fn panel(
        &mut self,
        labels: [String; 2],
        same: bool,
        curves: &[(&str, Vec<[f64; 2]>)],
    ) {
        let points = || curves.iter().flat_map(|(_, points)| points);
        let range = |axis: usize| {
            let along = || points().map(|point| point[axis]);
            let [low, high] = [along().fold(f64::MAX, f64::min), along().fold(f64::MIN, f64::max)];
            (low, if high > low { high - low } else { 1.0 })
        };
        let [(left, width), (bottom, height)] = [range(0), range(1)];
        let mut units = [(WIDTH - 2.0 * MARGIN) / width, (HEIGHT - 2.0 * MARGIN) / height];
        if same {
            units = [units[0].min(units[1]); 2];
        }
        let floor = HEIGHT * (self.panels as f64 + 1.0) - MARGIN;
        let place =
            |[x, y]: [f64; 2]| [MARGIN + (x - left) * units[0], floor - (y - bottom) * units[1]];
        for ((name, points), colour) in curves.iter().zip(COLOURS) {
            if points.is_empty() {
                continue;
            }
            self.body += "<polyline fill='none' stroke-width='1.5' points='";
            for [x, y] in points.iter().map(|&point| place(point)) {
                self.put(format_args!("{x:.1},{y:.1} "));
            }
            self.put(format_args!("' stroke='{colour}'><title>{name}</title></polyline>\n"));
        }
        let [right, top] = place([left + width, bottom + height]);
        let mut text = |x: f64, y: f64, anchor: &str, text: &str| {
            self.put(format_args!(
                "<text x='{x:.1}' y='{y:.1}' text-anchor='{anchor}'>{text}</text>\n"
            ));
        };
        text(MARGIN, floor + 20.0, "start", &format!("{left:.2}"));
        text(right, floor + 20.0, "end", &format!("{:.2}", left + width));
        text(0.5 * (MARGIN + right), floor + 38.0, "middle", &labels[0]);
        text(MARGIN - 6.0, floor, "end", &format!("{bottom:.2}"));
        text(MARGIN - 6.0, top + 10.0, "end", &format!("{:.2}", bottom + height));
        text(MARGIN, top - 10.0, "start", &labels[1]);
        let legend = curves.iter().zip(COLOURS).filter(|((_, points), _)| !points.is_empty());
        for (row, ((name, _), colour)) in legend.enumerate() {
            let y = top - 10.0 - 16.0 * row as f64;
            self.put(format_args!(
                "<text x='{:.1}' y='{y:.1}' text-anchor='end' fill='{colour}'>{name}</text>\n",
                WIDTH - MARGIN
            ));
        }
        self.put(format_args!(
            "<path fill='none' stroke='black' d='M{MARGIN} {top:.1}V{floor:.1}H{right:.1}'/>\n"
        ));
        self.panels += 1;
    }

    fn put(&mut self, what: std::fmt::Arguments<'_>) {
        let _ = self.body.write_fmt(what);
    }

    pub(super) fn svg(self) -> String {
        let height = HEIGHT * self.panels as f64;
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {height}' font-family='sans-serif' \
             font-size='14'>\n<rect width='100%' height='100%' fill='white'/>\n{}</svg>\n",
            self.body
        )
    }
}
