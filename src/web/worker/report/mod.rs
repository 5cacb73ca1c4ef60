//! Results for the page, as plain objects in camelCase.
//!
//! | file | holds |
//! |---|---|
//! | `loaded` | what was read from a file |
//! | `document` | the document as it stands |
//! | `frame` | the numbers of one state of the iteration |
//! | `lesson` | the exercise that the scene is, and its goals |
//! | `vocabulary` | the kinds, and the elements that they act on |

mod document;
mod frame;
mod lesson;
mod loaded;
mod vocabulary;

pub(crate) use document::Document;
pub(crate) use frame::Frame;
pub(crate) use loaded::Loaded;
pub(crate) use vocabulary::{elements, kinds};
