//! The modules of `src/` as text, and the names that they use of each other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The path of a module below the crate.
pub(crate) type Module = Vec<String>;

/// For each module, the modules that it names something of.
pub(crate) type Uses = BTreeMap<Module, BTreeSet<Module>>;

/// One source file.
pub(crate) struct Text {
    /// Path below `src`.
    pub(crate) file: String,
    /// Module documentation.
    pub(crate) head: String,
    /// Code without comments, strings and tests.
    pub(crate) code: String,
    /// Child modules that are files or folders.
    pub(crate) children: BTreeSet<String>,
    /// Public structs, enums, traits and type aliases defined here.
    pub(crate) public_types: Vec<String>,
    /// Path of each imported name; a glob import has the name `*`.
    imports: Vec<(String, Module)>,
}

/// The library.
pub(crate) struct Sources {
    pub(crate) modules: BTreeMap<Module, Text>,
}

impl Sources {
    /// Reads all files of the library, without `src/bin`.
    pub(crate) fn read() -> Sources {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut modules = BTreeMap::new();
        let mut folders = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(&folder).expect("a folder can be listed") {
                let path = entry.expect("it can be listed").path();
                if path.is_dir() && path != root.join("bin") {
                    folders.push(path);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    let file = path.strip_prefix(&root).expect("it is in src");
                    let file = file.to_str().expect("names are ASCII").replace('\\', "/");
                    let text = std::fs::read_to_string(&path).expect("it can be read");
                    let mut module: Module =
                        file.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
                    module.pop_if(|last| *last == "mod" || *last == "lib");
                    modules.insert(module, Text::new(file, &text));
                }
            }
        }
        let names: Vec<Module> = modules.keys().filter(|name| !name.is_empty()).cloned().collect();
        for mut name in names {
            let last = name.pop().expect("it has a name");
            modules.get_mut(&name).expect("a module has a parent").children.insert(last);
        }
        Sources { modules }
    }

    /// Modules that have child modules.
    pub(crate) fn folders(&self) -> Vec<Module> {
        let with = self.modules.iter().filter(|(_, text)| !text.children.is_empty());
        with.map(|(module, _)| module.clone()).collect()
    }

    /// All modules named by each module, in its code and its imports.
    pub(crate) fn uses(&self) -> Uses {
        let of = |(module, text): (&Module, &Text)| {
            let named = paths(&text.code).into_iter();
            let used = named.filter_map(|path| self.home(module, &path, 0));
            (module.clone(), used.filter(|other| other != module).collect())
        };
        self.modules.iter().map(of).collect()
    }

    /// The module that defines the item that `path` names in `module`; `None` outside the crate.
    fn home(&self, module: &Module, path: &[String], depth: usize) -> Option<Module> {
        // Imports are circular if a module has the name of its item.
        if depth > 12 {
            return None;
        }
        let (mut at, mut rest) = match path[0].as_str() {
            "crate" => (Vec::new(), &path[1..]),
            "self" => (module.clone(), &path[1..]),
            "super" => {
                let ups = path.iter().take_while(|step| *step == "super").count();
                (module[..module.len().checked_sub(ups)?].to_vec(), &path[ups..])
            }
            first if self.modules[module].children.contains(first) => (module.clone(), path),
            first => {
                let (_, stands_for) =
                    self.modules[module].imports.iter().find(|(name, _)| name == first)?;
                let whole: Module = stands_for.iter().chain(&path[1..]).cloned().collect();
                return (whole != path).then(|| self.home(module, &whole, depth + 1))?;
            }
        };
        while let Some(step) = rest.first() {
            let text = self.modules.get(&at)?;
            let handed_on = text.imports.iter().find(|(name, _)| name == step);
            if rest.len() > 1 && text.children.contains(step) || handed_on.is_none() {
                if !text.children.contains(step) {
                    break;
                }
                at.push(step.clone());
                rest = &rest[1..];
            } else if let Some((_, stands_for)) = handed_on {
                let whole: Module = stands_for.iter().chain(&rest[1..]).cloned().collect();
                return self.home(&at, &whole, depth + 1);
            }
        }
        Some(at)
    }
}

impl Text {
    fn new(file: String, text: &str) -> Text {
        let head = text.lines().take_while(|line| line.starts_with("//!"));
        let head = head.fold(String::new(), |head, line| head + line + "\n");
        let code = without_comments_and_strings(
            text.split("#[cfg(test)]\nmod").next().unwrap_or_default(),
        );
        // A module does not depend on its re-exports.
        let statements = use_statements(&code);
        let imports = statements.iter().flat_map(|(_, tree)| names(tree)).collect();
        let mut own = code.clone();
        for (statement, _) in
            statements.iter().filter(|(statement, _)| statement.starts_with("pub"))
        {
            own = own.replace(statement, "");
        }
        let declared = own.lines().filter_map(|line| {
            let rest = line.trim_start().strip_prefix("pub ")?;
            let (keyword, rest) = rest.split_once(' ')?;
            let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
            let is_top = !line.starts_with(' ');
            let is_type = ["struct", "enum", "trait", "type"].contains(&keyword);
            (is_top && is_type).then(|| name.to_owned())
        });
        Text {
            public_types: declared.collect(),
            file,
            head,
            code: own,
            children: BTreeSet::new(),
            imports,
        }
    }
}

/// A dependency cycle between the files and folders in `folder`, with an example for each step.
pub(crate) fn cycle(folder: &Module, uses: &Uses) -> Option<Vec<String>> {
    let child = |module: &Module| {
        module
            .strip_prefix(&folder[..])
            .map(|rest| rest.first().cloned().unwrap_or("mod".to_owned()))
    };
    // From, to: an example of a file and what it names.
    let mut steps: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    for (module, others) in uses {
        let Some(from) = child(module) else { continue };
        for other in others {
            let Some(to) = child(other).filter(|to| *to != from) else { continue };
            let example = format!("  {} -> {}", module.join("::"), other.join("::"));
            steps.entry(from.clone()).or_default().entry(to).or_insert(example);
        }
    }
    // A module without outgoing steps is in no cycle.
    loop {
        let all: BTreeSet<String> = steps.keys().cloned().collect();
        for ways in steps.values_mut() {
            ways.retain(|to, _| all.contains(to));
        }
        let before = steps.len();
        steps.retain(|_, ways| !ways.is_empty());
        if steps.len() == before {
            break;
        }
    }
    let mut at = steps.keys().next()?.clone();
    let mut way: Vec<(String, String)> = Vec::new();
    while !way.iter().any(|(from, _)| *from == at) {
        let (to, example) = steps[&at].iter().next()?;
        way.push((at.clone(), example.clone()));
        at.clone_from(to);
    }
    let start = way.iter().position(|(from, _)| *from == at)?;
    Some(way[start..].iter().map(|(_, example)| example.clone()).collect())
}

fn without_comments_and_strings(text: &str) -> String {
    let mut code = String::new();
    for line in text.lines() {
        let mut in_string = false;
        let mut before = ' ';
        for c in line.chars() {
            if c == '"' && before != '\\' && before != '\'' {
                in_string = !in_string;
            } else if !in_string {
                if c == '/' && before == '/' {
                    code.pop();
                    break;
                }
                code.push(c);
            }
            before = c;
        }
        code.push('\n');
    }
    code
}

/// The `use` statements with their trees.
fn use_statements(code: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(start) = rest.find("use ") {
        let line = rest[..start].rfind('\n').map_or(0, |end| end + 1);
        let visibility = rest[line..start].trim();
        let end = rest[start..].find(';').map_or(rest.len(), |end| start + end + 1);
        if visibility.is_empty() || visibility.starts_with("pub") && !visibility.contains(' ') {
            let statement = rest[line..end].trim_start().to_owned();
            found.push((statement, rest[start + 4..end].trim_end_matches(';').to_owned()));
        }
        rest = &rest[end..];
    }
    found
}

/// The names that a tree of imports introduces, and their paths.
fn names(tree: &str) -> Vec<(String, Module)> {
    let steps = |path: &str| -> Module {
        path.split("::")
            .map(|step| step.trim().to_owned())
            .filter(|step| !step.is_empty())
            .collect()
    };
    let Some((prefix, branches)) = tree.split_once('{') else {
        let (path, alias) = tree.split_once(" as ").unwrap_or((tree, ""));
        let mut path = steps(path);
        path.pop_if(|last| last == "self");
        let last = path.last().cloned().unwrap_or_default();
        return vec![(if alias.is_empty() { last } else { alias.trim().to_owned() }, path)];
    };
    let branches = branches.trim_end().strip_suffix('}').unwrap_or(branches);
    let (mut found, mut depth, mut begin) = (Vec::new(), 0, 0);
    let ends = branches.char_indices().chain([(branches.len(), ',')]);
    for (place, c) in ends {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let branch = branches[begin..place].trim();
                if !branch.is_empty() {
                    found.extend(names(branch).into_iter().map(|(name, path)| {
                        let whole: Module = steps(prefix).into_iter().chain(path).collect();
                        let name = if name.is_empty() {
                            whole.last().cloned().unwrap_or_default()
                        } else {
                            name
                        };
                        (name, whole)
                    }));
                }
                begin = place + 1;
            }
            _ => {}
        }
    }
    found
}

/// All paths in the code, with imports expanded.
fn paths(code: &str) -> Vec<Module> {
    let mut found: Vec<Module> = Vec::new();
    let mut own = code.to_owned();
    for (statement, tree) in use_statements(code) {
        found.extend(names(&tree).into_iter().map(|(_, path)| path));
        own = own.replace(&statement, "");
    }
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    for word in own.split(|c| !is_part(c)).filter(|word| word.contains("::")) {
        let path: Module =
            word.split("::").map(str::to_owned).take_while(|step| !step.is_empty()).collect();
        if path.len() > 1 && !path[0].contains(':') {
            found.push(path);
        }
    }
    found.retain(|path| !path.is_empty());
    found
}
