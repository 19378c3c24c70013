//! Known answers, laws, damage, stop.
