//! By which column the cohort table is ordered.

/// A column of the cohort table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CohortColumn {
    /// Shape of the label's class.
    Class,
    /// Pseudonym.
    #[default]
    Subject,
    /// Free label.
    Label,
    /// Ejection fraction.
    EjectionFraction,
    /// Verdict; sorted by the predicted probability of abnormal.
    Verdict,
}

/// Order of the cohort table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CohortSort {
    /// Column by which rows are ordered.
    pub column: CohortColumn,
    /// Greatest first.
    pub descending: bool,
}
