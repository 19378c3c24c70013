//! Columns that several tables have, each with its words once.

use super::column::{Cell, Column, column};

/// Whom a row is about.
pub(super) const fn subject<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("subject", "Subject", cell).plain("Pseudonym of the subject")
}

/// What the study says of the subject.
pub(super) const fn label<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("label", "Label", cell)
        .plain("Label that the study gives the subject; empty without one")
}

/// At which frame.
pub(super) const fn frame<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("frame", "Frame", cell).plain("Frame, numbered from 0")
}

/// Unit of the volumes of a row.
pub(super) const fn volume_unit<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("volume_unit", "Unit", cell)
        .plain("Unit of the volumes: ml where coordinates are in mm, else units³")
}

/// First coordinate on a map.
pub(super) const fn map_x<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("x", "Map x", cell).coordinate("First coordinate on the map")
}

/// Second coordinate on a map.
pub(super) const fn map_y<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("y", "Map y", cell).coordinate("Second coordinate on the map")
}

/// x of the centre of an inscribed sphere.
pub(super) const fn centre_x<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("x", "Centre x", cell).length("x of the centre of the inscribed sphere")
}

/// Its y.
pub(super) const fn centre_y<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("y", "Centre y", cell).length("y of the centre of the inscribed sphere")
}

/// Its z.
pub(super) const fn centre_z<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("z", "Centre z", cell).length("z of the centre of the inscribed sphere")
}

/// Radius of an inscribed sphere.
pub(super) const fn radius<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("r", "Radius", cell).length("Radius of the inscribed sphere, half of the wall thickness")
}

/// What is compared in an experiment.
pub(super) const fn method<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("method", "Method", cell).plain("Metric and form")
}

/// Kind of synthetic object in an experiment.
pub(super) const fn object<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("object", "Object", cell).plain("Kind of object")
}

/// Kind of synthetic deformation in an experiment.
pub(super) const fn motion<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("motion", "Motion", cell).plain("Kind of deformation")
}

/// Of which distribution the noise of an experiment is.
pub(super) const fn noise_family<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("family", "Noise", cell).plain("Distribution of the noise, or clean")
}
