//! `bindgen MODULE FOLDER [--test]`: writes the JavaScript side of a module compiled to WebAssembly,
//! for a browser, and the module for it. `--test`: the module is a test program, whose files are
//! named `tests` and whose function names are kept.

use std::env::args;
use std::error::Error;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = args().skip(1).collect();
    let (module, folder, test) = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [module, folder] => (module, folder, false),
        [module, folder, "--test"] => (module, folder, true),
        _ => return Err("usage: bindgen MODULE FOLDER [--test]".into()),
    };
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(module)
        .out_name(if test { "tests" } else { "shape_up" })
        .web(true)?
        .typescript(!test)
        // The module is beside its JavaScript side.
        .omit_default_module_path(false)
        // The runner calls the tests itself.
        .emit_start(!test)
        // The names of functions are most of what can be stripped.
        .remove_name_section(!test)
        .remove_producers_section(!test)
        .generate(folder)?;
    Ok(())
}
