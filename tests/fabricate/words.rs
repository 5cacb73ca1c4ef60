//! The report of a build in words.

use super::identities::revolution;
use super::{build, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::sheet::NamePlace;
use shape_up::fabricate::{BuildReport, CheckWords, PanelSuggestion};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, CheckLimits, Fold, Names, OffsetKind, Product};

/// Quads that are neither flat nor circular.
fn wavy() -> Mesh {
    grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.2 * f64::from((7 * i + 5 * j) % 4)])
}

#[test]
fn parts_on_sheets_are_counted_with_what_is_left_out() {
    let made = build(&wavy(), &BuildSettings::default());
    let report = made.report();
    let words = made.words(&report).sheets;
    let types = if report.types == 1 { "type" } else { "types" };
    assert!(words.starts_with("16 panels on 1 sheet, "), "{words}");
    assert!(words.ends_with(&format!(" % covered, {} {types} of panels", report.types)), "{words}");
    let names = |all: usize| (0..all).map(|k| format!("P{k}")).collect::<Vec<_>>();
    let bad = BuildReport {
        placed: 15,
        too_large: names(8),
        larger_sheet_mm: Some([470.0, 330.0]),
        unnamed: names(1),
        ..report
    };
    let words = made.words(&bad);
    assert!(words.sheets.starts_with("15 of 16 panels on 1 sheet, "), "{}", words.sheets);
    let large = "Larger than the sheet within its margins: P0, P1, P2, P3, P4, P5 and 2 more. They are left out, not scaled. A sheet of 470 x 330 mm has room for each of them.";
    assert_eq!(words.warnings[0], large);
    assert!(
        words.warnings.contains(&"1 panel has no room for a name: P0.".to_owned()),
        "{words:?}"
    );
}

#[test]
fn fins_and_paper_have_their_own_nouns() {
    for (product, noun, more) in [
        (Product::Fins, " fins on ", "of nodes within"),
        (Product::Paper, " piece on ", " % covered"),
    ] {
        let made = build(&wavy(), &BuildSettings { product, ..BuildSettings::default() });
        let words = made.words(&made.report());
        assert!(words.sheets.contains(noun) && words.sheets.contains(more), "{}", words.sheets);
        assert!(!words.sheets.contains(" 0 tabs"), "{}", words.sheets);
        assert!(words.joint.is_empty());
    }
}

#[test]
fn a_joint_is_needed_where_panels_of_a_thickness_would_collide() {
    let own = BuildSettings { thickness: 0.5, ..BuildSettings::default() };
    let made = build(&wavy(), &own);
    let joint = |least_joint_mm| {
        let report = BuildReport { least_joint_mm, ..made.report() };
        let words = made.words(&report);
        let advice = words.advice.into_iter().map(|advice| advice.words);
        let advised: Vec<String> = advice.filter(|words| words.contains("joint")).collect();
        // Said once: where it is wider than the present joint, with a button that sets it.
        assert_eq!(advised.is_empty(), least_joint_mm == [None, None]);
        words.joint + &advised.join("")
    };
    for (least, words) in [
        (
            [None, Some(0.3814)],
            "need no joint outside the surface, and a joint on the sheet of at least 0.381 mm inside.",
        ),
        (
            [Some(1.0), None],
            "need a joint on the sheet of at least 1.00 mm outside the surface, and no joint inside.",
        ),
        (
            [Some(1.0), Some(2.0)],
            "need a joint on the sheet of at least 1.00 mm outside the surface, and at least 2.00 mm inside.",
        ),
        ([None, None], "need no joint."),
    ] {
        let said = joint(least);
        assert!(said.starts_with(&format!("Panels of 0.5 mm {words}")), "{said}");
        let sides = [" outside between P", " inside between P"].map(|side| said.contains(side));
        assert_eq!(sides, least.map(|least| least.is_some()), "{said}");
    }
    let thin = build(&wavy(), &BuildSettings { thickness: 0.0, ..own });
    assert!(thin.words(&thin.report()).joint.is_empty());
}

#[test]
fn a_joint_that_is_enough_on_one_side_is_said_to_be_so_with_the_worst_edge_of_either() {
    // A ridge of 30 degrees between the first two of three panels, a valley of 60 between the last two.
    let [c, s] = shape_up::math::cosine_and_sine_of_degrees(30.0);
    let profile = [[-c, -s], [0.0, 0.0], [1.0, 0.0], [1.5, 0.75_f64.sqrt()]];
    let mesh = grid(3, 1, |i, j| [profile[i as usize][0], f64::from(j), profile[i as usize][1]]);
    let words = |joint: f64| {
        let own = BuildSettings { thickness: 3.0, joint, scale: 10.0, ..BuildSettings::default() };
        let made = build(&mesh, &own);
        let report = made.report();
        assert_eq!(report.least_joint_at, ["P1 and P2", "P0 and P1"]);
        made.words(&report)
    };
    // 2 T tan of half of the fold: 3.46 mm outside, 1.61 mm inside.
    let neither = words(0.01);
    assert!(neither.joint.is_empty() && neither.advice[0].choices.len() == 2, "{neither:?}");
    assert!(
        neither.advice[0].words.ends_with("P1 and P2, inside between P0 and P1."),
        "{neither:?}"
    );
    for (joint, end) in [(0.02, "is enough inside only."), (0.04, "is enough on both sides.")] {
        let said = words(joint);
        assert_eq!(said.advice, []);
        assert!(said.joint.contains("3.46 mm outside") && said.joint.ends_with(end), "{said:?}");
    }
}

#[test]
fn the_smallest_part_is_named_with_its_width_where_that_is_below_its_limit() {
    // The panel in the middle is 60 mm wide, and so 3 mm on the sheet.
    let x = [0.0, 1.0, 1.06, 2.0];
    let mesh = grid(3, 1, |i, j| [x[i as usize], f64::from(j), 0.0]);
    let made = |part: f64| {
        let limits = CheckLimits { part, ..CheckLimits::default() };
        let own = BuildSettings { scale: 20.0, limits, ..BuildSettings::default() };
        let made = build(&mesh, &own);
        let report = made.report();
        assert_eq!(report.smallest_part, "P1");
        let [length, width] = report.smallest_part_mm.unwrap();
        assert!((length - 50.0).abs() < 1e-9 && (width - 3.0).abs() < 1e-9);
        assert!(text_of(&made, "summary.csv").contains("\r\nsmallest part,P1,\r\n"));
        made.words(&report).warnings.concat()
    };
    let said = "Narrower than 3.5 mm on the sheet: P1. The smallest part is P1, 3.00 mm wide and 50.0 mm long.";
    assert!(made(3.5).contains(said), "{}", made(3.5));
    assert!(!made(2.9).contains("Narrower"));
}

#[test]
fn a_row_of_the_check_has_its_value_its_limit_and_whether_it_is_met() {
    let made = build(&wavy(), &BuildSettings::default());
    let card = made.card();
    let words = made.card_words(&card);
    assert_eq!(words, made.words(&made.report()).card);
    let at = |id: &str| card.check.iter().position(|row| row.id == id).unwrap();
    let CheckWords { value, limit, state, .. } = &words.check[at("panel_flatness")];
    assert!(value.ends_with(" mm") && limit.starts_with("≤ ") && limit.ends_with(" mm"));
    assert_eq!(state, &format!("not satisfied by {}", card.check[at("panel_flatness")].failed));
    for (row, said) in card.check.iter().zip(&words.check) {
        assert!(said.meaning.ends_with('.'), "{said:?}");
        assert_eq!(said.remedy.is_empty(), row.met != Some(false), "{said:?}");
    }
    let lean = &words.check[at("lean")];
    assert!(lean.value.ends_with('°') && lean.limit.ends_with('°'), "{lean:?}");
    let PanelSuggestion { constraint, .. } = card.tighten.suggestions[0];
    let adjective = if constraint == "circle" { "circular" } else { "flat" };
    let suggestion = format!("Makes all panels {adjective} within ");
    assert!(words.suggestions[0].starts_with(&suggestion), "{words:?}");
}

#[test]
fn an_offset_is_said_to_be_exact_or_why_it_is_not() {
    let own = BuildSettings {
        kind: Some(OffsetKind::Corner),
        distance: Some(0.2),
        ..BuildSettings::default()
    };
    let exact = build(&revolution(9, 7), &own);
    let words = exact.card_words(&exact.card());
    assert_eq!(words.offset, "Corners keep their distance exactly.");
    assert_eq!(words.distance, "200 mm");
    assert!(words.safe.starts_with("Safe ") && words.safe.contains(" inwards, "), "{words:?}");
    let fitted = build(&wavy(), &own);
    let words = fitted.card_words(&fitted.card());
    let start = "Corners keep their distance as nearly as possible; ";
    assert!(words.offset.starts_with(start) && words.offset.ends_with('.'), "{words:?}");
    let errors: Vec<String> = fitted.choices().iter().map(|choice| choice.words()).collect();
    assert!(errors.iter().all(|words| words == "exact" || words.starts_with("± ")), "{errors:?}");
}

#[test]
fn a_distance_inwards_is_compared_with_its_limit_as_it_is_met() {
    let own = |distance| BuildSettings {
        kind: Some(OffsetKind::Face),
        distance: Some(distance),
        ..BuildSettings::default()
    };
    for distance in [-0.05, 0.05] {
        let made = build(&revolution(9, 7), &own(distance));
        let card = made.card();
        let at = card.check.iter().position(|row| row.id == "safe_distance").unwrap();
        let Some(limit) = card.check[at].limit else { continue };
        assert!(distance > 0.0 || limit < 0.0);
        let words = &made.card_words(&card).check[at];
        let sign = if distance > 0.0 { "≤ " } else { "≥ " };
        assert!(words.limit.starts_with(sign), "{words:?}");
        assert_eq!(
            (&*words.value, &*words.state),
            (if distance > 0.0 { "50.0 mm" } else { "−50.0 mm" }, "satisfied")
        );
    }
}

#[test]
fn pieces_are_not_counted_with_panels_of_which_none_is_made() {
    let mut mesh = grid(2, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.positions.push([0.5, 0.0, 0.0]);
    mesh.faces.push(&[0, 6, 1]);
    let own = BuildSettings { product: Product::Paper, ..BuildSettings::default() };
    let made = build(&mesh, &own);
    let words = made.words(&made.report());
    assert!(words.sheets.starts_with("1 piece on 1 sheet"), "{}", words.sheets);
    assert!(words.warnings.contains(&"Not cut: P2: it has no area.".to_owned()), "{words:?}");
}

#[test]
fn no_joint_is_named_where_panels_meet_that_have_no_outside() {
    let made = build(&crate::support::grid::wall_on_floor(), &BuildSettings::default());
    let words = made.words(&made.report());
    assert!(!words.joint.contains("need no joint"), "{}", words.joint);
    assert!(words.joint.contains("more than two panels"), "{}", words.joint);
}

#[test]
fn the_joint_of_one_side_is_known_where_panels_lie_on_each_other_on_the_other_side() {
    // A square with a neighbour folded back onto it, one that goes up and one that goes down.
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let back = [[0.5, 0.0, 0.0], [0.5, 1.0, 0.0]];
    let (up, down) = ([[-1.0, 1.0, 0.5], [-1.0, 0.0, 0.5]], [[1.0, 2.0, -0.5], [0.0, 2.0, -0.5]]);
    let positions = [&square[..], &back, &up, &down].concat();
    let faces = [[0, 1, 2, 3], [2, 1, 4, 5], [0, 3, 6, 7], [3, 2, 8, 9]].into_iter().collect();
    let mesh = Mesh { positions, faces, ..Mesh::default() };
    let made = build(&mesh, &BuildSettings { thickness: 3.0, ..BuildSettings::default() });
    let report = made.report();
    let are_known = report.no_least_joint.map(str::is_empty);
    assert!(are_known[0] != are_known[1], "{report:?}");
    assert_eq!(report.least_joint_mm.map(|least| least.is_some()), are_known);
    let advice = made.words(&report).advice;
    assert_eq!(advice[0].choices.len(), 1);
    for words in ["at least", "(panels lie on each other)"] {
        assert!(advice[0].words.contains(words), "{advice:?}");
    }
}

#[test]
fn the_summary_says_how_to_read_the_tables_and_names_that_are_there() {
    let of = |own: BuildSettings| {
        let made = build(&revolution(5, 4), &own);
        let summary = text_of(&made, "summary.csv");
        let rows = summary.lines().filter_map(|row| row.strip_prefix("how to read "));
        let what: Vec<String> =
            rows.filter_map(|row| Some(row.split(',').next()?.to_owned())).collect();
        for table in what.iter().filter_map(|what| what.split_once(".csv ")) {
            let name = format!("{}.csv", table.0);
            let header = text_of(&made, &name);
            let mut columns = header.lines().next().unwrap().split(',');
            assert!(columns.any(|own| own == table.1), "{table:?}");
        }
        move |own: &str| what.iter().any(|what| what == own)
    };
    let panels = of(BuildSettings::default());
    assert!(panels("outlines") && panels("panels.csv turn_deg"));
    assert!(!panels("splices.csv pieces") && !panels("tabs") && !panels("names of fins"));
    let paper = BuildSettings { product: Product::Paper, ..BuildSettings::default() };
    let card = BuildSettings { fold: Fold::Score, thickness: 1.0, ..paper.clone() };
    let [paper, card] = [paper, card].map(of);
    assert!(paper("tabs") && paper("joins.csv fold") && !paper("outlines"));
    assert!(!card("tabs") && card("joins.csv fold"));
}

#[test]
fn names_lower_than_2_mm_are_not_engraved_but_counted_and_tabulated() {
    // Slivers too narrow for letters.
    let sliver = grid(3, 1, |i, j| [f64::from(i), 2e-3 * f64::from(j), 0.0]);
    let own = BuildSettings { scale: 50.0, ..BuildSettings::default() };
    let made = build(&sliver, &own);
    let report = made.report();
    assert_eq!((report.placed, report.left_out.small_names), (3, 3));
    assert_eq!(report.left_out.dropped_names, 4);
    assert!(made.parts.iter().all(|part| part.named != NamePlace::OnPart));
    let said = "3 parts have no room for letters of 2 mm; the tables say where each name is.";
    assert!(made.words(&report).warnings.contains(&said.to_owned()));
    let table = text_of(&made, "panels.csv");
    assert!(
        table.lines().skip(1).all(|row| row.contains(",beside it,") || row.contains(",nowhere,"))
    );
}

#[test]
fn beams_without_a_solid_are_counted_in_words() {
    let own = BuildSettings {
        product: Product::Fins,
        thickness: 0.0,
        beam_width: Some(3.0),
        ..BuildSettings::default()
    };
    let made = build(&super::beams::cube(), &own);
    let report = made.report();
    let without = report.frame.as_ref().unwrap().without_prism;
    assert!(without > 0);
    let words = made.words(&report).warnings;
    assert!(words.iter().any(|words| words.contains(&format!("{without} beams"))), "{words:?}");
}

#[test]
fn names_by_rows_where_there_is_no_grid_are_said_to_be_numbers() {
    let own = |names| BuildSettings { names, ..BuildSettings::default() };
    let said = |mesh: &Mesh, names| {
        let report = build(mesh, &own(names)).report();
        report.card.problems.iter().any(|words| words.contains("rows"))
    };
    assert!(said(&super::beams::cube(), Names::Rows));
    assert!(!said(&super::beams::cube(), Names::Index));
    assert!(!said(&wavy(), Names::Rows));
}
