//! Tests of the mesh formats together: files of other programs, round trips, damage.

mod damage;
mod other_programs;
mod round_trips;
