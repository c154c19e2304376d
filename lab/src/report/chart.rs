use super::power_of_ten;
use plotters::prelude::*;
use std::error::Error;

/// A line in a chart.
#[derive(Clone, Debug)]
pub struct Series {
    /// What the legend says.
    pub name: String,
    /// (x, y); what is not finite, or on a logarithmic scale not positive, leaves a gap.
    pub points: Vec<(f64, f64)>,
}

/// A line chart. Every line has a colour of its own; one that would hide an earlier line is drawn
/// in dashes over it.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Above the chart.
    pub title: String,
    /// Below the horizontal axis, with its unit.
    pub x: String,
    /// Beside the vertical axis, with its unit.
    pub y: String,
    /// Whether the vertical axis is logarithmic.
    pub logarithmic: bool,
    /// The lines.
    pub series: Vec<Series>,
}

impl Chart {
    /// The chart as an SVG element.
    ///
    /// # Errors
    /// If there is nothing to draw.
    pub fn to_svg(&self) -> Result<String, Box<dyn Error>> {
        // A logarithmic axis is a plain one of exponents: plotters has two types for them.
        let height = |y: f64| if self.logarithmic { y.log10() } else { y };
        let lines: Vec<Vec<(f64, f64)>> = self
            .series
            .iter()
            .map(|line| {
                let points = line.points.iter().map(|&(x, y)| (x, height(y)));
                points.filter(|(x, y)| x.is_finite() && y.is_finite()).collect()
            })
            .collect();
        let Some((x, mut y)) = spans(lines.iter().flatten().copied()) else {
            return Err(format!("nothing to draw in the chart: {}", self.title).into());
        };
        if self.logarithmic {
            y = (y.0.floor(), y.1.ceil());
        }
        let mut svg = String::new();
        {
            let area = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
            let mut axes = ChartBuilder::on(&area)
                .caption(&self.title, ("sans-serif", TITLE))
                .margin(10)
                .margin_right(LEGEND)
                .x_label_area_size(50)
                .y_label_area_size(80)
                .build_cartesian_2d(x.0..x.1, y.0..y.1)?;
            let mut mesh = axes.configure_mesh();
            mesh.x_desc(&self.x).y_desc(&self.y).light_line_style(TRANSPARENT);
            mesh.x_label_formatter(&|x| plain(*x)).y_label_formatter(&|y| plain(*y));
            mesh.bold_line_style(BLACK.mix(0.12)).label_style(("sans-serif", LETTERS));
            if self.logarithmic {
                // Ticks at whole exponents, of which there is one more than there are decades; at
                // every other one of many.
                let decades = (y.1 - y.0) as usize;
                mesh.y_labels(decades / (1 + decades / 17) + 1)
                    .y_label_formatter(&|exponent| power_of_ten(exponent.round() as i32))
                    .draw()?;
            } else {
                mesh.draw()?;
            }
            let pixel = (y.1 - y.0) / f64::from(HEIGHT);
            for (number, (line, points)) in self.series.iter().zip(&lines).enumerate() {
                let (r, g, b) = COLOURS[number % COLOURS.len()];
                let colour = RGBColor(r, g, b);
                let hides = lines[..number].iter().any(|other| coincide(other, points, pixel));
                if hides {
                    let style = colour.stroke_width(3);
                    axes.draw_series(DashedLineSeries::new(
                        points.clone(),
                        9,
                        9 + 4 * number as u32,
                        style,
                    ))?;
                } else {
                    axes.draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?;
                }
                // Beside the axes: curves are everywhere in them.
                let (left, height) = ((WIDTH - LEGEND) as i32 + 8, 56 + 20 * number as i32);
                let key = vec![(left, height), (left + 20, height)];
                area.draw(&PathElement::new(key, colour.stroke_width(3)))?;
                let style = ("sans-serif", LETTERS).into_font();
                area.draw(&Text::new(line.name.clone(), (left + 26, height - 6), style))?;
            }
            area.present()?;
        }
        Ok(svg)
    }
}

/// Whether two lines are nowhere farther apart than `gap`.
fn coincide(a: &[(f64, f64)], b: &[(f64, f64)], gap: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() <= gap)
}

/// A tick without the rounding of its sum.
fn plain(tick: f64) -> String {
    ((tick * 1e6).round() / 1e6).to_string()
}

/// As many as a chart has lines at most, none like another (after Okabe and Ito 2008, with three
/// more).
const COLOURS: [(u8, u8, u8); 10] = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (86, 180, 233),
    (230, 159, 0),
    (34, 34, 34),
    (128, 0, 32),
    (102, 51, 153),
    (128, 128, 0),
];
const WIDTH: u32 = 1000;
const HEIGHT: u32 = 400;
/// Pixels at the right for the names of the lines.
const LEGEND: u32 = 340;
/// Heights of a line of text, of which letters have four fifths: read where the picture is 800
/// pixels wide.
const LETTERS: u32 = 16;
const TITLE: u32 = 20;

/// The smallest and largest x and y, never of no width; `None` without points.
fn spans(mut points: impl Iterator<Item = (f64, f64)>) -> Option<((f64, f64), (f64, f64))> {
    let (x, y) = points.next()?;
    let (x, y) = points.fold(((x, x), (y, y)), |(across, up), (x, y)| {
        ((across.0.min(x), across.1.max(x)), (up.0.min(y), up.1.max(y)))
    });
    let wide =
        |(low, high): (f64, f64)| if low < high { (low, high) } else { (low - 1.0, high + 1.0) };
    Some((wide(x), wide(y)))
}
