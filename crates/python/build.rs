//! Linker arguments that macOS needs for a module without the interpreter.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
