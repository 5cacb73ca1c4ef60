//! `shape-up check RESULTS --scene SCENE`: checks a student's results against the goals.

use super::super::{Failure, input, output};
use super::read;
use shape_up::scene::{GoalOf, GoalResult, NamedEnum, Results};
use shape_up::session::{Checked, check_results};
use shape_up::words;
use std::path::Path;

pub(crate) fn check(path: &Path, scene: &Path) -> Result<(), Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", path.display()));
    let results = read(path)?;
    let input = input::read(scene)?;
    let units = input.scene.units.clone();
    let checked = check_results(&results, input.scene, input.mesh);
    let checked = checked.map_err(|error| at(error.to_string()))?;
    output::print(&words(&results, &checked, &units))?;
    let missed = checked.goals.iter().filter(|goal| !goal.met).count();
    if missed > 0 {
        return Err(at(format!("{missed} of {} goals not met, expected all", checked.goals.len())));
    }
    if let [first, ..] = &*checked.altered {
        return Err(at(format!(
            "locked {} altered, expected the same as in the scene",
            first.word()
        )));
    }
    Ok(())
}

fn words(results: &Results, checked: &Checked, units: &str) -> String {
    let mut lines = vec![
        format!("student     {}", results.student),
        format!("title       {}", results.title),
        format!("saved       {}", results.time),
        format!("iterations  {}", results.iterations),
        format!("moved       {}", words::length(checked.moved, units)),
        format!("distance    {}", words::length(checked.distance, units)),
    ];
    if !results.steps.is_empty() {
        lines.push(format!("steps       {}", results.steps.join("; ")));
    }
    if !checked.changed.is_empty() {
        lines.push(format!("changed     {}", checked.changed.join("; ")));
    }
    lines.extend(checked.altered.iter().map(|lock| format!("altered     locked {}", lock.word())));
    let said = results.goals.iter().map(Some).chain(std::iter::repeat(None));
    for (goal, said) in checked.goals.iter().zip(said) {
        let met = if goal.met { "met        " } else { "not met    " };
        let otherwise = said.is_none_or(|said| said.met != goal.met);
        let otherwise = if otherwise { ", but the file says otherwise" } else { "" };
        lines.push(format!("{met} {}{otherwise}", measured(goal)));
    }
    if !units.is_empty() {
        lines.push(format!("lengths in  {units}"));
    }
    lines.join("\n") + "\n"
}

/// Formats the subject of a goal, its value, and its limit.
fn measured(goal: &GoalResult) -> String {
    let of = match &goal.goal.of {
        GoalOf::Measure(id) => id.clone(),
        GoalOf::Beyond { measure, tolerance } => {
            format!("panels with {measure} beyond {}", words::brief(*tolerance))
        }
        GoalOf::Constraint(name) | GoalOf::Build(name) => name.clone(),
    };
    let value = goal.value.map_or("none".to_owned(), words::number);
    format!("{of}: {value}, at most {}", words::brief(goal.goal.at_most))
}
