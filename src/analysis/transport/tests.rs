//! Laws of transport.
