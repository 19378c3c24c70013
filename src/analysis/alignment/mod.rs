//! Which rigid motion or similarity carries one pose onto another?
