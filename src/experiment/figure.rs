//! The plots of a run as SVG on white, one below another: a line for each method, on a logarithmic
//! scale of values.

use super::declaration::{Experiment, Over, Plot, Unit};
use super::run::{Run, Sample, Series};
use crate::fabricate::file::escaped;

/// Width and height of a plot, in pixels.
const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
/// Where the axes begin and end. The labels of the lines are to the right of them.
const X: [f64; 2] = [76.0, 500.0];
const Y: [f64; 2] = [352.0, 24.0];
/// Decades below the greatest value that are on the scale.
const DECADES: i32 = 14;
/// The largest number of labels on an axis, and the least distance between the labels of lines.
const MOST_TICKS: f64 = 6.0;
const LEAST_GAP: f64 = 14.0;
/// Colours for print, for successive methods.
const COLOURS: [&str; 6] = ["#1f5fc4", "#b8560b", "#1d7a4f", "#8a3fa6", "#1d2123", "#a81f50"];

/// The samples of a method in a plot: place on the horizontal axis, and value.
type Points = Vec<[f64; 2]>;

impl Run {
    /// Returns the plots of the experiment as an SVG file. `name` is that of the scene.
    pub fn svg(&self, name: &str) -> String {
        let experiment = self.experiment();
        let height = HEIGHT * experiment.plots.len() as f64;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" \
             viewBox=\"0 0 {WIDTH} {height}\" font-family=\"Helvetica, Arial, sans-serif\" \
             font-size=\"12\" fill=\"#1d2123\">\n\
             <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
        );
        let title = escaped(&format!("{}: {name}", experiment.label));
        for (k, plot) in experiment.plots.iter().enumerate() {
            let top = HEIGHT * k as f64;
            let words = escaped(&value_words(experiment, plot, &self.scene.units));
            let over = match plot.over {
                Over::Iterations => "iterations",
                Over::Seconds => "seconds",
            };
            let [x, y] = [X, Y].map(|[begin, end]| 0.5 * (begin + end));
            let drawn = drawn(experiment, plot, self.series());
            text += &format!(
                "<g transform=\"translate(0 {top})\">\n{drawn}\
                 <text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{over}</text>\n\
                 <text transform=\"translate(16 {y}) rotate(-90)\" text-anchor=\"middle\">{words}</text>\n\
                 <text x=\"{}\" y=\"14\" font-weight=\"600\">{title}</text>\n</g>\n",
                HEIGHT - 10.0,
                X[0],
            );
        }
        text + "</svg>\n"
    }
}

/// Returns what the vertical axis shows.
fn value_words(experiment: &Experiment, plot: &Plot, units: &str) -> String {
    let quantity = &experiment.quantities[plot.quantity];
    let unit = match quantity.unit {
        Unit::Energy if !units.is_empty() => format!(" in {units}²"),
        Unit::Length if !units.is_empty() => format!(" in {units}"),
        _ => String::new(),
    };
    let above = if plot.above_lowest { " above the lowest" } else { "" };
    format!("{}{above}{unit}", quantity.label)
}

/// Draws ticks, lines and their labels.
fn drawn(experiment: &Experiment, plot: &Plot, series: &[Series]) -> String {
    let lines: Vec<Points> = series.iter().map(|series| points(plot, series)).collect();
    let all = || lines.iter().flatten();
    let lowest = all().map(|&[_, value]| value).fold(f64::INFINITY, f64::min);
    let base = if plot.above_lowest { lowest } else { 0.0 };
    let scale = Scale::new(all().map(|&[at, value]| [at, value - base]));
    let mut text = scale.ticks();
    let mut labels = Vec::new();
    let methods = experiment.methods.iter().zip(COLOURS.into_iter().cycle());
    for ((method, colour), points) in methods.zip(&lines) {
        let seen: Points = points
            .iter()
            .map(|&[at, value]| [at, value - base])
            .filter(|&[_, value]| value >= 10f64.powi(scale.decades[0]))
            .map(|point| scale.place(point))
            .collect();
        let Some(&end) = seen.last() else { continue };
        let path: Vec<_> = seen.iter().map(|[x, y]| format!("{x:.2},{y:.2}")).collect();
        text += &format!(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\" \
             stroke-linejoin=\"round\"><title>{}</title></polyline>\n",
            path.join(" "),
            escaped(method.summary),
        );
        labels.push((end, colour, method.label));
    }
    // Labels that would overlap move down.
    labels.sort_by(|([_, a], ..), ([_, b], ..)| a.total_cmp(b));
    let mut free = f64::NEG_INFINITY;
    for ([x, y], colour, label) in labels {
        let y = y.max(free);
        free = y + LEAST_GAP;
        let (x, y) = (x + 6.0, y + 4.0);
        text += &format!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" fill=\"{colour}\">{}</text>\n",
            escaped(label)
        );
    }
    text
}

fn points(plot: &Plot, series: &Series) -> Points {
    let samples = series.samples.iter().enumerate();
    let place = |(k, sample): (usize, &Sample)| match plot.over {
        Over::Iterations => [k as f64, sample.values[plot.quantity]],
        Over::Seconds => [sample.seconds, sample.values[plot.quantity]],
    };
    samples.map(place).collect()
}

/// The scales of both axes.
struct Scale {
    /// The end of the horizontal axis, which begins at zero.
    last: f64,
    /// The powers of ten at the ends of the vertical axis.
    decades: [i32; 2],
}

impl Scale {
    fn new(points: impl Iterator<Item = [f64; 2]> + Clone) -> Scale {
        let one_unless_above_zero = |most: f64| if most > 0.0 { most } else { 1.0 };
        // If all values are zero, any scale will do.
        let greatest = points.clone().map(|[_, value]| value).fold(0.0, f64::max);
        let greatest = one_unless_above_zero(greatest);
        let seen = points.clone().map(|[_, value]| value);
        let seen = seen.filter(|&value| value > greatest * 10f64.powi(-DECADES));
        let low = seen.fold(greatest, f64::min).log10().floor() as i32;
        let high = (greatest.log10().ceil() as i32).max(low + 1);
        let last = points.map(|[at, _]| at).fold(0.0, f64::max);
        Scale { last: one_unless_above_zero(last), decades: [low, high] }
    }

    /// Returns the place of a point on the plot.
    fn place(&self, [at, value]: [f64; 2]) -> [f64; 2] {
        let [low, high] = self.decades.map(f64::from);
        let across = at / self.last;
        let up = (value.log10() - low) / (high - low);
        [X[0] + across * (X[1] - X[0]), Y[0] + up * (Y[1] - Y[0])]
    }

    /// Draws powers of ten with their lines, and round numbers along the horizontal axis.
    fn ticks(&self) -> String {
        let [low, high] = self.decades;
        let stride = (f64::from(high - low) / MOST_TICKS).ceil().max(1.0) as usize;
        let powers = (low..=high).step_by(stride).map(|power| {
            let [_, y] = self.place([0.0, 10f64.powi(power)]);
            let written = power.to_string().replace('-', "−");
            format!(
                "<line x1=\"{}\" x2=\"{}\" y1=\"{y:.2}\" y2=\"{y:.2}\" stroke=\"#d9dad6\"/>\
                 <text x=\"{}\" y=\"{:.2}\" text-anchor=\"end\">10\
                 <tspan dy=\"-5\" font-size=\"9\">{written}</tspan></text>\n",
                X[0],
                X[1],
                X[0] - 8.0,
                y + 4.0,
            )
        });
        let rough = self.last / MOST_TICKS;
        let power = rough.log10().floor() as i32;
        let round = [1.0, 2.0, 5.0].map(|k| k * 10f64.powi(power));
        let step = round.into_iter().find(|&step| step >= rough);
        let step = step.unwrap_or(10f64.powi(power + 1));
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        let numbers = (0..=(self.last / step + 1e-9) as u32).map(|k| {
            let at = f64::from(k) * step;
            let [x, _] = self.place([at, 1.0]);
            let y = Y[0] + 18.0;
            format!("<text x=\"{x:.2}\" y=\"{y}\" text-anchor=\"middle\">{at:.decimals$}</text>\n")
        });
        powers.chain(numbers).collect()
    }
}
