//! `lesson`: what is to be done, and the goals; and the results that are handed in.
//!
//! ```json
//! { "text": "Make every panel flat.",
//!   "goals": [ { "measure": "planarity", "at_most": 0.001 },
//!              { "constraint": "Eaves", "at_most": 0.01 } ] }
//! ```

use super::node::{JsonCursor, Node, read_points};
use super::parse::{check_format, parse};
use super::text::{field, lines, number, object, point, rows, text};
use super::{constraint, handle};
use crate::scene::{Goal, GoalOf, GoalResult, Lesson, Results, SceneError};

/// The value of `format` in every file of results.
const FORMAT: &str = "shape-up-results";
/// The version of the file of results that is read and written.
const VERSION: u32 = 1;

const GOAL_KEYS: &[&str] = &["measure", "constraint", "at_most"];
const RESULT_KEYS: &[&str] = &[
    "format",
    "version",
    "student",
    "title",
    "scene",
    "time",
    "iterations",
    "passed",
    "goals",
    "constraints",
    "handles",
    "positions",
];

impl Lesson {
    /// Reads the `lesson` of a scene.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<Lesson, SceneError> {
        read(&JsonCursor::root(&parse(json)?))
    }
}

pub(crate) fn read(at: &JsonCursor<'_>) -> Result<Lesson, SceneError> {
    at.only_keys(&["text", "goals"])?;
    let text = at.need("text", "what is to be done")?.text("what is to be done")?.to_owned();
    let goals = at.need("goals", "an array of goals")?;
    let items = goals.array("an array of goals")?;
    if items.is_empty() {
        return Err(goals.expected("at least one goal"));
    }
    let goals = items.iter().map(|goal| read_goal(goal, GOAL_KEYS)).collect::<Result<_, _>>()?;
    Ok(Lesson { text, goals })
}

fn read_goal(at: &JsonCursor<'_>, keys: &[&str]) -> Result<Goal, SceneError> {
    const WHAT: &str = "{\"measure\": ...} or {\"constraint\": ...}";
    at.only_keys(keys)?;
    let of = match (at.get("measure"), at.get("constraint")) {
        (Some(measure), None) => GoalOf::Measure(measure.text("the id of a measure")?.to_owned()),
        (None, Some(name)) => GoalOf::Constraint(name.text("the name of a constraint")?.to_owned()),
        (None, None) => return Err(at.error(format!("the goal is about nothing, expected {WHAT}"))),
        (Some(_), Some(_)) => {
            return Err(at.error(format!("the goal is about two, expected {WHAT}")));
        }
    };
    let at_most = at.need("at_most", "a number from 0")?;
    let value = at_most.number("a number from 0")?;
    if value < 0.0 {
        return Err(at_most.expected("a number from 0"));
    }
    Ok(Goal { of, at_most: value })
}

/// The lesson, each goal on a line.
pub(super) fn write(lesson: &Lesson) -> String {
    let goals = lesson.goals.iter().map(|goal| object(goal_fields(goal))).collect();
    object(vec![field("text", text(&lesson.text)), field("goals", lines('[', goals, ']'))])
}

fn goal_fields(goal: &Goal) -> Vec<String> {
    let of = match &goal.of {
        GoalOf::Measure(id) => field("measure", text(id)),
        GoalOf::Constraint(name) => field("constraint", text(name)),
    };
    vec![of, field("at_most", number(goal.at_most))]
}

impl Results {
    /// Reads a file of results.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(json: &str) -> Result<Results, SceneError> {
        read_results(&JsonCursor::root(&parse(json)?))
    }

    /// Writes the file that [`Results::from_json`] reads.
    pub fn to_json(&self) -> String {
        let goals = self.goals.iter().map(|result| {
            let mut fields = goal_fields(&result.goal);
            fields.push(field("value", result.value.map_or("null".to_owned(), number)));
            fields.push(field("met", result.met.to_string()));
            object(fields)
        });
        let constraints = self.constraints.iter().map(constraint::write).collect();
        let handles = self.handles.iter().map(handle::write).collect();
        let fields = [
            field("format", text(FORMAT)),
            field("version", VERSION.to_string()),
            field("student", text(&self.student)),
            field("title", text(&self.title)),
            field("scene", text(&self.scene)),
            field("time", text(&self.time)),
            field("iterations", self.iterations.to_string()),
            field("passed", self.passed.to_string()),
            field("goals", lines('[', goals.collect(), ']')),
            field("constraints", lines('[', constraints, ']')),
            field("handles", lines('[', handles, ']')),
            field("positions", rows(self.positions.iter().map(point), "")),
        ];
        format!("{{\n  {}\n}}\n", fields.join(",\n  "))
    }
}

fn read_results(at: &JsonCursor<'_>) -> Result<Results, SceneError> {
    check_format(at, "results: an object", FORMAT, VERSION)?;
    at.only_keys(RESULT_KEYS)?;
    let word = |key: &'static str| -> Result<String, SceneError> {
        Ok(at.need(key, "a text")?.text("a text")?.to_owned())
    };
    let goals = at.need("goals", "an array of goals")?;
    let constraints = at.need("constraints", "an array of constraints")?;
    let handles = at.need("handles", "an array of handles")?;
    Ok(Results {
        student: word("student")?,
        title: word("title")?,
        scene: word("scene")?,
        time: word("time")?,
        iterations: at.need("iterations", "a count")?.whole("a count")?,
        passed: at.need("passed", "true or false")?.truth()?,
        goals: each(&goals, "an array of goals", read_result)?,
        constraints: each(&constraints, "an array of constraints", constraint::read)?,
        handles: each(&handles, "an array of handles", handle::read)?,
        positions: read_points(&at.need("positions", "an array of points [x, y, z]")?)?,
    })
}

fn each<T>(
    at: &JsonCursor<'_>,
    what: &str,
    read: impl Fn(&JsonCursor<'_>) -> Result<T, SceneError>,
) -> Result<Vec<T>, SceneError> {
    at.array(what)?.iter().map(read).collect()
}

fn read_result(at: &JsonCursor<'_>) -> Result<GoalResult, SceneError> {
    const WHAT: &str = "a number, or null where nothing has it";
    let goal = read_goal(at, &["measure", "constraint", "at_most", "value", "met"])?;
    let value = at.need("value", WHAT)?;
    let value = match value.node {
        Node::Null => None,
        _ => Some(value.number(WHAT)?),
    };
    Ok(GoalResult { goal, value, met: at.need("met", "true or false")?.truth()? })
}
