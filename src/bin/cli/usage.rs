//! The usage text.

use shape_up::constraint::KINDS;
use shape_up::fabricate::{PARTS, PRESENTATION};
use shape_up::generate::NEW_KINDS;
use shape_up::mesh::{FileFormat, MESH_OPERATIONS, Scheme, Size};
use shape_up::scene::{
    Accelerator, BUILD_PRESETS, BUILD_SETTINGS, BuildForm, BuildSetting, BuildUnit, NamedEnum,
    PresetOf,
};
use shape_up::solve::{ConformalNorm, ConformalWeights};
use shape_up::words::UNITS;

/// Returns the usage text.
pub(super) fn usage() -> String {
    let meshes = format!(".{}", FileFormat::written_meshes().join("|."));
    format!(
        "\
usage: shape-up solve SCENE|MESH [--panels KIND] [--exact | --within LENGTH|auto]
                [--improve] [--boundary exact|WEIGHT] [--iterations N] [--tolerance T]
                [--accelerator {}]
                [--out FILE{meshes}] [--report FILE.json] [--trace]
       shape-up watch SCENE|MESH|FOLDER --out FILE|FOLDER [options of solve]
       shape-up build SCENE|MESH [--SETTING VALUE ...] [--sheet WxH|a3]
                [--machine {}] [--units {}]
                [--out DIR] [--report FILE.json] [--report-page FILE.html [--link URL]]
       shape-up refine SCENE|MESH [--scheme {}] [--levels N]
                [--keep DEGREES] [--panels KIND] [--adopt]
                [--out FILE{meshes}|.json] [--report FILE.json]
       shape-up remesh MESH [--quads N | --size LENGTH] [--follow 0..1] [--even 0..1]
                [--crease DEGREES] [--boundary follow|cut]
                [--out FILE{meshes}] [--report FILE.json]
       shape-up edit SCENE|MESH OPERATION [--SIZE VALUE ...] [--vertices LIST] [--faces LIST]
                [--out FILE{meshes}|.json]
       shape-up check MESH [--report FILE.json]
       shape-up check RESULTS --scene SCENE
       shape-up check FOLDER [--scene SCENE] [--csv FILE.csv]
       shape-up new KIND [--SIZE VALUE ...] [--units UNIT] [--out FILE{meshes}]
       shape-up new plan PLAN.json [--units UNIT] [--out FILE{meshes}]
       shape-up new loft|fill MESH [--curves N[,N]] [--size LENGTH] [--units UNIT]
                [--out FILE{meshes}]
       shape-up parametrize MESH [--weights {}] [--norm {}]
                [--out UV.obj] [--report FILE.json]
       shape-up examples [--out DIR]
       shape-up experiment [EXAMPLE|SCENE] [--iterations N] [--seconds T]
                [--csv FILE.csv] [--svg FILE.svg]
       shape-up operators
       shape-up --help | --version

A SCENE is a *.json file, a MESH has one of the formats below that are read.
--panels puts a KIND of constraint on every face that it fits. The kinds are:
 {}
--exact meets all constraints exactly instead of weighing them; --within meets them up to a LENGTH in
the unit of the mesh. --within auto does what the button \"Make panels\" of the page does: within the
tolerance of the mesh, in several attempts if faces fold or the design changes. Otherwise each constraint
of the scene keeps its own requirement. --improve then looks for a shape with less energy that meets them
too.
--boundary exact keeps boundary vertices on their curve, along which they glide, and fixes its corners;
a WEIGHT keeps them near it.
A MESH is solved with settings that preserve its shape, a scene with its own.
--iterations, --tolerance (0 never stops early) and --accelerator replace the settings of the scene.
--out writes the format that the name ends in, OBJ without an ending; only Medit can store tetrahedra.
--trace records the energies of every iteration, in the report and on standard output.
watch solves again whenever the file is saved, until it is stopped: the program that reads --out then has
the shape of what it saved. Of a FOLDER each mesh that is saved there is solved, into a file of its name
in another folder, with .obj after it if its format is only read.
build lays panels, fins along the edges, or a paper model of strips or nets flat on sheets, and checks
whether offsets and beams can be built; --out is the folder for drawings of the sheets (SVG, DXF, PDF),
of where each part goes (key-*.svg, key.pdf), tables (CSV), a presentation ({}), and the panels by
name (panels.obj) or, with fins, the beams as solids (beams.obj).
--splice cuts panels that are larger than the sheet into pieces, with plates of that width behind their
seams. --disc makes a plate for each node that the fins there are pushed into, on tenons; plates.obj has
all as assembled. --one-file-each draws each part by itself too, in the folder {}/.
Settings that are not given are those of `build` in the scene. Lengths are in MM on the sheet or, where
it says so, at full size; a LENGTH is in the unit of the mesh (--units; else that of the file, or
guessed from its size). Settings of build:
{}
--sheet is the width and height of a sheet in mm, or one of
{}.
--machine sets kerf, tool and gap. --material also sets the thickness if it is one of
{}.
--report-page writes a report as a web page that prints on A4: picture, plan, build check, bill of
materials, and the --link.
refine divides each face into several, N times; the boundary is refined as a curve of its own, and
creases and corners that turn by more than DEGREES (75) stay sharp. With --panels it solves before the
first level and after each; with --adopt the shape of each level is the original of the next, which stays
close to it: faster and smoother, but farther from the input. The scene is adapted: --out writes the mesh,
or the scene with its mesh if the name ends in .json.
remesh covers a surface, of triangles or any polygons, with quads along its lines of curvature, which
can become circular panels with a small move: N panels (500), or panels with sides of a LENGTH. --follow
trades few irregular vertices (0) for a small move (1), --even a small move (0) for even panels (1); by
default 0.67 and 0.25. Creases that turn by more than DEGREES (40) are lines of the panels; 180 follows
none. Panels follow the boundary or are cut at it: by default, what moves less. Details smaller than a
panel are named.
edit changes the faces of a mesh, and adapts the scene. A LIST is like 0-4,7, counted from 0, of a file
that is welded as in the welded mesh; a length is in the unit of the mesh. Operations and their defaults,
with lengths in mean edge lengths:
{}
RESULTS is the file that a student hands in for a lesson: check measures its shape against the goals
and constraints of the SCENE, and exits with 1 if a goal is not met, or a locked part was altered. For a
FOLDER of such files it writes a table: goals met, worst distance, moved, and whether the mesh or a locked
setting was altered; it exits with 1 if a file is unreadable. The scene may be in the folder.
new makes a mesh to start from, with lengths in the UNIT (m). Kinds and their defaults:
{}
new plan makes a surface over an outline on the ground. PLAN.json has the keys outline, a list of points
{{\"at\": [X, Y], \"bulge\": RISE/HALF_CHORD, \"corner\": true|false}}; holes, a list of such lists; layout,
follow|cut; size, of a panel; turn, of a cut grid in degrees; height; and stands, the supports:
outline|corners.
new loft makes a surface between two curves of a file, new fill one inside a closed curve. Curves are the
polylines of the file, then the boundaries of its faces, then what several polylines close together,
counted from 0 (default 0,1, or the first closed one). By default a panel has a twentieth of the length
of the first curve, and the unit is that of the file.
parametrize makes a flat map that preserves angles; --out writes the mesh with the map as its vt lines.
experiment solves a scene by several methods, and prints how far each came; --csv writes all iterations,
--svg plots them. Without a scene it lists the examples that have a comparison of the paper. Limits are
per method.
Formats of files:
{}
Exit code: 0 done, 1 error in the input, 2 usage error, 3 internal error.",
        Accelerator::list("|"),
        presets(PresetOf::Machine).join("|"),
        UNITS.map(|unit| unit.symbol).join("|"),
        Scheme::list("|"),
        ConformalWeights::list("|"),
        ConformalNorm::list("|"),
        kinds(),
        PRESENTATION,
        PARTS,
        build_settings(),
        presets(PresetOf::Sheet).join(", "),
        presets(PresetOf::Material).join(", "),
        operations(),
        new_kinds(),
        FileFormat::table(),
    )
}

/// The ids of the presets of Build.
fn presets(of: PresetOf) -> Vec<&'static str> {
    BUILD_PRESETS.iter().filter(|preset| preset.of == of).map(|preset| preset.id).collect()
}

/// Lists the settings of Build with their values and summaries, one per line.
fn build_settings() -> String {
    let line = |setting: &BuildSetting| {
        let option = format!("{} {}", setting.option()?, value_of(setting));
        Some(format!(" {:<34} {}", option.trim_end(), setting.summary))
    };
    BUILD_SETTINGS.iter().filter_map(line).collect::<Vec<_>>().join("\n")
}

/// The kind of value of a setting: `MM`, `LENGTH|auto`, `nets|strips|across`; empty for a switch.
fn value_of(setting: &BuildSetting) -> String {
    let value = match setting.form {
        BuildForm::Number { unit: BuildUnit::Plain, .. } => "N".to_owned(),
        BuildForm::Number { unit: BuildUnit::Mesh, .. } => "LENGTH".to_owned(),
        BuildForm::Number { unit: BuildUnit::Mm, .. } => "MM".to_owned(),
        BuildForm::Number { unit: BuildUnit::Degrees, .. } => "DEGREES".to_owned(),
        BuildForm::Choice { options } => {
            options.iter().map(|option| option.word).collect::<Vec<_>>().join("|")
        }
        BuildForm::Switch => String::new(),
        BuildForm::Text => "TEXT".to_owned(),
        BuildForm::Edges => "EDGES".to_owned(),
    };
    if setting.absent.is_empty() { value } else { value + "|auto" }
}

/// Lists the operations on meshes with their sizes, one per line.
fn operations() -> String {
    let lines = MESH_OPERATIONS.iter().map(|operation| line(operation.id, operation.sizes));
    lines.collect::<Vec<_>>().join("\n")
}

/// Lists the kinds of new meshes with their sizes, one per line.
fn new_kinds() -> String {
    let lines = NEW_KINDS.iter().map(|kind| line(kind.id, kind.sizes));
    lines.collect::<Vec<_>>().join("\n")
}

fn line(id: &str, sizes: &[Size]) -> String {
    let sizes = sizes.iter().map(|size| format!(" --{} {}", size.id, size.default));
    format!(" {id}{}", sizes.collect::<String>())
}

/// Lists the ids of the kinds of constraints, wrapped to lines.
fn kinds() -> String {
    const WIDTH: usize = 96;
    let mut lines = vec![String::new()];
    for info in KINDS {
        if lines[lines.len() - 1].len() + info.id.len() > WIDTH {
            lines.push(String::new());
        }
        let line = lines.last_mut().expect("there is a line");
        line.push(' ');
        line.push_str(info.id);
    }
    lines.join("\n ")
}
