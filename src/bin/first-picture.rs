//! `first-picture FILE`: writes the placeholder of the 3D view as a piece of HTML: the first
//! example, solved and drawn as the view will show it. A step of the build, not for users.

mod pictures;

use glam::Vec2;
use shape_up::constraint::Fitted;
use shape_up::example::EXAMPLES;
use shape_up::session::Session;
use shape_up::view::svg::picture as still;
use std::error::Error;

/// The sizes of the 3D view in CSS pixels for which there is a picture: in a window of 1440 by 900
/// and on a phone of 390 by 844. The style sheet selects one by the width of the window.
const SIZES: [(&str, Vec2); 2] =
    [("wide", Vec2::new(884.0, 832.0)), ("narrow", Vec2::new(390.0, 667.0))];

fn main() -> Result<(), Box<dyn Error>> {
    let [_, file] = <[String; 2]>::try_from(std::env::args().collect::<Vec<_>>())
        .map_err(|_| "usage: first-picture FILE")?;
    let (scene, mesh) = EXAMPLES[0].build();
    let mut session = Session::open(scene, mesh)?;
    // As on the page, the range of colours is that of the start.
    let greatest = pictures::greatest(&pictures::values(&session));
    session.solve(false)?;
    if !session.exact().is_some_and(|exact| exact.met) {
        return Err("the page says that the first example is exact: it has to be".into());
    }
    let mut state = pictures::state(&session)?;
    let scale = pictures::scale(&session, greatest);
    state.set_face_values(pictures::values(&session), scale)?;
    let shapes = session.solver().fitted();
    let numbers: Vec<f64> = shapes.iter().flat_map(Fitted::numbers).collect();
    state.set_shapes(&numbers)?;
    let style = still::style(state.appearance().has_full_map());
    let faces = still::spaced(still::from_far_to_near(&state));
    let mut html = format!(
        r#"<div id="first-picture" aria-hidden="true" data-faces="{faces}"><style>{style}</style>"#
    );
    for (class, canvas) in SIZES {
        state.resize(canvas);
        html += &still::svg(&state, class);
    }
    html += "</div>";
    Ok(std::fs::write(file, html)?)
}
