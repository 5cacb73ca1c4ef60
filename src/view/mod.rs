//! The picture: camera, picking, and one primitive per file with its shader. Sees positions and
//! index buffers, never the solver.
