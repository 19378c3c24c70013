//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.
