//! The report of a build as one HTML document, which prints on a page of A4: the shape in the
//! current view, its plan, the build check with limits and histograms, a bill of materials, and a
//! link that opens the model. The numbers come from [`BuildReport`]. The document needs no other
//! file and runs no script.
//!
//! [`BuildReport`]: super::BuildReport

mod bill;
mod picture;
mod words;

use crate::fabricate::build::Build;
use crate::fabricate::check_card::CheckRow;
use crate::fabricate::file::{escaped, places};
use crate::fabricate::report::BuildReport;
use crate::scene::OffsetKind;
use bill::{Line, bill, noun};
use picture::{Picture, from_above, from_camera};
use words::{count, length, sentence, short, with_unit};

/// The look. The policy of the page that shows the document allows exactly this text.
const STYLE: &str = include_str!("page.css");
/// The widths and the largest height of the two pictures, in mm when printed.
const PICTURES: ([f64; 2], f64) = ([102.0, 74.0], 68.0);
/// Camera of the initial view of every mesh, as in the page's view: turn and tilt in radians.
const FIRST: [f64; 2] = [0.55, 0.65];
/// Largest number of characters of a link that is printed; longer ones can only be clicked.
const MOST_LINK: usize = 400;

/// The model as the report shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportView {
    /// The name of the model.
    pub title: String,
    /// Whether z points up in the mesh; else y does.
    pub z_up: bool,
    /// Rotation of the camera about the upward axis, and its tilt down, in radians; none for the
    /// initial view.
    pub camera: Option<[f64; 2]>,
    /// An address that opens the model; empty if there is none.
    pub link: String,
}

impl Build {
    /// The report as an HTML document, which is also well-formed XML.
    pub fn report_page(&self, view: &ReportView) -> String {
        let report = self.report();
        let title = match view.title.trim() {
            "" => "Model".to_owned(),
            own => escaped(own),
        };
        let sections = [
            self.head(&report, &title),
            self.pictures(view),
            self.check(&report),
            materials(bill(self, &report)),
            notes(&report),
            foot(&view.link),
        ];
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <title>Report on {title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
            sections.concat()
        )
    }

    fn head(&self, report: &BuildReport, title: &str) -> String {
        let words = format!(
            "{} at 1:{}, {} on {}. Model in {}; lengths of the building in mm.",
            self.settings.material,
            short(report.scale),
            count(report.placed, noun(report.product)),
            count(report.sheets, "sheet"),
            report.unit
        );
        let words = escaped(&sentence(&words));
        format!("<header>\n<h1>{title}</h1>\n<p>{words}</p>\n</header>\n")
    }

    fn pictures(&self, view: &ReportView) -> String {
        let ([wide, narrow], high) = PICTURES;
        let seen = Picture::new(self, from_camera(view.z_up, view.camera.unwrap_or(FIRST)));
        let plan = Picture::new(self, from_above(view.z_up));
        let building = self.mm_of_building();
        let scale = round_up(building / plan.scale_in([narrow, high]));
        let [across, along] = plan.size.map(|size| length(size * building));
        let words = format!("Plan 1:{}, {across} by {along}", short(scale));
        let figures = [
            (seen.shaded([wide, high], &self.failed()), "Current view; red exceeds a limit"),
            (plan.plan(narrow, building / scale), &*words),
        ];
        let figures = figures.map(|(picture, caption)| {
            let caption = escaped(caption);
            format!("<figure>\n{picture}\n<figcaption>{caption}</figcaption>\n</figure>\n")
        });
        format!("<div class=\"pictures\">\n{}</div>\n", figures.concat())
    }

    fn check(&self, report: &BuildReport) -> String {
        let rows = report.check.iter().zip(self.spreads());
        let rows: String = rows.map(|(row, values)| check_row(row, &values)).collect();
        let words = report.offset.as_ref().map_or(String::new(), |offset| {
            let kept = match offset.kind {
                OffsetKind::Corner => "Corners keep",
                OffsetKind::Face => "Panels keep",
                OffsetKind::Edge => "Beams keep",
            };
            let how = if offset.exact { "exactly" } else { "as nearly as possible" };
            let why = if offset.exact { String::new() } else { format!("; {}", offset.why_not) };
            let words = format!("{kept} a distance of {} {how}{why}.", length(offset.distance_mm));
            format!("<p>{}</p>\n", escaped(&words))
        });
        section("Build check", &format!("<table>\n{rows}</table>\n{words}"))
    }
}

fn section(title: &str, content: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{content}</section>\n")
}

fn check_row(row: &CheckRow, values: &[f64]) -> String {
    let number = |value: Option<f64>, otherwise: &str| {
        value.map_or(otherwise.to_owned(), |value| escaped(&with_unit(value, row.unit)))
    };
    let (state, class) = match row.met {
        Some(true) => ("met".to_owned(), "met"),
        Some(false) if row.failed > 0 => (format!("not met by {}", row.failed), "unmet"),
        Some(false) => ("not met".to_owned(), "unmet"),
        None => (String::new(), "open"),
    };
    format!(
        "<tr class=\"{class}\"><th scope=\"row\">{}</th><td>{}</td><td>limit {}</td><td>{state}</td><td>{}</td></tr>\n",
        row.label,
        number(row.value, "not available"),
        number(row.limit, "none"),
        histogram(values, row.limit.unwrap_or_default(), row.unit)
    )
}

fn materials(columns: [Vec<Line>; 2]) -> String {
    let lists = columns.map(|column| {
        let line = |(what, value): Line| format!("<dt>{what}</dt><dd>{}</dd>\n", escaped(&value));
        format!("<dl>\n{}</dl>\n", column.into_iter().map(line).collect::<String>())
    });
    section("Bill of materials", &format!("<div class=\"bill\">\n{}</div>\n", lists.concat()))
}

fn notes(report: &BuildReport) -> String {
    let mut notes: Vec<String> = report.problems.clone();
    let some = |names: &[String]| match names.len().saturating_sub(4) {
        0 => names.join(", "),
        more => format!("{} and {more} more", names[..4].join(", ")),
    };
    for (what, names) in [
        ("Larger than the sheet, left out", &report.too_large),
        ("Not cut", &report.not_cut),
        ("No room for the name of", &report.unnamed),
        ("No tab between", report.paper.as_ref().map_or(&Vec::new(), |paper| &paper.without_tab)),
    ] {
        notes.extend((!names.is_empty()).then(|| format!("{what}: {}.", some(names))));
    }
    if report.dropped_names > 0 {
        notes.push(format!("{} of neighbours have no room.", count(report.dropped_names, "name")));
    }
    if notes.is_empty() {
        return String::new();
    }
    let items = notes.iter().map(|note| format!("<li>{}</li>\n", escaped(&sentence(note))));
    section("Notes", &format!("<ul>\n{}</ul>\n", items.collect::<String>()))
}

fn foot(link: &str) -> String {
    let program = concat!("Shape-Up ", env!("CARGO_PKG_VERSION"));
    let link = match link.chars().count() {
        0 => String::new(),
        length => {
            let words = match length > MOST_LINK {
                true => format!("Click here: its {length} characters are too many to type."),
                false => escaped(link),
            };
            format!("<a href=\"{}\" target=\"_blank\">{words}</a>\n", escaped(link))
        }
    };
    let label = if link.is_empty() { "" } else { "<p>Open this model:</p>\n" };
    format!("<footer>\n{label}<p class=\"program\">{program}</p>\n{link}</footer>\n")
}

/// Rounds up to the next of 1, 2, 2.5, 5, 10, ...
fn round_up(value: f64) -> f64 {
    let mut power = 1.0;
    while 10.0 * power < value {
        power *= 10.0;
    }
    while power >= value && power > 1e-9 {
        power /= 10.0;
    }
    let steps = [1.0, 2.0, 2.5, 5.0, 10.0].map(|step| step * power);
    steps.into_iter().find(|step| *step >= value * (1.0 - 1e-9)).unwrap_or(value)
}

/// Number of bars.
const BARS: usize = 30;
/// Width and height, in mm when printed.
const SIZE: [f64; 2] = [54.0, 8.5];
/// The height of the bars; the labels are below.
const BASE: f64 = 5.5;

/// Draws `values`, which should be from 0 to `limit`, as SVG; empty without a value above 0 or a
/// limit.
fn histogram(values: &[f64], limit: f64, unit: &str) -> String {
    let worst = values.iter().copied().fold(0.0, f64::max);
    let end = worst.max(1.25 * limit);
    if values.is_empty() || !(end.is_finite() && end > 0.0) {
        return String::new();
    }
    let mut counts = [0_u32; BARS];
    for value in values {
        counts[((value / end * BARS as f64) as usize).min(BARS - 1)] += 1;
    }
    let most = f64::from(counts.iter().copied().fold(1, u32::max));
    let [width, height] = SIZE;
    let step = width / BARS as f64;
    let mut bars = String::new();
    for (k, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
        // Rare values remain visible.
        let high = (f64::from(count) / most * BASE).max(0.4);
        let class = if k as f64 / BARS as f64 * end >= limit { "beyond" } else { "within" };
        let [x, y, wide, high] =
            [k as f64 * step, BASE - high, 0.85 * step, high].map(|at| places(at, 2));
        bars += &format!(
            "<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\"/>"
        );
    }
    let at = places(limit / end * width, 2);
    let (words, below) = (escaped(&with_unit(end, unit)), places(BASE + 0.6, 2));
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{} values from 0 to {words}\">\
         <path class=\"axis\" d=\"M0,{BASE}H{width}\"/>{bars}<path class=\"limit\" d=\"M{at},0V{below}\"/>\
         <text y=\"8.3\">0</text><text class=\"end\" x=\"{width}\" y=\"8.3\">{words}</text></svg>",
        values.len()
    )
}
