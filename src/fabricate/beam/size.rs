//! The dimensions of beams and of what joins them.

/// Dimensions of beams, in the unit of the mesh.
#[derive(Clone, Copy, Debug)]
pub struct FrameSize {
    /// The height of fins and prisms, negative inwards.
    pub height: f64,
    /// The width of prisms.
    pub width: f64,
    /// The thickness of fins.
    pub thickness: f64,
    /// The node discs that join fins; none if there are none.
    pub discs: Option<DiscSize>,
}

/// Dimensions of discs, in the unit of the mesh.
#[derive(Clone, Copy, Debug)]
pub struct DiscSize {
    /// The diameter; none for the smallest that is possible at each node.
    pub diameter: Option<f64>,
    /// Diameters that are not given are multiples of this.
    pub step: f64,
    /// The play between a disc and a fin on each side.
    pub clearance: f64,
    /// The least width of material beside a slot or a seat.
    pub wall: f64,
    /// The least length of a tenon.
    pub tenon: f64,
}
