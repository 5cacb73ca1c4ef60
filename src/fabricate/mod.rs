//! From a shape to parts that can be cut: panels laid flat and placed on sheets, and the numbers
//! that show whether offsets, beams and panels fit.
//!
//! Lengths of the building are in the unit of the mesh until they are on a sheet, where everything
//! is in mm. Distances are positive outwards; outside is where the area vectors of the panels
//! point. To avoid scaling twice, the factor from one to the other is in `build` alone.
//!
//! ```text
//! mesh -> surface -> panel -> sheet -> file
//!            \-> offset -> beam -> report
//! ```
//!
//! | file or folder | holds |
//! |---|---|
//! | `fault` | reasons why something cannot be built |
//! | `surface` | the panels as an oriented surface, edges with the panels on both sides |
//! | `facing` | panels that face inwards or are folded over |
//! | `alike` | sorting of items into types |
//! | `boxes` | which boxes in the plane meet another one |
//! | `panel` | panels laid flat, the joint, names, types, pieces of large ones, the order of assembly |
//! | `offset` | node axes, exact or fitted, and the check of an offset |
//! | `beam` | beams along the edges: nodes, fins, node discs, prisms |
//! | `paper` | paper models: nets and strips with folds, and tabs or tongues in slots, or of card with a thickness |
//! | `sheet` | parts, letters, labels, the layout on sheets |
//! | `file` | SVG, DXF, PDF, CSV, GLB, pictures of sheets |
//! | `build` | everything for one shape |
//! | `cutting` | cuts, lays out and names the parts |
//! | `outline` | the outlines of a panel and of its holes |
//! | `discs` | node discs as parts |
//! | `holes` | holes along edges, at the ends of fins, and through splice plates |
//! | `strips` | strips that cover the joints between panels |
//! | `relief` | reliefs in inner corners, for milling tools |
//! | `check_card` | the build check: five numbers with limits, and the elements that exceed them |
//! | `build_words` | the report in words |
//! | `advice` | values of settings with which parts can be cut and joined |
//! | `advised` | values of settings that are advised, with the names of buttons |
//! | `card` | the part of the report that is updated while the user moves the shape |
//! | `layer` | the offset of a moving shape as points, failing sides of parts, for the view |
//! | `numbers` | the numbers that a lesson can limit |
//! | `tighten` | suggestions that the solver offers |
//! | `report` | the report with all numbers |
//! | `report_page` | the report as an HTML document of one page |
//! | `view_axes` | directions of view, and where vertices are seen |
//! | `key` | drawings that say where each part goes |
//! | `tables` | lists of panels, splice plates, cover strips, beams, pieces, edges, nodes and types |
//! | `space` | the shape with its offset and beams in space |
//! | `plates` | fins and node discs as plates in space |
//! | `output` | all files of a build |

mod advice;
mod advised;
mod alike;
pub mod beam;
mod boxes;
mod build;
mod build_words;
mod card;
mod check_card;
mod cutting;
mod discs;
mod facing;
mod fault;
pub mod file;
mod holes;
mod key;
mod layer;
mod numbers;
pub mod offset;
mod outline;
mod output;
pub mod panel;
pub mod paper;
mod plates;
mod relief;
mod report;
mod report_page;
pub mod sheet;
mod space;
mod strips;
mod surface;
mod tables;
mod tighten;
mod view_axes;

pub use advice::Advice;
pub use advised::{AdvisedValue, SettingValue};
pub use alike::Types;
pub use build::{Build, CutDisc, CutPanel, LeftOut, NotCut, Splice, unit_of};
pub use build_words::{BuildWords, CardWords, CheckWords};
pub use card::{BuildCard, OffsetReport};
pub use check_card::{CheckRow, Failed, Worst};
pub use fault::Fault;
pub use numbers::{BUILD_NUMBERS, BuildNumber, NumberUnit};
pub use offset::Choice;
pub use output::{BuildFile, PARTS};
pub use panel::Stand;
pub use report::{BuildReport, FrameReport, PaperReport};
pub use report_page::ReportView;
pub use space::{PRESENTATION, SpatialPart};
pub use strips::CoverStrip;
pub use surface::{Edge, PanelSurface};
pub use tighten::{PanelSuggestion, Tighten};
