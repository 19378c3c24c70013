//! Laws of curves, maps and distances of whole deformations.
