//! The program without a window: what it says.

use super::{App, Host};
use crate::viewer::{jobs::Answer, options::Options};
use std::sync::Arc;

#[test]
fn where_no_dialog_can_be_shown_the_advice_is_about_what_was_asked() {
    let mut app = App::start(Options::default(), Arc::new(drop), Host::Picture);
    app.answered(Answer::NoneToOpen);
    app.answered(Answer::NoneToSave);
    let told: Vec<_> = app
        .notices
        .iter()
        .map(|notice| notice.text.as_str())
        .collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[0].contains("drop files"), "{told:?}");
    assert!(
        told[1].starts_with("nothing is saved") && !told[1].contains("drop files"),
        "{told:?}"
    );
}
