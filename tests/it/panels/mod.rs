//! Panels seen from outside: as pictures for the eye, and as text that must not overlap.

mod example;
mod gallery;
mod layout;
mod window;
