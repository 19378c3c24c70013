//! What a subject's label counts as: its class.

/// The class of a label, by which subjects are classified, and its shape and colour in every view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LabelRole {
    /// A healthy subject: a circle.
    Normal,
    /// An ill subject: a cross.
    Abnormal,
    /// No label, or one that takes no part: a square.
    #[default]
    Unknown,
}

/// Which labels of a study count as normal and which as abnormal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelRoles {
    /// Labels of healthy subjects.
    pub normal: Vec<String>,
    /// Labels of ill subjects.
    pub abnormal: Vec<String>,
}

impl Default for LabelRoles {
    fn default() -> Self {
        Self {
            normal: vec!["normal".to_owned()],
            abnormal: vec!["abnormal".to_owned()],
        }
    }
}

impl LabelRoles {
    /// The role of a label; letter case and blanks do not matter.
    pub fn role(&self, label: Option<&str>) -> LabelRole {
        let Some(label) = label else {
            return LabelRole::Unknown;
        };
        let label = plain_label(label);
        let named = |list: &[String]| list.iter().any(|name| plain_label(name) == label);
        if named(&self.normal) {
            LabelRole::Normal
        } else if named(&self.abnormal) {
            LabelRole::Abnormal
        } else {
            LabelRole::Unknown
        }
    }

    /// Gives a label a role, however it is spelled in the lists.
    pub(super) fn set(&mut self, label: &str, role: LabelRole) {
        let plain = plain_label(label);
        for list in [&mut self.normal, &mut self.abnormal] {
            list.retain(|known| plain_label(known) != plain);
        }
        match role {
            LabelRole::Normal => self.normal.push(label.to_owned()),
            LabelRole::Abnormal => self.abnormal.push(label.to_owned()),
            LabelRole::Unknown => {}
        }
    }
}

/// A label without what does not matter: letter case and blanks.
pub fn plain_label(label: &str) -> String {
    label.split_whitespace().collect::<String>().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_that_no_rule_names_take_no_part() {
        let roles = LabelRoles {
            normal: vec!["NOR".to_owned()],
            abnormal: vec!["MINF".to_owned()],
        };
        assert_eq!(roles.role(Some("nor")), LabelRole::Normal);
        assert_eq!(roles.role(Some(" No r ")), LabelRole::Normal);
        assert_eq!(roles.role(Some("MINF")), LabelRole::Abnormal);
        assert_eq!(roles.role(Some("RV")), LabelRole::Unknown);
        assert_eq!(roles.role(None), LabelRole::Unknown);
    }
}
