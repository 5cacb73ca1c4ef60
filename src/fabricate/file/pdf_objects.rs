//! The objects of a PDF file, numbered from one. The first is the catalogue.

/// PDF points per mm.
pub(in crate::fabricate) const POINTS: f64 = 72.0 / 25.4;

/// Makes a stream object, such as the content of a page.
pub(in crate::fabricate) fn stream(text: &str) -> String {
    format!("<< /Length {} >>\nstream\n{text}\nendstream", text.len())
}

/// The file, with the cross-reference table of the objects.
pub(in crate::fabricate) fn assembled(objects: &[String]) -> String {
    let mut file = "%PDF-1.5\n".to_owned();
    let mut starts = Vec::new();
    for (object, number) in objects.iter().zip(1..) {
        starts.push(file.len());
        file += &format!("{number} 0 obj\n{object}\nendobj\n");
    }
    let table = file.len();
    let count = objects.len() + 1;
    file += &format!("xref\n0 {count}\n0000000000 65535 f \n");
    for start in starts {
        file += &format!("{start:010} 00000 n \n");
    }
    file + &format!("trailer\n<< /Size {count} /Root 1 0 R >>\nstartxref\n{table}\n%%EOF\n")
}
