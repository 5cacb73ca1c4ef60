//! The picture that the build inserts into the page.

use shape_up::example::EXAMPLES;
use std::process::Command;

fn picture(name: &str) -> String {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let program = env!("CARGO_BIN_EXE_first-picture");
    let done = Command::new(program).arg(&file).status().expect("the program starts");
    assert!(done.success());
    std::fs::read_to_string(file).expect("it wrote its file")
}

/// Numbers of an attribute.
fn attribute(html: &str, name: &str) -> Vec<f64> {
    let text = html.split(&format!("{name}=\"")).nth(1).expect("it is there");
    let numbers = text.split('"').next().expect("it has an end");
    numbers.split(' ').map(|number| number.parse().expect("a number")).collect()
}

#[test]
fn it_shows_every_panel_and_every_handle_of_the_first_example() {
    let html = picture("first.html");
    let (scene, mesh) = EXAMPLES[0].build();
    let pictures: Vec<&str> = html.split("<svg ").skip(1).collect();
    assert_eq!(pictures.len(), 2);
    for (svg, size) in pictures.iter().zip(["0 0 884 832", "0 0 390 667"]) {
        assert!(svg.contains(&format!(r#"viewBox="{size}""#)));
        assert_eq!(svg.matches("<path color=").count(), mesh.faces.len());
        let fixed: usize = scene
            .handles
            .iter()
            .filter(|handle| handle.targets.is_none())
            .map(|handle| handle.vertices.len())
            .sum();
        assert_eq!(svg.matches(r#"<rect class="fixed""#).count(), fixed);
        assert_eq!(svg.matches(r#"<circle class="handle""#).count(), 1);
        assert_eq!(svg.matches(r#"<path class="pull""#).count(), 1);
        // The circles of the panels, two arcs each.
        assert_eq!(svg.matches(" 1 0 ").count(), 2 * mesh.faces.len());
        // Data for the script that moves the picture.
        assert_eq!(svg.matches("<g data-vertex=").count(), fixed + 1);
        assert_eq!(attribute(svg, "data-eye").len(), 12);
        for number in ["NaN", "inf", "e-", "e+"] {
            assert!(!svg.contains(number), "{number} is no place");
        }
    }
    let mut faces = attribute(&html, "data-faces");
    faces.sort_by(f64::total_cmp);
    assert!(faces.iter().zip(0..).all(|(&face, place)| face == f64::from(place)));
    assert_eq!(faces.len(), mesh.faces.len());
    // Both themes, without a script.
    assert!(html.contains("light-dark("));
    assert!(!html.contains("<script"));
}

#[test]
fn it_is_the_same_every_time() {
    assert_eq!(picture("again.html"), picture("and-again.html"));
}

#[test]
fn without_a_place_to_write_to_it_says_how_it_is_used() {
    let program = env!("CARGO_BIN_EXE_first-picture");
    let done = Command::new(program).output().expect("the program starts");
    assert!(!done.status.success());
    assert!(String::from_utf8_lossy(&done.stderr).contains("first-picture FILE"));
}
