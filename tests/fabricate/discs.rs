//! Node discs on sheets, in tables and in words, and those that cannot be made. That they go together
//! with the fins is in `assembly`.

use super::identities::revolution;
use super::{build, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::{Build, BuildFile};
use shape_up::math::plane::distance;
use shape_up::scene::{BuildSettings, OffsetKind, Product};

fn settings() -> BuildSettings {
    BuildSettings {
        product: Product::Fins,
        kind: Some(OffsetKind::Face),
        distance: Some(0.2),
        scale: 10.0,
        thickness: 3.0,
        sheet: [600.0, 400.0],
        disc: None,
        ..BuildSettings::default()
    }
}

#[test]
fn discs_are_on_the_sheets_in_a_table_in_words_and_in_space() {
    let made = build(&revolution(5, 4), &settings());
    let (edges, nodes) = (made.surface.edges.len(), 30);
    let report = made.report();
    assert_eq!((report.placed, report.parts), (edges + nodes, edges + nodes));
    assert_eq!(report.holes, 0, "slots are no drilled holes");
    let words = made.words(&report).sheets;
    assert!(words.starts_with("49 fins and 30 node discs on "), "{words}");
    let page = made.report_page(&shape_up::fabricate::ReportView {
        title: String::new(),
        z_up: true,
        camera: None,
        link: String::new(),
    });
    assert!(page.contains("<dt>Parts on sheets</dt><dd>49 fins and 30 node discs</dd>"));
    let table = text_of(&made, "discs.csv");
    let slots = table.lines().skip(1).map(|row| row.split(',').nth(2).unwrap().parse::<usize>());
    assert_eq!(slots.map(Result::unwrap).sum::<usize>(), 2 * edges);
    assert_eq!(table.lines().count(), 1 + nodes);
    assert!(text_of(&made, "summary.csv").contains("\r\nnode discs,30,\r\n"));
    assert!(text_of(&made, "summary.csv").contains("\r\nNode discs (disc),,mm\r\n"));
    let slots = "\r\nhow to read names at slots of discs,";
    assert!(text_of(&made, "summary.csv").contains(slots));
    let files = made.files(true);
    assert!(files.iter().all(|file| BuildFile::is_name_of_one(&file.name)));
    let plates = text_of(&made, "plates.obj");
    assert_eq!(plates.lines().filter(|line| line.starts_with("g B")).count(), edges);
    assert_eq!(plates.lines().filter(|line| line.starts_with("g N")).count(), nodes);
    let layers: Vec<String> = made.spatial_parts(true).into_iter().map(|part| part.layer).collect();
    let count = |name: &str| layers.iter().filter(|layer| *layer == name).count();
    assert_eq!((count("Fins"), count("Discs")), (edges, nodes));
}

#[test]
fn every_plate_in_space_is_closed_and_has_the_volume_of_its_part() {
    let made = build(&revolution(5, 4), &settings());
    let solids = made.spatial_parts(true);
    let mut compared = 0;
    for part in solids.iter().filter(|part| part.layer == "Fins" || part.layer == "Discs") {
        let mut sides: Vec<[u32; 2]> = Vec::new();
        let mut volume = 0.0;
        let at = |v: u32| shape_up::math::Vec3::from(part.points[v as usize]);
        for face in &part.faces {
            sides.extend((0..face.len()).map(|k| [face[k], face[(k + 1) % face.len()]]));
            for k in 2..face.len() {
                let [a, b, c] = [0, k - 1, k].map(|k| at(face[k]) - at(part.faces[0][0]));
                volume += a.dot(b.cross(c)) / 6.0;
            }
        }
        sides.sort();
        assert!(sides.windows(2).all(|two| two[0] != two[1]), "{}", part.name);
        assert!(sides.iter().all(|&[a, b]| sides.binary_search(&[b, a]).is_ok()), "{}", part.name);
        let cut = made.parts.iter().find(|cut| cut.name == part.name).unwrap();
        let area = shape_up::math::plane::area;
        let slots: f64 = cut.holes.iter().map(|hole| area(&hole.outline())).sum();
        // In mm at 1:10.
        let expected = 3.0 * (area(&cut.outline) - slots);
        assert!((volume * 1e6 - expected).abs() < 1e-6 * expected, "{} {volume}", part.name);
        compared += 1;
    }
    assert_eq!(compared, made.parts.len());
}

#[test]
fn a_fin_that_is_not_cut_and_a_disc_that_is_on_no_sheet_do_not_count() {
    // The clearance and half the thickness at both ends leave 0.005 mm of the fins across the gap.
    let own = settings();
    let gap = (3.0 + 2.0 * own.clearance + 0.005) / 100.0;
    let at = [0.0, 1.0, 2.0, 2.0 + gap, 3.0 + gap];
    let made = build(&grid(4, 2, |i, j| [at[i as usize], f64::from(j), 0.0]), &own);
    let small: Vec<_> = made.not_cut.iter().filter(|not| not.part.starts_with('B')).collect();
    assert!(!small.is_empty() && small.iter().all(|not| not.why.contains("mm")), "{small:?}");
    let (plates, parts) = (text_of(&made, "plates.obj"), &made.parts);
    let mut groups = plates.lines().filter_map(|line| line.strip_prefix("g "));
    assert!(groups.all(|name| parts.iter().any(|part| part.name == name)), "{:?}", made.not_cut);
    // Higher than fins, which are 20 mm.
    let low = BuildSettings { disc: Some(31.0), sheet: [600.0, 40.0], ..own };
    let made = build(&revolution(5, 4), &low);
    assert_eq!(made.report().too_large.len(), made.discs.len());
    assert!(text_of(&made, "summary.csv").contains("\r\nnode discs,0,\r\n"));
}

#[test]
fn a_slot_is_wider_than_the_plate_by_the_clearance_and_narrower_by_the_kerf() {
    for (clearance, kerf) in [(0.1, 0.0), (0.0, 0.2), (0.25, 0.5)] {
        let made = build(&revolution(5, 4), &BuildSettings { clearance, kerf, ..settings() });
        for own in &made.discs {
            let part = &made.parts[own.part];
            for hole in &part.holes {
                let slot = hole.outline();
                let wide = distance(slot[1], slot[2]);
                assert!((wide - (3.0 + 2.0 * clearance - kerf)).abs() < 1e-6, "{wide}");
            }
        }
    }
}

#[test]
fn a_diameter_that_is_given_is_that_of_all_discs_and_by_default_there_are_none() {
    let made = build(&revolution(5, 4), &BuildSettings { disc: Some(31.0), ..settings() });
    let frame = made.frame.as_ref().unwrap();
    assert!(frame.discs.iter().flatten().all(|disc| disc.as_ref().unwrap().radius == 0.155));
    let plain = build(&revolution(5, 4), &BuildSettings { disc: Some(0.0), ..settings() });
    assert_eq!(BuildSettings::default().disc, Some(0.0));
    let names: Vec<String> = plain.files(true).into_iter().map(|file| file.name).collect();
    assert!(!names.iter().any(|name| name == "discs.csv" || name == "plates.obj"), "{names:?}");
    assert!(plain.parts.iter().all(|part| part.outline.len() == 4));
}

#[test]
fn discs_that_cannot_be_made_are_named_with_the_reason() {
    let why = |own: BuildSettings| {
        let mut found: Vec<&str> =
            build(&revolution(5, 4), &own).not_cut.iter().map(|not| not.why).collect();
        found.sort();
        found.dedup();
        found
    };
    assert_eq!(why(settings()), [""; 0]);
    let disc = |mm| BuildSettings { disc: Some(mm), ..settings() };
    assert_eq!(why(disc(15.0)), ["its slots need a larger disc"]);
    assert!(why(disc(200.0)).contains(&"a fin is too short for its seat"));
    assert_eq!(
        why(disc(45.0)),
        ["a fin is too short for its seat and that of the next disc"],
        "beside discs that are made"
    );
    let low = BuildSettings { distance: Some(0.01), ..settings() };
    assert_eq!(why(low), ["its fins are too low for a seat there"]);
}

#[test]
fn material_that_is_too_thin_for_slots_gets_none_and_the_report_says_so() {
    for own in
        [BuildSettings { kerf: 3.2, ..settings() }, BuildSettings { thickness: 0.0, ..settings() }]
    {
        let made = build(&revolution(5, 4), &own);
        assert!(made.discs.is_empty() && made.parts.iter().all(|part| part.outline.len() == 4));
        let problems = made.card().problems;
        assert!(problems.iter().any(|words| words.contains("slots of node discs")), "{problems:?}");
    }
}

#[test]
fn a_disc_that_would_meet_something_of_another_part_of_the_surface_is_refused() {
    let mut mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let above = grid(2, 2, |i, j| [f64::from(i) + 0.02, f64::from(j) + 0.03, 0.05]);
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(&above.positions);
    for face in above.faces.iter() {
        mesh.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
    }
    let made = build(&mesh, &settings());
    let lower = made.not_cut.iter().filter(|not| not.why == "it would meet a fin of other nodes");
    assert!(lower.count() >= 9, "{:?}", made.not_cut);
    assert_eq!(made.discs.len() + made.not_cut.len(), 18);
}

#[test]
fn holes_at_the_ends_and_names_of_nodes_stay_beside_seats() {
    let own = BuildSettings { hole: 2.0, scale: 8.0, ..settings() };
    let report = build(&revolution(5, 4), &own).report();
    assert_eq!((report.holes, report.left_out.dropped_holes), (2 * 49, 0));
    // With reliefs for the tool too, each fin names its nodes.
    let milled = BuildSettings { tool: 1.5, kerf: 1.5, gap: 5.0, ..own };
    let made = build(&revolution(5, 4), &milled);
    assert_eq!(made.left_out.dropped_reliefs, 0);
    for part in made.parts.iter().filter(|part| part.name.starts_with('B')) {
        assert!(part.outline.len() > 12, "{}", part.name);
    }
    let plain = build(&revolution(5, 4), &BuildSettings { tool: 0.0, ..milled });
    let names = |made: &Build| -> Vec<usize> {
        let fins = made.parts.iter().filter(|part| part.name.starts_with('B'));
        fins.map(|part| part.engraved.len()).collect()
    };
    assert_eq!(names(&made), names(&plain));
}
