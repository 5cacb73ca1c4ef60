//! The pictures of sheets on the page: the same lines as in the files, in few paths.

use super::build;
use super::identities::revolution;
use shape_up::fabricate::file::{picture, svg};
use shape_up::fabricate::sheet::Role;
use shape_up::scene::BuildSettings;

/// Half of the resolution of a picture, in mm.
const ROUNDING: f64 = 0.005 + 1e-9;

/// Lines of a path, in mm with y down, and the number of closed ones.
fn lines(path: &str) -> (Vec<Vec<[f64; 2]>>, usize) {
    let mut lines: Vec<Vec<[f64; 2]>> = Vec::new();
    for own in path.split('M').skip(1) {
        let mut at = [0.0; 2];
        let mut points = Vec::new();
        for step in own.trim_end_matches('Z').split('l') {
            let step: Vec<f64> = step.split(',').map(|x| x.parse().unwrap()).collect();
            (0..2).for_each(|x| at[x] += 0.01 * step[x]);
            points.push(at);
        }
        lines.push(points);
    }
    (lines, path.matches('Z').count())
}

#[test]
fn a_picture_has_the_lines_of_its_drawing_to_a_hundredth_of_a_millimetre() {
    let settings = BuildSettings {
        joint: 0.01,
        scale: 10.0,
        sheet: [300.0, 200.0],
        ..BuildSettings::default()
    };
    for drawing in build(&revolution(9, 7), &settings).drawings() {
        let found = picture(&drawing, &[]);
        assert_eq!(found.size, [30_000, 20_000]);
        let cut = (found.outlines.concat(), Role::Cut);
        let layers = found.layers.iter().map(|layer| {
            let role = Role::ALL.into_iter().find(|role| role.layer() == layer.name);
            (layer.path.clone(), role.unwrap())
        });
        let mut count = 0;
        for (path, role) in layers.chain([cut]) {
            let (lines, closed) = lines(&path);
            let drawn: Vec<_> = drawing.lines.iter().filter(|line| line.role == role).collect();
            assert_eq!(lines.len(), drawn.len(), "{role:?}");
            assert_eq!(closed, drawn.iter().filter(|line| line.closed).count());
            count += drawn.len();
            for (points, drawn) in lines.iter().zip(drawn) {
                assert_eq!(points.len(), drawn.points.len());
                for (&[x, y], &[a, b]) in points.iter().zip(&drawn.points) {
                    let error = (x - a).abs().max((y - (200.0 - b)).abs());
                    assert!(error < ROUNDING, "{role:?}: {error} mm off");
                }
            }
        }
        assert_eq!(count, drawing.lines.len(), "no line is left out");
        assert_eq!(found.outlines.len(), found.panels.len());
        // Each outline belongs to the part of this name.
        let named = drawing.lines.iter().filter(|line| line.role == Role::Cut);
        assert_eq!(found.parts, named.map(|line| line.part.clone()).collect::<Vec<_>>());
        let letters = found.layers.iter().map(|layer| layer.path.len()).sum::<usize>();
        assert!(2 * letters < svg(&drawing).len(), "{letters} letters are many");
    }
}
