//! The document: its sections from top to bottom.

use super::bill::{Line, bill};
use super::histogram::histogram;
use super::picture::Picture;
use crate::fabricate::build::Build;
use crate::fabricate::build_words::CheckWords;
use crate::fabricate::check_card::CheckRow;
use crate::fabricate::file::escaped;
use crate::fabricate::report::BuildReport;
use crate::fabricate::view_axes::{from_above, from_camera};
use crate::words;

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
    /// An address that opens the model; empty if there is none. Any other than of the web is left out: in
    /// a document, `javascript:` would run as a script.
    pub link: String,
}

impl ReportView {
    /// Whether an address is of the web: whether it begins with `https://` or `http://`.
    pub fn is_web_address(address: &str) -> bool {
        let begins = |with: &str| {
            address.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with))
        };
        begins("https://") || begins("http://")
    }
}

impl Build {
    /// The report as an HTML document, which is also well-formed XML.
    pub fn report_page(&self, view: &ReportView) -> String {
        let report = self.report_without_curves();
        let title = match view.title.trim() {
            "" => "Model".to_owned(),
            own => escaped(own),
        };
        let sections = [
            self.head(&report, &title),
            self.pictures(view),
            self.check(&report),
            materials(bill(self, &report)),
            self.notes(&report),
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
        let line = format!(
            "{} at 1:{}, {} on {}. Model in {}.",
            self.settings.material,
            words::brief(report.scale),
            report.parts_in_words(true),
            words::count(report.sheets, "sheet", "sheets"),
            report.unit
        );
        let line = escaped(&words::sentence(line.trim_start()));
        format!("<header>\n<h1>{title}</h1>\n<p>{line}</p>\n</header>\n")
    }

    fn pictures(&self, view: &ReportView) -> String {
        let ([wide, narrow], high) = PICTURES;
        let seen = Picture::new(self, from_camera(view.z_up, view.camera.unwrap_or(FIRST)));
        let plan = Picture::new(self, from_above(view.z_up));
        let building = self.mm_of_building();
        let scale = round_up(building / plan.scale_in([narrow, high]));
        let [across, along] = plan.seen.size.map(|size| words::millimetres(size * building));
        let caption = format!("Plan 1:{}, {across} by {along}", words::brief(scale));
        let shown = if view.camera.is_some() { "Current view" } else { "The shape" };
        let shown = format!("{shown}; red panels and edges exceed a limit");
        let figures = [
            (seen.shaded([wide, high], &self.failed()), &*shown),
            (plan.plan(narrow, building / scale), &*caption),
        ];
        let figures = figures.map(|(picture, caption)| {
            let caption = escaped(caption);
            format!("<figure>\n{picture}\n<figcaption>{caption}</figcaption>\n</figure>\n")
        });
        format!("<div class=\"pictures\">\n{}</div>\n", figures.concat())
    }

    fn check(&self, report: &BuildReport) -> String {
        let rows = report.card.check.iter().zip(self.check_values());
        let rows: String = rows.map(|(row, values)| check_row(row, &values)).collect();
        let kept = report
            .card
            .offset
            .as_ref()
            .map_or(String::new(), |offset| format!("<p>{}</p>\n", escaped(&offset.words())));
        section("Build check", &format!("<table>\n{rows}</table>\n{kept}"))
    }

    fn notes(&self, report: &BuildReport) -> String {
        let notes = report.card.problems.iter().cloned().chain(self.words(report).warnings);
        let items = notes.map(|note| format!("<li>{}</li>\n", escaped(&note)));
        match items.collect::<String>() {
            none if none.is_empty() => none,
            items => section("Notes", &format!("<ul>\n{items}</ul>\n")),
        }
    }
}

fn section(title: &str, content: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{content}</section>\n")
}

fn check_row(row: &CheckRow, values: &[f64]) -> String {
    let class = match row.met {
        Some(true) => "met",
        Some(false) => "unmet",
        None => "open",
    };
    let CheckWords { value, limit, state, .. } = row.words();
    let [value, limit, state] = [value, limit, state].map(|words| escaped(&words));
    let spread = histogram(values, row.limit.unwrap_or_default(), |end| row.value_in_words(end));
    format!(
        "<tr class=\"{class}\"><th scope=\"row\">{}</th><td>{value}</td><td>{limit}</td><td>{state}</td><td>{spread}</td></tr>\n",
        row.label
    )
}

fn materials(columns: [Vec<Line>; 2]) -> String {
    let lists = columns.map(|column| {
        let line = |(what, value): Line| format!("<dt>{what}</dt><dd>{}</dd>\n", escaped(&value));
        format!("<dl>\n{}</dl>\n", column.into_iter().map(line).collect::<String>())
    });
    section("Bill of materials", &format!("<div class=\"bill\">\n{}</div>\n", lists.concat()))
}

fn foot(link: &str) -> String {
    let program = concat!("Shape-Up ", env!("CARGO_PKG_VERSION"));
    let link = match link.chars().count() {
        _ if !ReportView::is_web_address(link) => String::new(),
        length => {
            let words = match length > MOST_LINK {
                true => "Click to open it; the link is too long to print.".to_owned(),
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
