//! `first-picture FILE`: writes what the page shows before it can draw, the first example as the
//! view will show it, as a piece of HTML. A step of the build, not for users.

use glam::Vec2;
use shape_up::scene::Hold;
use shape_up::scene::examples::EXAMPLES;
use shape_up::session::Session;
use shape_up::view::camera::Up;
use shape_up::view::lists::ViewError;
use shape_up::view::stage::Stage;
use shape_up::view::still;
use std::error::Error;

/// The sizes of the 3D view in CSS pixels for which there is a picture: in a window of 1440 by 900
/// and on a phone of 390 by 844. The style sheet shows the one for windows that wide.
const SIZES: [(&str, Vec2); 2] =
    [("wide", Vec2::new(884.0, 832.0)), ("narrow", Vec2::new(390.0, 667.0))];

fn main() -> Result<(), Box<dyn Error>> {
    let [_, file] = <[String; 2]>::try_from(std::env::args().collect::<Vec<_>>())
        .map_err(|_| "usage: first-picture FILE")?;
    let (scene, mesh) = EXAMPLES[0].build();
    let session = Session::open(scene, mesh)?;
    let mut stage = stage(&session)?;
    let style = still::style(stage.looks.has_values());
    let faces = still::spaced(still::from_far_to_near(&stage));
    let mut html = format!(
        r#"<div id="first-picture" aria-hidden="true" data-faces="{faces}"><style>{style}</style>"#
    );
    for (class, canvas) in SIZES {
        stage.resize(canvas);
        html += &still::svg(&stage, class);
    }
    html += "</div>";
    Ok(std::fs::write(file, html)?)
}

/// What the page shows of a scene when it is opened: faces in the colours of what the first row of
/// constraints asks of them, and the handles.
fn stage(session: &Session) -> Result<Stage, ViewError> {
    let mesh = session.mesh();
    let lists = |rows: &shape_up::mesh::Ragged| (rows.offsets().to_vec(), rows.indices().to_vec());
    let positions = session.positions();
    let mut stage = Stage::default();
    stage.set_up(match session.document().up {
        shape_up::scene::Up::Z => Up::Z,
        shape_up::scene::Up::Y => Up::Y,
    });
    stage.set_mesh(lists(&mesh.faces), lists(&mesh.curves), positions.as_flattened())?;

    let measures = session.measures();
    let rows = session.rows().iter().filter(|row| row.enabled);
    let values = match rows.filter_map(|row| row.constraints.kind.info().measure).next() {
        Some("circularity") => Some(measures.circularity_distances),
        Some(_) => Some(measures.planarity_distances),
        None => None,
    };
    let values = values.map(|values| values.iter().map(|&value| value as f32).collect::<Vec<_>>());
    let greatest = values.iter().flatten().copied().fold(0.0, f32::max);
    stage.looks.set_values(values, 0.0, greatest, mesh.faces.len())?;

    let handles = session.solver().handles();
    let vertices: Vec<u32> = handles.iter().map(|handle| handle.vertex).collect();
    let states: Vec<u8> =
        handles.iter().map(|handle| u8::from(handle.hold == Hold::Fixed)).collect();
    let targets: Vec<f64> = handles.iter().flat_map(|handle| handle.target).collect();
    stage.set_handles(&vertices, &states, &targets)?;
    Ok(stage)
}
