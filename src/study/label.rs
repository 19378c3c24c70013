//! What a subject's label counts as: its class.

/// The class of a label, by which subjects are classified, and its shape and colour in every view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LabelClass {
    /// A healthy subject: a circle.
    Normal,
    /// An ill subject: a cross.
    Abnormal,
    /// No label, or one that takes no part: a square.
    #[default]
    Neither,
}

/// Which labels of a study count as normal and which as abnormal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelClasses {
    /// Labels of healthy subjects.
    pub normal: Vec<String>,
    /// Labels of ill subjects.
    pub abnormal: Vec<String>,
}

impl Default for LabelClasses {
    fn default() -> Self {
        Self {
            normal: vec!["normal".to_owned()],
            abnormal: vec!["abnormal".to_owned()],
        }
    }
}

impl LabelClasses {
    /// Of a label; letter case and blanks do not matter.
    pub fn class_of(&self, label: Option<&str>) -> LabelClass {
        let Some(label) = label else {
            return LabelClass::Neither;
        };
        let label = plain_label(label);
        let named = |list: &[String]| list.iter().any(|name| plain_label(name) == label);
        if named(&self.normal) {
            LabelClass::Normal
        } else if named(&self.abnormal) {
            LabelClass::Abnormal
        } else {
            LabelClass::Neither
        }
    }

    /// Gives a label a class, however it is spelled in the lists.
    pub(super) fn set(&mut self, label: &str, class: LabelClass) {
        let plain = plain_label(label);
        for list in [&mut self.normal, &mut self.abnormal] {
            list.retain(|known| plain_label(known) != plain);
        }
        match class {
            LabelClass::Normal => self.normal.push(label.to_owned()),
            LabelClass::Abnormal => self.abnormal.push(label.to_owned()),
            LabelClass::Neither => {}
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
        let classes = LabelClasses {
            normal: vec!["NOR".to_owned()],
            abnormal: vec!["MINF".to_owned()],
        };
        assert_eq!(classes.class_of(Some("nor")), LabelClass::Normal);
        assert_eq!(classes.class_of(Some(" No r ")), LabelClass::Normal);
        assert_eq!(classes.class_of(Some("MINF")), LabelClass::Abnormal);
        assert_eq!(classes.class_of(Some("RV")), LabelClass::Neither);
        assert_eq!(classes.class_of(None), LabelClass::Neither);
    }
}
