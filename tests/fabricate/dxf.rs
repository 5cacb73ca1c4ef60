//! A DXF reader for tests: pairs of a group code and a value. (The page's test reads DXF with the
//! npm package `dxf-parser`.)

/// A polyline of a drawing.
#[derive(Debug, Default)]
pub(crate) struct Polyline {
    pub(crate) layer: String,
    pub(crate) is_closed: bool,
    pub(crate) points: Vec<[f64; 2]>,
}

/// Pairs of a file; every line ends with CRLF.
fn pairs(text: &str) -> Vec<(u32, &str)> {
    let lines: Vec<&str> = text.strip_suffix("\r\n").unwrap().split("\r\n").collect();
    assert!(lines.iter().all(|line| !line.contains(['\r', '\n'])));
    lines.chunks(2).map(|pair| (pair[0].parse().expect("a group code"), pair[1])).collect()
}

/// Value of a header variable: its first pair.
pub(crate) fn variable(text: &str, name: &str) -> String {
    let pairs = pairs(text);
    let at = pairs.iter().position(|pair| *pair == (9, name)).expect("it is in the header");
    pairs[at + 1].1.to_owned()
}

/// Handles of all objects, if the version has handles.
pub(crate) fn handles(text: &str) -> Vec<String> {
    let own = pairs(text).into_iter().skip_while(|pair| *pair != (2, "TABLES"));
    own.filter(|(code, _)| *code == 5 || *code == 105).map(|(_, value)| value.to_owned()).collect()
}

/// All polylines.
pub(crate) fn polylines(text: &str) -> Vec<Polyline> {
    let mut all: Vec<Polyline> = Vec::new();
    let (mut kind, mut is_inside) = ("", false);
    for (code, value) in pairs(text) {
        if code == 2 {
            is_inside |= value == "ENTITIES";
        }
        if code == 0 {
            kind = value;
            is_inside &= value != "ENDSEC";
            if is_inside && matches!(value, "LWPOLYLINE" | "POLYLINE") {
                all.push(Polyline::default());
            }
        }
        let Some(own) = all.last_mut().filter(|_| is_inside) else { continue };
        let number = || value.parse::<f64>().expect("a number");
        match (kind, code) {
            ("LWPOLYLINE" | "POLYLINE", 8) => own.layer = value.to_owned(),
            ("LWPOLYLINE" | "POLYLINE", 70) => own.is_closed = value == "1",
            ("LWPOLYLINE" | "VERTEX", 10) => own.points.push([number(), f64::NAN]),
            ("LWPOLYLINE" | "VERTEX", 20) => {
                own.points.last_mut().expect("x is first")[1] = number();
            }
            _ => {}
        }
    }
    all
}
