//! The usage text.

use shape_up::begin::NEW_KINDS;
use shape_up::constraint::KINDS;
use shape_up::fabricate::{OffsetKind, Page, Pieces, Product};
use shape_up::mesh::{MESH_OPERATIONS, Scheme, Size};
use shape_up::scene::{Accelerator, NamedEnum};
use shape_up::solve::{ConformalNorm, ConformalWeights};

/// Returns the usage text.
pub(super) fn usage() -> String {
    format!(
        "\
usage: shape-up solve SCENE|MESH [--panels KIND] [--exact | --within LENGTH]
                [--improve] [--boundary exact|WEIGHT] [--iterations N] [--tolerance T]
                [--accelerator {}]
                [--out FILE.obj|FILE.mesh] [--report FILE.json] [--trace]
       shape-up build SCENE|MESH [--product {}] [--kind {}]
                [--distance D] [--joint J] [--scale S] [--material NAME]
                [--thickness T] [--sheet WxH] [--hole D] [--pieces {}]
                [--page {}] [--out DIR] [--report FILE.json]
                [--report-page FILE.pdf [--link URL]]
       shape-up refine SCENE|MESH [--scheme {}] [--levels N]
                [--keep DEGREES] [--panels KIND] [--adopt]
                [--out FILE.obj|FILE.mesh|FILE.json] [--report FILE.json]
       shape-up edit SCENE|MESH OPERATION [--SIZE VALUE ...] [--vertices LIST] [--faces LIST]
                [--out FILE.obj|FILE.mesh|FILE.json]
       shape-up check MESH [--report FILE.json]
       shape-up check RESULTS --scene SCENE
       shape-up check FOLDER [--scene SCENE] [--csv FILE.csv]
       shape-up new KIND [--SIZE VALUE ...] [--units UNIT] [--out FILE.obj]
       shape-up new plan PLAN.json [--units UNIT] [--out FILE.obj]
       shape-up new loft|fill MESH [--curves N[,N]] [--size LENGTH] [--units UNIT] [--out FILE.obj]
       shape-up parametrize MESH [--weights {}] [--norm {}]
                [--out UV.obj] [--report FILE.json]
       shape-up examples [--out DIR]
       shape-up experiment [EXAMPLE|SCENE] [--iterations N] [--seconds T] [--csv FILE.csv]
       shape-up operators
       shape-up --help | --version

A SCENE is a *.json file, a MESH is OBJ, OFF or Medit (.obj, .off, .mesh).
--panels asks for a KIND of shape on every face that can have it. The kinds are:
 {}
--exact meets all constraints instead of weighing them; --within meets them up to a LENGTH in the
unit of the mesh. Without, each constraint of a scene says itself what it is. --improve then looks for
a shape with less energy that meets them too.
--boundary exact holds boundary vertices on their curve, where they glide, and its corners; a WEIGHT
holds them near it.
A MESH is solved with the settings that keep it whole, a scene with its own.
--iterations, --tolerance (0 never stops early) and --accelerator replace the settings of the scene.
--out writes OBJ, or where the name ends in .mesh, Medit, which has tetrahedra.
--trace records the energies of every iteration, in the report and on standard output.
build lays panels, fins along the edges, or a paper model of strips or nets flat on sheets, and checks
whether offsets and beams can be built; --out is the folder for drawings of the sheets (SVG, DXF, PDF),
tables (CSV) and, with fins, the beams as solids (OBJ). The distance D, negative inwards, and the joint J
between panels are lengths in the unit of the mesh; the model is 1:S; the material is T mm thick, a sheet
W by H mm; holes of --hole mm for dowels or ties are drilled along edges and at the ends of fins; the
PDF is tiled to a --page. What is not given is as in the `build` of the scene. --report-page is the
report on one page of A4 (PDF): picture, plan, build check, bill of materials, and the --link.
refine makes several faces of each, N times; the boundary is a curve of its own, and creases and corners
that turn by more than DEGREES (75) stay sharp. With --panels it solves before the first level and after
each; with --adopt the shape of each level is the original of the next, which is kept close to it: faster
and smoother, and farther from the mesh as it came. The scene goes along: --out writes the mesh, or where
the name ends in .json, the scene with it.
edit changes the faces of a mesh; the scene goes along. A LIST is like 0-4,7, a length is in the unit of
the mesh, and what is not given is as here, lengths in mean edges:
{}
RESULTS is what a student hands in of a lesson: check measures its shape with the goals and the
constraints of the SCENE, and ends with 1 when one is not met. Of a FOLDER of them it writes a table:
goals met, worst distance, moved, and whether the mesh or what the lesson locks was altered. The scene
may be in the folder.
new makes a mesh to begin with, of lengths in the UNIT (m); what is not given is as here:
{}
new plan makes one over an outline on the ground. PLAN.json has the outline and holes as lists of points
{{\"at\": [X, Y], \"bulge\": RISE/HALF_CHORD, \"corner\": true|false}}, the layout follow|cut, the
size of a panel, the turn of a grid that is cut, the height, and what stands: outline|corners.
new loft makes one between two curves of a file, new fill one inside a closed curve: its polylines and
then the boundaries of its faces, counted from 0 (0,1). The size of a panel is a twentieth of the first.
parametrize makes a flat map that keeps angles; --out writes the mesh with the map as its vt.
experiment solves a scene by several methods, and prints how far each came; --csv writes all iterations.
Without a scene it lists the examples that have a comparison of the paper. The limits are per method.
Exit code: 0 done, 1 the input is at fault, 2 usage, 3 internal.",
        Accelerator::list("|"),
        Product::ALL.map(Product::word).join("|"),
        OffsetKind::ALL.map(OffsetKind::word).join("|"),
        Pieces::ALL.map(Pieces::word).join("|"),
        Page::ALL.map(Page::word).join("|"),
        Scheme::list("|"),
        ConformalWeights::list("|"),
        ConformalNorm::list("|"),
        kinds(),
        operations(),
        new_kinds(),
    )
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
