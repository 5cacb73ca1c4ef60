//! What every host drives: load, edit, drag, step, undo, report.
