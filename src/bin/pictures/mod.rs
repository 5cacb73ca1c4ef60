//! View states of sessions, for the programs of the build that draw examples.

use shape_up::scene::Hold;
use shape_up::session::Session;
use shape_up::view::appearance::{ColourScale, RowColours};
use shape_up::view::camera::UpAxis;
use shape_up::view::model::ViewError;
use shape_up::view::state::ViewState;

/// Returns the view of a scene as the page opens it: handles, and faces coloured by the measure of
/// the first row of constraints or, if it has none, by row.
pub(crate) fn state(session: &Session) -> Result<ViewState, ViewError> {
    let mesh = session.mesh();
    let lists = |rows: &shape_up::mesh::Ragged| (rows.offsets().to_vec(), rows.indices().to_vec());
    let positions = session.positions();
    let mut state = ViewState::default();
    state.set_up(match session.document().up {
        shape_up::scene::Up::Z => UpAxis::Z,
        shape_up::scene::Up::Y => UpAxis::Y,
    });
    state.set_mesh(lists(&mesh.faces), lists(&mesh.curves), positions.as_flattened())?;

    let values = values(session);
    let scale = scale(session, greatest(&values));
    state.set_face_values(values, scale)?;
    if !state.appearance().has_values() {
        state.set_row_colours(row_colours(session)?);
    }

    let handles = session.solver().handles();
    let vertices: Vec<u32> = handles.iter().map(|handle| handle.vertex).collect();
    let states: Vec<u8> =
        handles.iter().map(|handle| u8::from(handle.hold == Hold::Fixed)).collect();
    let targets: Vec<f64> = handles.iter().flat_map(|handle| handle.target).collect();
    state.set_handles(&vertices, &states, &targets)?;
    Ok(state)
}

/// Returns the colour scale of the page (`www/viewport/colour-scale.js`): faces within the
/// tolerance keep the material, and the range ends at a round number of at least `greatest`.
pub(crate) fn scale(session: &Session, greatest: f32) -> ColourScale {
    let tolerance = session.tolerance() as f32;
    let high = round_up(greatest.max(2.0 * tolerance));
    ColourScale { tolerance: Some(tolerance), ..ColourScale::linear(tolerance, high) }
}

/// Equivalent of `roundUp` in `www/ui/plot/value-axis.js`.
fn round_up(value: f32) -> f32 {
    let power = 10_f64.powi(f64::from(value).log10().floor() as i32);
    let round = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0].map(|round| round * power);
    let enough = round.into_iter().find(|&round| round >= f64::from(value) * (1.0 - 1e-9));
    enough.map_or(value, |round| round as f32)
}

/// Returns the error of each face in the measure of the first row of constraints that has one.
pub(crate) fn values(session: &Session) -> Option<Vec<f32>> {
    let measures = session.measures();
    let rows = (0..).zip(session.rows()).filter(|(_, row)| row.enabled);
    let values = match rows.filter_map(|(index, _)| session.required_measure(index)).next()? {
        "circularity" => measures.circularity_distances.clone(),
        _ => measures.planarity_distances.clone(),
    };
    Some(values.iter().map(|&value| value as f32).collect())
}

/// Returns the largest value, or 0.
pub(crate) fn greatest(values: &Option<Vec<f32>>) -> f32 {
    values.iter().flatten().copied().fold(0.0, f32::max)
}

/// Returns the colours of the rows of constraints on each face, and on vertices outside of these.
fn row_colours(session: &Session) -> Result<RowColours, ViewError> {
    let acting = session.acting_rows();
    let place = |row: u32| u8::try_from(row + 1).expect("an example has few rows");
    let places = |rows: &[Option<u32>]| rows.iter().map(|row| row.map_or(0, place)).collect();
    let colours = session.rows().iter().map(|row| row.constraints.kind.info().colour);
    let palette: Vec<f32> = colours.flatten().map(|part| f32::from(part) / 255.0).collect();
    let mesh = session.mesh();
    let counts = (mesh.positions.len(), mesh.faces.len());
    RowColours::new(places(&acting.faces), places(&acting.vertices), &palette, counts)
}
