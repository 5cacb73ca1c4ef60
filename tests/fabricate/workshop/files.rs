//! The files of a build, as a workshop opens them: tables, and sheets with layers.

use super::letters::{Text, read};
use shape_up::fabricate::Build;
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, is_inside};
use std::collections::BTreeMap;

/// A table with a header.
pub(super) struct Table(Vec<BTreeMap<String, String>>);

impl Table {
    pub(super) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.0.iter().map(Row)
    }
}

/// A row of a table.
#[derive(Clone, Copy)]
pub(super) struct Row<'a>(&'a BTreeMap<String, String>);

impl<'a> Row<'a> {
    pub(super) fn text(&self, column: &str) -> &'a str {
        self.0.get(column).unwrap_or_else(|| panic!("there is no column {column}"))
    }

    pub(super) fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("{column}: {}", self.text(column)))
    }
}

/// A part on a sheet, in mm of the sheet, y upwards.
pub(super) struct Part {
    pub(super) name: String,
    pub(super) outline: Vec<Point2>,
    /// What is written on it.
    pub(super) texts: Vec<Text>,
    pub(super) folds: Vec<[Point2; 2]>,
    pub(super) valleys: Vec<[Point2; 2]>,
    /// Its arrow, from its end to its tip.
    pub(super) arrow: Option<[Point2; 2]>,
    /// What is cut out inside.
    pub(super) holes: Vec<Vec<Point2>>,
}

/// Lines, and the name of their part.
type Named = (String, Vec<Vec<Point2>>);

/// A drawing: the lines of each layer.
pub(super) struct Drawn {
    pub(super) title: String,
    layers: BTreeMap<String, Vec<Named>>,
}

impl Drawn {
    fn read(text: &str) -> Drawn {
        let document = roxmltree::Document::parse(text).expect("it is XML");
        let root = document.root_element();
        let view = root.attribute("viewBox").unwrap();
        let height: f64 = view.rsplit(' ').next().unwrap().parse().unwrap();
        let name = |path: &roxmltree::Node<'_, '_>| path.attribute("id").unwrap_or("").to_owned();
        let layer = |group: roxmltree::Node<'_, '_>| {
            let paths = group.children().filter(|node| node.has_tag_name("path"));
            let read = |path| (name(&path), lines(path.attribute("d").unwrap(), height));
            (name(&group), paths.map(read).collect())
        };
        let groups = root.children().filter(|node| node.has_tag_name("g"));
        let title = root.children().find(|node| node.has_tag_name("title")).unwrap();
        Drawn { title: title.text().unwrap().to_owned(), layers: groups.map(layer).collect() }
    }

    fn layer(&self, id: &str) -> &[Named] {
        self.layers.get(id).map_or(&[][..], |own| &own[..])
    }

    /// All lines of a layer.
    pub(super) fn lines(&self, id: &str) -> Vec<Vec<Point2>> {
        self.layer(id).iter().flat_map(|(_, own)| own.clone()).collect()
    }
}

/// What is left of a build: its tables and its sheets.
pub(super) struct Files {
    texts: BTreeMap<String, String>,
}

impl Files {
    pub(super) fn of(build: &Build) -> Files {
        let files = build.files(true).into_iter();
        let kept = files.filter(|file| file.name.ends_with(".csv") || file.name.ends_with(".svg"));
        Files {
            texts: kept.map(|file| (file.name, String::from_utf8(file.bytes).unwrap())).collect(),
        }
    }

    pub(super) fn table(&self, name: &str) -> Table {
        let mut lines = self.texts[name].lines();
        let header: Vec<String> = fields(lines.next().unwrap());
        let row = |line| header.iter().cloned().zip(fields(line)).collect();
        Table(lines.map(row).collect())
    }

    /// Where nodes are, in mm of the building.
    pub(super) fn nodes(&self) -> BTreeMap<String, Vec3<f64>> {
        let at = |row: Row<'_>| Vec3::from(["x_mm", "y_mm", "z_mm"].map(|k| row.number(k)));
        let table = self.table("nodes.csv");
        table.rows().map(|row| (row.text("name").to_owned(), at(row))).collect()
    }

    /// A number of the summary.
    pub(super) fn number(&self, what: &str) -> f64 {
        self.text(what).parse().unwrap_or_else(|_| panic!("{what} is no number"))
    }

    /// A word of the summary.
    pub(super) fn text(&self, what: &str) -> String {
        let table = self.table("summary.csv");
        let row = table.rows().find(|row| row.text("what") == what);
        row.unwrap_or_else(|| panic!("no {what}")).text("value").to_owned()
    }

    /// The drawings whose names begin like this.
    pub(super) fn drawn(&self, name: &str) -> Vec<Drawn> {
        let own = self.texts.iter().filter(|(own, _)| own.starts_with(name));
        own.filter(|(own, _)| own.ends_with(".svg")).map(|(_, text)| Drawn::read(text)).collect()
    }

    /// All parts, and what is written beside parts or in the margins.
    pub(super) fn parts(&self) -> (Vec<Part>, Vec<Text>) {
        let (mut parts, mut beside) = (Vec::new(), Vec::new());
        for sheet in self.drawn("sheet-") {
            let texts: Vec<Text> = read(&sheet.lines("ENGRAVE"));
            let [folds, valleys] = [sheet.lines("FOLD"), undashed(sheet.lines("VALLEY"))]
                .map(|own| own.into_iter().map(|line| [line[0], line[1]]).collect());
            let (folds, valleys): (Vec<[Point2; 2]>, Vec<[Point2; 2]>) = (folds, valleys);
            let arrows = arrows(&sheet.lines("ENGRAVE"));
            let holes = sheet.lines("HOLE");
            let mut is_on_part = vec![false; texts.len()];
            for (name, outlines) in sheet.layer("CUT") {
                let [outline] = &outlines[..] else { panic!("{name} is one outline") };
                let middle = |line: &[Point2; 2]| [0, 1].map(|k| 0.5 * (line[0][k] + line[1][k]));
                let inside = |lines: &[[Point2; 2]]| {
                    lines.iter().filter(|line| is_inside(outline, middle(line))).copied().collect()
                };
                let on_part = (0..texts.len()).filter(|&k| is_inside(outline, texts[k].centre));
                let on_part: Vec<usize> = on_part.collect();
                on_part.iter().for_each(|&k| is_on_part[k] = true);
                parts.push(Part {
                    texts: on_part.iter().map(|&k| texts[k].clone()).collect(),
                    folds: inside(&folds),
                    valleys: inside(&valleys),
                    arrow: arrows.iter().find(|[_, tip]| is_inside(outline, *tip)).copied(),
                    holes: (holes.iter().filter(|hole| is_inside(outline, hole[0])).cloned())
                        .collect(),
                    outline: outline.clone(),
                    name: name.clone(),
                });
            }
            let others = texts.into_iter().zip(is_on_part).filter(|(_, is_on_part)| !is_on_part);
            beside.extend(others.map(|(text, _)| text));
            beside.extend(read(&sheet.lines("SHEET")));
        }
        (parts, beside)
    }
}

/// The arrows among some lines: a stem, and a head whose middle is the tip.
fn arrows(lines: &[Vec<Point2>]) -> Vec<[Point2; 2]> {
    let arrow = |pair: &[Vec<Point2>]| match (&pair[0][..], &pair[1][..]) {
        (&[from, to], &[_, tip, _]) if to == tip => Some([from, to]),
        _ => None,
    };
    lines.windows(2).filter_map(arrow).collect()
}

/// The fields of a line of CSV.
fn fields(line: &str) -> Vec<String> {
    let (mut all, mut is_quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => all.push(String::new()),
            c => all.last_mut().unwrap().push(c),
        }
    }
    all
}

/// The lines of a path on a sheet of this height.
fn lines(path: &str, height: f64) -> Vec<Vec<Point2>> {
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',').unwrap();
        [x.parse().unwrap(), height - y.parse::<f64>().unwrap()]
    };
    let lines = path.split('M').filter(|line| !line.is_empty());
    lines.map(|line| line.trim_end_matches('Z').split('L').map(point).collect()).collect()
}

/// The lines that dashes make: the gap after a dash is six tenths of it.
fn undashed(dashes: Vec<Vec<Point2>>) -> Vec<Vec<Point2>> {
    let mut found: Vec<Vec<Point2>> = Vec::new();
    let mut next = [f64::NAN; 2];
    for dash in dashes {
        let [p, q] = dash[..] else { panic!("a dash has two ends") };
        match found.last_mut().filter(|_| shape_up::math::plane::distance(p, next) < 1e-3) {
            Some(line) => line[1] = q,
            None => found.push(dash),
        }
        next = [0, 1].map(|k| q[k] + 0.6 * (q[k] - p[k]));
    }
    found
}
