//! Reports to the page, as plain objects in camelCase.
//!
//! | file | holds |
//! |---|---|
//! | `loaded` | the summary of a file that was opened |
//! | `document` | the current document |
//! | `frame` | the numbers of one state of the iteration |
//! | `forecast` | the forecast for panels of one shape |
//! | `lesson` | the exercise of the scene, and its goals |
//! | `verdict` | the verdict on the panels, with its words |
//! | `vocabulary` | the kinds, and the elements that they act on |

mod document;
mod forecast;
mod frame;
mod lesson;
mod loaded;
mod verdict;
mod vocabulary;

pub(crate) use document::Document;
pub(crate) use forecast::ForecastWords;
pub(crate) use frame::Frame;
pub(crate) use loaded::Loaded;
pub(crate) use verdict::PanelVerdict;
pub(crate) use vocabulary::{elements, kinds};
