//! Questions about one subject, while the study is edited.

use super::*;

/// The name of a subject. It may fail to say which subject it depends on.
#[derive(Clone, Debug, PartialEq)]
struct Name {
    subject: usize,
    says_whose: bool,
}

impl Query for Name {
    type Answer = String;
    const TITLE: &'static str = "Name of a subject";

    fn depends_on(&self, study: &Study) -> Dependencies {
        if self.says_whose {
            Dependencies::shapes(study, [self.subject])
        } else {
            Dependencies::study(study)
        }
    }

    fn run(&self, cx: &Context<'_>) -> Result<String, Interrupted> {
        Ok(cx.study().subjects[self.subject].id.clone())
    }

    fn memory(answer: &String, memory: &mut Memory) {
        memory.own(answer.len());
    }

    fn replaces(&self, other: &Self) -> bool {
        self.subject == other.subject
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.subject]
    }
}

#[test]
fn an_answer_about_one_subject_never_stands_under_another_after_an_edit() {
    let [a, b] = ["a", "b"].map(|id| {
        Arc::new(Subject {
            id: id.to_owned(),
            ..subject()
        })
    });
    for says_whose in [true, false] {
        let name = |subject| Name {
            subject,
            says_whose,
        };
        let (store, both) = (store(), Study::default());
        let both = Arc::new(Study {
            subjects: vec![Arc::clone(&a), Arc::clone(&b)],
            revision: Revision(1),
            ..both
        });
        assert_eq!(*until_ready(&store, &both, &name(1)), "b");
        let labelled = edited(&both, |subject| subject.label = Some("MINF".to_owned()));
        store.follow(&labelled);
        assert!(store.ask(&labelled, &name(0)).latest().is_none());
        let known = store.ask(&labelled, &name(1)).ready().cloned();
        assert_eq!(
            known.as_deref().map(String::as_str),
            says_whose.then_some("b")
        );
        let alone = Arc::new(Study {
            subjects: vec![Arc::clone(&b)],
            revision: Revision(3),
            ..Study::default()
        });
        store.follow(&alone);
        let known = store.ask(&alone, &name(0)).ready().cloned();
        assert_eq!(
            known.as_deref().map(String::as_str),
            says_whose.then_some("b")
        );
    }
}
