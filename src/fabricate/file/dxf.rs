//! ASCII DXF: one group code and one value per line, CRLF, coordinates with six decimal places.
//!
//! R2000 (AC1015) is the first version with the unit in its header and closed lightweight
//! polylines. It must be complete, with all tables, blocks and handles, or AutoCAD rejects it. R12
//! (AC1009) has neither handles nor lightweight polylines; officially it has no unit, but one is
//! written anyway.

use super::drawing::{Drawing, DrawnLine};
use super::six;
use crate::fabricate::sheet::Role;
use crate::scene::Dxf;

/// Writes a sheet. With `layers` each role has its own layer; else all is on layer 0.
pub fn dxf(drawing: &Drawing, version: Dxf, layers: bool) -> String {
    let mut writer = Writer { text: String::new(), handle: 0x100, layers };
    match version {
        Dxf::R2000 => writer.r2000(drawing),
        Dxf::R12 => writer.r12(drawing),
    }
    writer.text
}

/// Handles of objects that occur once. Those of other objects count up from `Writer::handle`.
mod handle {
    pub(super) const BLOCK_RECORDS: &str = "1";
    pub(super) const MODEL: &str = "20";
    pub(super) const PAPER: &str = "21";
    pub(super) const ROOT: &str = "30";
    pub(super) const GROUPS: &str = "31";
}

struct Writer {
    text: String,
    handle: u32,
    layers: bool,
}

impl Writer {
    fn pair(&mut self, code: u32, value: &str) {
        self.text += &format!("{code}\r\n{value}\r\n");
    }

    /// Writes pairs of a code and a value, as in `"0 SECTION 2 HEADER"`; `_` is an empty value.
    fn pairs(&mut self, words: &str) {
        let mut words = words.split_whitespace();
        while let (Some(code), Some(value)) = (words.next(), words.next()) {
            let value = if value == "_" { "" } else { value };
            self.text += &format!("{code}\r\n{value}\r\n");
        }
    }

    fn next_handle(&mut self) {
        let handle = format!("{:X}", self.handle);
        self.handle += 1;
        self.pair(5, &handle);
    }

    fn layer(&self, line: &DrawnLine) -> &'static str {
        if self.layers { line.role.layer() } else { "0" }
    }

    /// All layers with their colours.
    fn all_layers(&self) -> Vec<(&'static str, u8)> {
        let own = Role::ALL.iter().filter(|_| self.layers);
        [("0", 7)].into_iter().chain(own.map(|role| (role.layer(), role.aci()))).collect()
    }

    fn header(&mut self, version: &str, drawing: &Drawing) {
        let [width, height] = drawing.size.map(six);
        self.pair(999, &drawing.title);
        self.pairs("0 SECTION 2 HEADER 9 $ACADVER");
        self.pair(1, version);
        self.pairs("9 $INSBASE 10 0.0 20 0.0 30 0.0 9 $EXTMIN 10 0.0 20 0.0 30 0.0");
        self.pairs(&format!("9 $EXTMAX 10 {width} 20 {height} 30 0.0"));
        self.pairs("9 $INSUNITS 70 4 9 $MEASUREMENT 70 1 9 $LUNITS 70 2");
    }

    fn r2000(&mut self, drawing: &Drawing) {
        self.header("AC1015", drawing);
        let last = self.handle as usize + drawing.lines.len() + 64;
        self.pairs(&format!("9 $HANDSEED 5 {last:X} 0 ENDSEC"));
        self.pairs("0 SECTION 2 CLASSES 0 ENDSEC 0 SECTION 2 TABLES");
        self.table("VPORT", "8", &[]);
        let line_type = "100 AcDbLinetypeTableRecord";
        let pattern = "70 0 3 _ 72 65 73 0 40 0.0";
        let line_types = ["ByBlock", "ByLayer", "Continuous"]
            .map(|name| ("LTYPE", format!("{line_type} 2 {name} {pattern}")));
        self.table("LTYPE", "5", &line_types);
        let layers: Vec<_> = self
            .all_layers()
            .into_iter()
            .map(|(name, colour)| {
                let record =
                    format!("100 AcDbLayerTableRecord 2 {name} 70 0 62 {colour} 6 Continuous");
                ("LAYER", record)
            })
            .collect();
        self.table("LAYER", "2", &layers);
        let style = "100 AcDbTextStyleTableRecord 2 Standard 70 0 40 0.0 41 1.0 50 0.0 71 0 42 2.5 3 txt 4 _";
        self.table("STYLE", "3", &[("STYLE", style.to_owned())]);
        self.table("VIEW", "6", &[]);
        self.table("UCS", "7", &[]);
        self.table("APPID", "9", &[("APPID", "100 AcDbRegAppTableRecord 2 ACAD 70 0".to_owned())]);
        let dimension = "100 AcDbDimStyleTableRecord 2 Standard 70 0".to_owned();
        self.table("DIMSTYLE", "A", &[("DIMSTYLE", dimension)]);
        self.block_records();
        self.pairs("0 ENDSEC 0 SECTION 2 BLOCKS");
        self.block("*Model_Space", handle::MODEL, "");
        self.block("*Paper_Space", handle::PAPER, "67 1");
        self.pairs("0 ENDSEC 0 SECTION 2 ENTITIES");
        for line in &drawing.lines {
            self.pair(0, "LWPOLYLINE");
            self.next_handle();
            self.pairs(&format!("330 {} 100 AcDbEntity 8 {}", handle::MODEL, self.layer(line)));
            let closed = u8::from(line.closed);
            self.pairs(&format!("100 AcDbPolyline 90 {} 70 {closed} 43 0.0", line.points.len()));
            for &[x, y] in &line.points {
                self.pairs(&format!("10 {} 20 {}", six(x), six(y)));
            }
        }
        let (root, groups) = (handle::ROOT, handle::GROUPS);
        self.pairs("0 ENDSEC 0 SECTION 2 OBJECTS");
        self.pairs(&format!("0 DICTIONARY 5 {root} 330 0 100 AcDbDictionary 281 1"));
        self.pairs(&format!("3 ACAD_GROUP 350 {groups}"));
        self.pairs(&format!("0 DICTIONARY 5 {groups} 330 {root} 100 AcDbDictionary 281 1"));
        self.pairs("0 ENDSEC 0 EOF");
    }

    /// Writes a table of records: the type of each, and its pairs after `AcDbSymbolTableRecord`.
    fn table(&mut self, name: &str, own: &str, records: &[(&str, String)]) {
        self.pairs(&format!("0 TABLE 2 {name} 5 {own} 330 0 100 AcDbSymbolTable"));
        self.pairs(&format!("70 {}", records.len()));
        if name == "DIMSTYLE" {
            self.pairs("100 AcDbDimStyleTable");
        }
        for (kind, pairs) in records {
            self.pair(0, kind);
            let number = format!("{:X}", self.handle);
            self.handle += 1;
            self.pair(if *kind == "DIMSTYLE" { 105 } else { 5 }, &number);
            self.pairs(&format!("330 {own} 100 AcDbSymbolTableRecord {pairs}"));
        }
        self.pairs("0 ENDTAB");
    }

    fn block_records(&mut self) {
        let own = handle::BLOCK_RECORDS;
        self.pairs(&format!("0 TABLE 2 BLOCK_RECORD 5 {own} 330 0 100 AcDbSymbolTable 70 2"));
        for (name, number) in [("*Model_Space", handle::MODEL), ("*Paper_Space", handle::PAPER)] {
            self.pairs(&format!("0 BLOCK_RECORD 5 {number} 330 {own} 100 AcDbSymbolTableRecord"));
            self.pairs(&format!("100 AcDbBlockTableRecord 2 {name}"));
        }
        self.pairs("0 ENDTAB");
    }

    fn block(&mut self, name: &str, record: &str, of_paper: &str) {
        self.pair(0, "BLOCK");
        self.next_handle();
        self.pairs(&format!("330 {record} 100 AcDbEntity {of_paper} 8 0 100 AcDbBlockBegin"));
        self.pairs(&format!("2 {name} 70 0 10 0.0 20 0.0 30 0.0 3 {name} 1 _ 0 ENDBLK"));
        self.next_handle();
        self.pairs(&format!("330 {record} 100 AcDbEntity {of_paper} 8 0 100 AcDbBlockEnd"));
    }

    fn r12(&mut self, drawing: &Drawing) {
        self.header("AC1009", drawing);
        self.pairs("0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LTYPE 70 1");
        self.pair(0, "LTYPE");
        self.pairs("2 CONTINUOUS 70 0");
        self.pair(3, "Solid line");
        self.pairs("72 65 73 0 40 0.0 0 ENDTAB");
        let layers = self.all_layers();
        self.pairs(&format!("0 TABLE 2 LAYER 70 {}", layers.len()));
        for (name, colour) in layers {
            self.pairs(&format!("0 LAYER 2 {name} 70 0 62 {colour} 6 CONTINUOUS"));
        }
        self.pairs("0 ENDTAB 0 TABLE 2 STYLE 70 1 0 STYLE 2 STANDARD 70 0 40 0.0 41 1.0 50 0.0");
        self.pairs("71 0 42 2.5 3 txt 4 _ 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS 0 ENDSEC");
        self.pairs("0 SECTION 2 ENTITIES");
        for line in &drawing.lines {
            let (layer, closed) = (self.layer(line), u8::from(line.closed));
            self.pairs(&format!("0 POLYLINE 8 {layer} 66 1 10 0.0 20 0.0 30 0.0 70 {closed}"));
            for &[x, y] in &line.points {
                self.pairs(&format!("0 VERTEX 8 {layer} 10 {} 20 {} 30 0.0", six(x), six(y)));
            }
            self.pairs(&format!("0 SEQEND 8 {layer}"));
        }
        self.pairs("0 ENDSEC 0 EOF");
    }
}
