//! Cuts the parts of a build, lays them out, and then names them, so that names are upright on the
//! sheet.

use super::beam::{Frame, FrameSize};
use super::build::{Build, CutPanel, NotCut, Splice};
use super::fault::Fault;
use super::outline::{PanelOutline, PanelRing};
use super::panel::{
    PieceSide, SplicePlate, Spliced, Stand, check_size, corners, direction_of, distinct_corners,
    inset, smallest_box, smallest_box_within, spliced,
};
use super::paper::{Card, Fit, MissingNames, PaperModel, PaperSize, drawn, reach, write_names};
use super::report::JOINT_STEP;
use super::sheet::{
    CutPart, Hole, Inscription, Labels, NamePlace, Place, SheetSize, Waste, label, lay_out, strokes,
};
use super::view_axes::upwards_in;
use crate::math::plane::{Point2, area, bounds, is_inside, length, minus, rotated};
use crate::math::{cosine, sine};
use crate::scene::{BuildSettings, Join, Product, Up};

/// The widest kerf of paper and card in mm: of lasers and knives. Wider cuts around the slits of nets can
/// cross each other.
const WIDEST_OF_PAPER: f64 = 1.0;

impl Build {
    /// Cuts all parts of a shape that stands like this, lays them out, and names them.
    pub(super) fn cut(&mut self, stand: &Stand) {
        match self.settings.product {
            Product::Panels => self.cut_panels(stand.up == Up::Z),
            Product::Fins => self.cut_fins(),
            Product::Paper => self.cut_paper(),
        }
        self.drill();
        self.cut_discs();
        self.relieve();
        if self.is_turned_over() {
            self.parts.iter_mut().for_each(CutPart::turn_over);
        }
        let BuildSettings { sheet, margin, gap, order, outlines_only, .. } = self.settings;
        self.layout = lay_out(&self.parts, SheetSize { size: sheet, margin, gap }, order);
        if !outlines_only {
            self.write_names();
        }
    }

    /// Whether panels lie on their sheets with their inside up.
    pub(super) fn is_turned_over(&self) -> bool {
        self.settings.print_inside && self.settings.product == Product::Panels
    }

    /// A point or a vector of a panel as it is cut, in mm, on its part; also the other way around.
    pub(super) fn on_part(&self, [x, y]: Point2) -> Point2 {
        [if self.is_turned_over() { -x } else { x }, y]
    }

    fn cut_panels(&mut self, z_up: bool) {
        for f in 0..self.flat.len() {
            let found = self.cut_panel(f, z_up);
            if let Err(why) = found {
                let is_part = self.flat[f].is_some();
                self.not_cut.push(NotCut { part: self.names[f].clone(), why, is_part });
            }
            self.cut.push(found.ok());
        }
    }

    fn cut_panel(&mut self, f: usize, z_up: bool) -> Result<CutPanel, &'static str> {
        let PanelOutline { whole, rings } = self.outline(f, &self.settings)?;
        let (turn, size) = smallest_box(&rings[0].corners);
        let turned =
            |points: &[Point2]| points.iter().map(|&p| rotated(p, turn)).collect::<Vec<_>>();
        let whole = turned(&whole);
        let across = |e: u32| {
            let met = self.surface.neighbours_across(e, f as u32).into_iter();
            let names: Vec<&str> = met.map(|other| &*self.names[other as usize]).collect();
            (!names.is_empty()).then(|| names.join("/"))
        };
        let edges = self.surface.sides.row(f);
        // The corners, and what lies beyond each side that is left.
        let cut = |PanelRing { corners, sides }: &PanelRing| {
            let corners = turned(corners);
            let next = corners.iter().cycle().skip(1);
            let left = corners.iter().zip(next).zip(sides).filter(|((p, q), _)| p != q);
            let (beyond, bevels): (Vec<Option<String>>, Vec<Option<f64>>) =
                left.map(|(_, &k)| (across(edges[k]), self.bevel(edges[k]))).unzip();
            (distinct_corners(&corners), beyond, bevels)
        };
        let (outline, neighbours, bevels) = cut(&rings[0]);
        let holes = rings[1..].iter().map(cut);
        let holes = holes.map(|(outline, beyond, _)| Hole::opening(outline, beyond)).collect();
        let arrow = self.flat[f].as_ref().map(|flat| rotated(upwards_in(flat.axes, z_up), turn));
        let (name, panels) = (self.names[f].clone(), vec![f as u32]);
        let part = CutPart {
            name,
            panels,
            outline,
            neighbours,
            bevels,
            arrow,
            holes,
            ..CutPart::default()
        };
        let first = self.parts.len();
        let holes: Vec<Vec<Point2>> = part.holes.iter().map(Hole::outline).collect();
        let spliced = self.spliced(&part.outline, &holes, self.settings.splice);
        let pieces = spliced.as_ref().map_or(1, |spliced| spliced.pieces.len());
        match spliced {
            Some(spliced) => self.add_pieces(&part, spliced),
            None => self.parts.push(part),
        }
        Ok(CutPanel { whole, turn, size, part: first, pieces })
    }

    /// The bevel of the panels at an edge in degrees, to be written on them: none where they are too
    /// thin for one, or it takes less off them than can be cut.
    fn bevel(&self, e: u32) -> Option<f64> {
        /// Thinner panels are glued or taped with square sides, in mm.
        const THINNEST: f64 = 1.0;
        let bevel = self.surface.bevel(e)?;
        let turns = bevel / std::f64::consts::TAU;
        let thickness = self.settings.thickness;
        let cut_back = thickness * (sine(turns) / cosine(turns)).abs();
        // Panels that lie on each other have none.
        let is_cut = cosine(turns) > 1e-6 && cut_back >= JOINT_STEP;
        (thickness >= THINNEST && is_cut).then(|| bevel.to_degrees())
    }

    /// The longer and the shorter side of the room for parts on a sheet.
    pub(super) fn room(&self) -> [f64; 2] {
        let room = self.settings.sheet.map(|side| side - 2.0 * self.settings.margin);
        [room[0].max(room[1]), room[0].min(room[1])]
    }

    /// The outline of a panel in pieces that are joined by plates of this width; none if it fits on a
    /// sheet, or no pieces do.
    pub(super) fn spliced(
        &self,
        outline: &[Point2],
        holes: &[Vec<Point2>],
        width: f64,
    ) -> Option<Spliced> {
        if width <= 0.0 {
            return None;
        }
        // As the layout allows for rounding.
        let most = self.room().map(|side| side * (1.0 + 1e-9));
        let fits = |outline: &[Point2]| {
            // Most that do not fit are too large at every angle, of which hundreds would be tried.
            let [low, high] = bounds(outline.iter().copied());
            let [width, height] = minus(high, low);
            if area(outline) > most[0] * most[1] || width.max(height) > length(most) {
                return false;
            }
            let (_, size) = smallest_box_within(outline, most);
            size[0] <= most[0] && size[1] <= most[1]
        };
        if fits(outline) {
            return None;
        }
        spliced(outline, holes, width, self.settings.kerf, fits)
    }

    /// Adds the pieces of a panel to the parts, `P12.1` and `P12.2`, and the plates behind their seams,
    /// `P12.1-2`: no other name has a dot. On both pieces, a frame is where their plate lies.
    fn add_pieces(&mut self, panel: &CutPart, Spliced { pieces, plates }: Spliced) {
        let first = self.parts.len();
        let name = |k: usize| format!("{}.{}", panel.name, k + 1);
        for (k, piece) in pieces.into_iter().enumerate() {
            let beyond = |(_, side): &(Point2, PieceSide)| match side {
                PieceSide::Panel(k) => panel.neighbours[*k].clone(),
                PieceSide::Piece(other) => Some(name(*other)),
            };
            let bevel = |(_, side): &(Point2, PieceSide)| match side {
                PieceSide::Panel(k) => panel.bevels[*k],
                PieceSide::Piece(_) => None,
            };
            let outline = corners(&piece);
            let is_in = |hole: &&Hole| is_inside(&outline, hole.outline()[0]);
            self.parts.push(CutPart {
                name: name(k),
                panels: panel.panels.clone(),
                holes: panel.holes.iter().filter(is_in).cloned().collect(),
                outline,
                neighbours: piece.iter().map(beyond).collect(),
                bevels: piece.iter().map(bevel).collect(),
                arrow: panel.arrow,
                ..CutPart::default()
            });
        }
        let half = 0.5 * self.settings.kerf;
        for SplicePlate { pieces, axis, corners: [low, high], seam } in plates {
            let [one, other] = pieces.map(|k| k + 1);
            let part = self.parts.len();
            let [from, to] = [low.map(|x| x - half), high.map(|x| x + half)];
            self.parts.push(CutPart {
                name: format!("{}.{one}-{other}", panel.name),
                panels: panel.panels.clone(),
                outline: vec![from, [to[0], from[1]], to, [from[0], to[1]]],
                neighbours: vec![None; 4],
                ..CutPart::default()
            });
            let across = 0.5 * (low[axis] + high[axis]);
            for (piece, end) in pieces.into_iter().zip([low[axis], high[axis]]) {
                let frame = [(across, low), (end, low), (end, high), (across, high)];
                let frame = frame.map(|(at, mut corner): (f64, Point2)| {
                    corner[axis] = at;
                    corner
                });
                self.parts[first + piece].engraved.push(frame.to_vec());
            }
            let pieces = pieces.map(|k| first + k);
            let panel = panel.panels[0];
            self.splices.push(Splice { panel, part, pieces, axis, corners: [low, high], seam });
        }
    }

    /// The beams of a model with these settings, of which the scale and the node discs may be others; none
    /// without an offset, and for other products.
    pub(super) fn frame_of(&self, settings: &BuildSettings) -> Option<Frame> {
        let &BuildSettings { product, thickness, alike_deg, mirror, scale, .. } = settings;
        let (axes, _) = self.offset.as_ref().filter(|_| product == Product::Fins)?;
        let size = FrameSize {
            height: self.distance(),
            width: self.beam_width(),
            thickness: thickness / self.mm_of_sheet_at(scale),
            discs: self.disc_size(settings),
        };
        Some(Frame::new(&self.surface, &axes.axes, size, alike_deg, mirror))
    }

    fn cut_fins(&mut self) {
        let Some(frame) = self.frame_of(&self.settings) else { return };
        self.faults.extend(Build::no_slots(&self.settings));
        let (model, kerf) = (self.mm_of_sheet(), self.settings.kerf);
        for (e, fin) in frame.fins.iter().enumerate() {
            let edge = &self.surface.edges[e];
            if edge.is_bridge() {
                continue;
            }
            let name = self.beam_name(edge.ends);
            let fin = fin.as_ref().map_err(|why| *why).and_then(|fin| {
                let scaled: Vec<Point2> =
                    fin.cut.iter().map(|corner| corner.map(|x| x * model)).collect();
                let outline = if kerf > 0.0 { inset(&scaled, -0.5 * kerf) } else { Some(scaled) };
                let outline = outline.ok_or("it is too small for the kerf")?;
                check_size(&outline)?;
                Ok((fin, outline))
            });
            match fin {
                Ok((fin, outline)) => {
                    let [one, other] = fin.ends.map(|v| Some(self.node_name(v)));
                    let panels = edge.panels.into_iter().flatten().collect();
                    // The ends are the second and the last side.
                    let mut neighbours = vec![None; fin.cut.len()];
                    (neighbours[1], neighbours[fin.cut.len() - 1]) = (one, other);
                    let [c, s] = direction_of(outline[0], outline[1]);
                    self.fins.push(e as u32);
                    self.parts.push(CutPart {
                        name,
                        panels,
                        outline,
                        neighbours,
                        arrow: Some([s, -c]),
                        is_oriented: true,
                        ..CutPart::default()
                    });
                }
                Err(why) => {
                    let is_part = self.surface.length(edge) > 0.0;
                    self.not_cut.push(NotCut { part: name, why, is_part });
                }
            }
        }
        self.frame = Some(frame);
    }

    /// The sizes of a paper model at this scale.
    pub(super) fn paper_size(&self, scale: f64) -> PaperSize {
        let BuildSettings { sheet, margin, fold, join, thickness, clearance, .. } = self.settings;
        let kerf = self.paper_kerf();
        let room = sheet.map(|side| side - 2.0 * (margin + reach(kerf)));
        let card = Card { fold, thickness };
        let slots = (join == Join::Slots).then_some(Fit { thickness, clearance, kerf });
        PaperSize { model: self.mm_of_sheet_at(scale), room, tab: self.tab(), slots, card }
    }

    /// The kerf that outlines of a paper model allow for: none that is wider than its slits can be.
    fn paper_kerf(&self) -> f64 {
        Some(self.settings.kerf).filter(|kerf| *kerf <= WIDEST_OF_PAPER).unwrap_or(0.0)
    }

    /// Cuts the pieces of a paper model; `write_names` finds neighbours, which depend on the tabs.
    fn cut_paper(&mut self) {
        let BuildSettings { pieces, print_inside, scale, .. } = self.settings;
        let (size, kerf) = (self.paper_size(scale), self.paper_kerf());
        if self.settings.kerf > kerf {
            self.faults.push(Fault::wide_kerf(self.settings.kerf));
        }
        let model = PaperModel::new(&self.surface, &self.flat, pieces, size, &self.settings.seams);
        let pieces = 0..model.pieces.len();
        self.parts = pieces.map(|k| drawn(&model, k, print_inside, kerf)).collect();
        for &(panel, why) in &model.without {
            let panel = panel as usize;
            let is_part = self.flat[panel].is_some();
            self.not_cut.push(NotCut { part: self.names[panel].clone(), why, is_part });
        }
        if model.is_without_quads {
            self.faults.push(Fault::no_strips());
        }
        self.paper = Some(model);
    }

    /// Engraves each part on a sheet with its name and the names of its neighbours beside its edges.
    fn write_names(&mut self) {
        let places = self.layout.places(self.parts.len());
        let mut parts = std::mem::take(&mut self.parts);
        for (k, part) in parts.iter_mut().enumerate() {
            let Some((_, Place { turn, .. })) = places[k] else { continue };
            // Upright in its own frame, where letters say how it lies.
            let turn = if part.is_oriented { [1.0, 0.0] } else { turn };
            let missing = match &self.paper {
                Some(model) => {
                    let inside = self.settings.print_inside;
                    write_names(part, (model, k), &self.names, inside, turn)
                }
                None => {
                    let labels = match self.disc_of(k) {
                        Some(disc) => self.label_disc(disc, part, turn),
                        None => {
                            // Names are not written across the frame of a plate.
                            let frames = part.engraved.iter().flat_map(|frame| frame.windows(2));
                            let frames = frames.map(|ends| Hole::slot(ends.to_vec()));
                            let holes: Vec<Hole> =
                                part.holes.iter().cloned().chain(frames).collect();
                            label(Inscription {
                                outline: &part.outline,
                                name: &part.name,
                                neighbours: &part.neighbours,
                                bevels: &part.bevels,
                                is_oriented: part.is_oriented,
                                arrow: part.arrow,
                                turn,
                                holes: &holes,
                            })
                        }
                    };
                    let Labels { lines, dropped, small, .. } = labels;
                    part.engraved.extend(lines);
                    // Its own name says which neighbour is where.
                    let dropped = if part.is_oriented { 0 } else { dropped };
                    MissingNames { dropped, small, piece: small }
                }
            };
            part.named = if missing.piece { NamePlace::Nowhere } else { NamePlace::OnPart };
            self.left_out.dropped_names += missing.dropped;
            self.left_out.small_names += usize::from(missing.small);
        }
        self.parts = parts;
        self.write_on_waste();
    }

    /// Writes the names of parts that have no room for them on the waste beside them.
    fn write_on_waste(&mut self) {
        let BuildSettings { sheet: size, margin, .. } = self.settings;
        let unnamed: Vec<bool> =
            self.parts.iter().map(|part| part.named == NamePlace::Nowhere).collect();
        let asks = |place: &Place| unnamed[place.part];
        for sheet in &self.layout.sheets {
            if !sheet.places.iter().any(asks) {
                continue;
            }
            let outline = |place: &Place| {
                self.parts[place.part].outline.iter().map(|&point| place.to_sheet(point)).collect()
            };
            let mut waste = Waste::new(size, margin, sheet.places.iter().map(outline).collect());
            for (k, place) in sheet.places.iter().enumerate().filter(|(_, place)| asks(place)) {
                let part = &mut self.parts[place.part];
                let along = if part.is_oriented { place.axis_along_part() } else { [1.0, 0.0] };
                let Some((height, centre)) = waste.write(k, &part.name, along) else { continue };
                let on_part = |line: Vec<Point2>| {
                    line.into_iter().map(|point| place.to_part(point)).collect()
                };
                let lines = strokes(&part.name, height, centre, along);
                part.engraved.extend(lines.into_iter().map(on_part));
                part.named = NamePlace::BesidePart;
            }
        }
    }
}
