//! Preparation of an image: all settings of an import in one value, and the road from the image to walls by it.
//!
//! Begin with [`Preparation`], what somebody sets, and [`prepared`], what comes of it. In stages: [`stated_image`] gives the
//! image the distances and times that were typed, [`segmented`] finds the tissues, [`walls`] makes the surfaces.
//! [`preview`] shows at once what a threshold and edits leave.
