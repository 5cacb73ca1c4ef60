//! The layout of the page.

use super::bill::{Line, bill, noun};
use super::helvetica::{fitting, lines, width};
use super::histogram::histogram;
use super::mark::{BLACK, GREY, Mark, PALE, RED, heading, line, text, text_to};
use super::pdf::pdf;
use super::picture::{Picture, from_above, from_camera};
use super::svg::svg;
use super::words::{count, length, sentence, short, with_unit};
use crate::fabricate::build::Build;
use crate::fabricate::check_card::CheckRow;
use crate::fabricate::offset::OffsetKind;
use crate::fabricate::report::BuildReport;

/// A4, portrait.
const SIZE: [f64; 2] = [210.0, 297.0];
/// The margin.
const MARGIN: f64 = 14.0;
/// Right end of the contents.
const RIGHT: f64 = SIZE[0] - MARGIN;
/// Font size of text.
const WORDS: f64 = 3.3;
/// Font size of small text.
const SMALL: f64 = 2.7;
/// Line spacing.
const LINE: f64 = 5.2;
/// The two pictures: left ends, widths, and height.
const PICTURES: ([f64; 2], [f64; 2], f64) = ([MARGIN, 122.0], [102.0, 74.0], 68.0);
/// Height of a row of the build check.
const ROW: f64 = 9.5;
/// The baseline of the last line, and the line spacing of the link.
const FOOT: [f64; 2] = [9.0, 3.6];
/// Camera of the initial view of every mesh, as in the page's view: turn and tilt in radians.
const FIRST: [f64; 2] = [0.55, 0.65];
/// Largest number of lines of a printed link; longer ones can only be clicked.
const MOST_LINK: usize = 4;

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

/// The report on a page, for saving and for the screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReportPage {
    /// PDF, in ASCII.
    pub pdf: String,
    /// SVG.
    pub svg: String,
}

impl Build {
    /// The report on an A4 page.
    pub fn report_page(&self, view: &ReportView) -> ReportPage {
        let mut page = Page { marks: Vec::new(), y: SIZE[1] - 20.0 };
        let report = self.report();
        page.title(self, &report, &view.title);
        page.pictures(self, view);
        page.check(self, &report);
        page.bill(bill(self, &report));
        let link = shown_link(&view.link);
        page.notes(&report, FOOT[0] + FOOT[1] * (link.len() + 1) as f64);
        page.foot(&view.link, &link);
        ReportPage { pdf: pdf(&page.marks, SIZE), svg: svg(&page.marks, SIZE) }
    }
}

/// The page so far.
struct Page {
    marks: Vec<Mark>,
    /// The baseline of the next line.
    y: f64,
}

impl Page {
    fn title(&mut self, build: &Build, report: &BuildReport, title: &str) {
        let title = if title.trim().is_empty() { "Model" } else { title.trim() };
        // Bold letters are a tenth wider.
        let most = (RIGHT - MARGIN) / 1.1;
        let shown = fitting(title, 6.5, most);
        self.marks.push(heading([MARGIN, self.y], 6.5, shown));
        self.y -= 6.5;
        let words = format!(
            "{} at 1:{}, {} on {}. Model in {}; lengths of the building in mm.",
            build.settings.material,
            short(report.scale),
            count(report.placed, noun(report.product)),
            count(report.sheets, "sheet"),
            report.unit
        );
        let words = sentence(&words);
        let shown = fitting(&words, WORDS, RIGHT - MARGIN);
        self.marks.push(text([MARGIN, self.y], WORDS, GREY, shown));
        self.y -= 4.0;
        self.rule(self.y);
    }

    fn rule(&mut self, y: f64) {
        self.marks.push(line([[MARGIN, y], [RIGHT, y]], 0.2, PALE));
    }

    fn pictures(&mut self, build: &Build, view: &ReportView) {
        let (from, wide, high) = PICTURES;
        self.y -= 3.0 + high;
        let seen = Picture::new(build, from_camera(view.z_up, view.camera.unwrap_or(FIRST)));
        self.marks.extend(seen.shaded([from[0], self.y], [wide[0], high], &build.failed()));
        let plan = Picture::new(build, from_above(view.z_up));
        let building = build.mm_of_building();
        let room = [wide[1], high];
        let scale = round_up(building / plan.scale_in(room));
        self.marks.extend(plan.plan([from[1], self.y], room, building / scale));
        self.y -= 4.5;
        let [across, along] = plan.size.map(|size| length(size * building));
        let words = format!("Plan 1:{}, {across} by {along}", short(scale));
        self.marks.extend([
            text([from[0], self.y], SMALL, GREY, "Current view; red exceeds a limit"),
            text([from[1], self.y], SMALL, GREY, &words),
        ]);
    }

    fn section(&mut self, title: &str) {
        self.y -= 9.5;
        self.marks.push(heading([MARGIN, self.y], 4.0, title));
        self.rule(self.y - 2.0);
        self.y -= 2.0;
    }

    fn check(&mut self, build: &Build, report: &BuildReport) {
        self.section("Build check");
        for (row, values) in report.check.iter().zip(build.spreads()) {
            self.y -= ROW;
            self.check_row(row, &values);
        }
        let words = report.offset.as_ref().map_or(String::new(), |offset| {
            let kept = match offset.kind {
                OffsetKind::Corner => "Corners keep",
                OffsetKind::Face => "Panels keep",
                OffsetKind::Edge => "Beams keep",
            };
            let how = if offset.exact { "exactly" } else { "as nearly as possible" };
            let why = if offset.exact { String::new() } else { format!("; {}", offset.why_not) };
            format!("{kept} a distance of {} {how}{why}.", length(offset.distance_mm))
        });
        self.y -= 1.0;
        self.paragraph(&words, GREY);
    }

    fn check_row(&mut self, row: &CheckRow, values: &[f64]) {
        let y = self.y + 3.2;
        let number = |value: Option<f64>, otherwise: &str| {
            value.map_or(otherwise.to_owned(), |value| with_unit(value, row.unit))
        };
        let (state, colour) = match row.met {
            Some(true) => ("met".to_owned(), BLACK),
            Some(false) if row.failed > 0 => (format!("not met by {}", row.failed), RED),
            Some(false) => ("not met".to_owned(), RED),
            None => (String::new(), GREY),
        };
        let limit = format!("limit {}", number(row.limit, "none"));
        self.marks.extend([
            text([MARGIN, y], WORDS, BLACK, row.label),
            text_to([76.0, y], WORDS, colour, &number(row.value, "not available")),
            text_to([106.0, y], WORDS, GREY, &limit),
            text([112.0, y], WORDS, colour, &state),
        ]);
        let place = [142.0, self.y];
        let limit = row.limit.unwrap_or_default();
        self.marks.extend(histogram(values, limit, row.unit, place, [RIGHT - place[0], ROW - 1.0]));
    }

    fn bill(&mut self, columns: [Vec<Line>; 2]) {
        self.section("Bill of materials");
        let top = self.y;
        for (column, x) in columns.into_iter().zip([MARGIN, 110.0]) {
            let mut y = top;
            for (what, value) in column {
                y -= LINE;
                self.marks.push(text([x, y], WORDS, GREY, what));
                let value = fitting(&value, WORDS, 46.0);
                self.marks.push(text([x + 42.0, y], WORDS, BLACK, value));
            }
            self.y = self.y.min(y);
        }
    }

    fn notes(&mut self, report: &BuildReport, floor: f64) {
        let mut notes: Vec<String> = report.problems.clone();
        let some = |names: &[String]| match names.len().saturating_sub(4) {
            0 => names.join(", "),
            more => format!("{} and {more} more", names[..4].join(", ")),
        };
        for (what, names) in [
            ("Larger than the sheet, left out", &report.too_large),
            ("Not cut", &report.not_cut),
            ("No room for the name of", &report.unnamed),
            (
                "No tab between",
                report.paper.as_ref().map_or(&Vec::new(), |paper| &paper.without_tab),
            ),
        ] {
            notes.extend((!names.is_empty()).then(|| format!("{what}: {}.", some(names))));
        }
        if report.dropped_names > 0 {
            notes.push(format!(
                "{} of neighbours have no room.",
                count(report.dropped_names, "name")
            ));
        }
        if notes.is_empty() {
            return;
        }
        self.section("Notes");
        let all: Vec<String> =
            notes.iter().flat_map(|note| lines(&sentence(note), WORDS, RIGHT - MARGIN)).collect();
        let room = ((self.y - floor) / LINE).max(1.0) as usize;
        let (shown, ending) = match all.len() > room {
            true => (&all[..room - 1], Some("See the report in the program for the rest.")),
            false => (&all[..], None),
        };
        for line in shown.iter().map(String::as_str).chain(ending) {
            self.y -= LINE;
            self.marks.push(text([MARGIN, self.y], WORDS, BLACK, line));
        }
    }

    /// Adds text in as many lines as needed.
    fn paragraph(&mut self, words: &str, colour: super::mark::Colour) {
        for line in lines(words, WORDS, RIGHT - MARGIN) {
            self.y -= LINE;
            self.marks.push(text([MARGIN, self.y], WORDS, colour, &line));
        }
    }

    fn foot(&mut self, link: &str, shown: &[String]) {
        let program = concat!("Shape-Up ", env!("CARGO_PKG_VERSION"));
        self.marks.push(text_to([RIGHT, FOOT[0]], SMALL, GREY, program));
        let mut right = MARGIN;
        for (k, line) in shown.iter().rev().enumerate() {
            let y = FOOT[0] + FOOT[1] * k as f64;
            let colour = if k + 1 == shown.len() { BLACK } else { GREY };
            self.marks.push(text([MARGIN, y], SMALL, colour, line));
            right = right.max(MARGIN + width(line, SMALL));
        }
        if !shown.is_empty() {
            let top = FOOT[0] + FOOT[1] * shown.len() as f64;
            let corners = [[MARGIN, FOOT[0] - 1.0], [right, top]];
            self.marks.push(Mark::Link(corners, link.to_owned()));
        }
    }
}

/// A link as lines of text, replaced by a note if it is too long.
fn shown_link(link: &str) -> Vec<String> {
    // The name of the program is beside the last line.
    let mut found = lines(link, SMALL, RIGHT - MARGIN - 25.0);
    if found.len() > MOST_LINK {
        let length = link.chars().count();
        found = vec![format!("Click here: its {length} characters are too many to type.")];
    }
    if !found.is_empty() {
        found.insert(0, "Open this model:".to_owned());
    }
    found
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
