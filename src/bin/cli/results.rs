//! `shape-up check RESULTS --scene SCENE`: whether what a student hands in meets the goals.

use super::{Failure, input, output};
use shape_up::scene::{GoalOf, GoalResult, Results};
use shape_up::session::check_results;
use std::path::Path;

pub(super) fn check(path: &Path, scene: &Path) -> Result<(), Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", path.display()));
    let text = String::from_utf8(input::bytes(path)?)
        .map_err(|_| at("the file is not UTF-8 text, expected results in JSON".to_owned()))?;
    let results = Results::from_json(&text).map_err(|error| at(error.to_string()))?;
    let input = input::read(scene)?;
    let units = input.scene.units.clone();
    let goals = check_results(&results, input.scene, input.mesh);
    let goals = goals.map_err(|error| at(error.to_string()))?;
    output::print(&words(&results, &goals, &units))?;
    let missed = goals.iter().filter(|goal| !goal.met).count();
    if missed > 0 {
        return Err(at(format!("{missed} of {} goals not met, expected all", goals.len())));
    }
    Ok(())
}

fn words(results: &Results, goals: &[GoalResult], units: &str) -> String {
    let mut lines = vec![
        format!("student     {}", results.student),
        format!("title       {}", results.title),
        format!("saved       {}", results.time),
        format!("iterations  {}", results.iterations),
    ];
    for (goal, said) in
        goals.iter().zip(results.goals.iter().map(Some).chain(std::iter::repeat(None)))
    {
        let of = match &goal.goal.of {
            GoalOf::Measure(id) => id,
            GoalOf::Constraint(name) => name,
        };
        let met = if goal.met { "met        " } else { "not met    " };
        let value = goal.value.map_or("none".to_owned(), |value| value.to_string());
        let otherwise = said.is_none_or(|said| said.met != goal.met);
        let otherwise = if otherwise { ", otherwise than the file says" } else { "" };
        lines.push(format!("{met} {of}: {value}, at most {}{otherwise}", goal.goal.at_most));
    }
    if !units.is_empty() {
        lines.push(format!("lengths in  {units}"));
    }
    lines.join("\n") + "\n"
}
