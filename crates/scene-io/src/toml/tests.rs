use super::*;

fn document(text: &str) -> Result<Document, LoadError> {
    Document::parse("job.toml", "folder".into(), text.into())
}

fn good(text: &str) -> Document {
    document(text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn values_are_read() {
    let file = good(
        "a = \"x\"\nb = 1_000\nc = [[1, 2.5], [3, 4]]\nd = true\n[t]\nu = 0x10\n[[w]]\n[[w]]\n",
    );
    let root = file.root();
    assert_eq!(root.get("a").expect("there").text(), Ok("x"));
    assert_eq!(root.get("b").expect("there").integer(0..=5000), Ok(1000));
    let c = root.get("c").expect("there");
    assert_eq!(c.array("four"), Ok([1.0, 2.5, 3.0, 4.0]));
    assert_eq!(root.get("d").expect("there").truth(), Ok(true));
    let table = root.table("t").expect("a table").expect("there");
    assert_eq!(table.get("u").expect("there").integer(0..=16), Ok(16));
    assert_eq!(root.tables("w").expect("tables").len(), 2);
    assert!(root.get("missing").is_none());
    assert_eq!(root.finish(), Ok(()));
    assert_eq!(file.path("a.exr"), Path::new("folder/a.exr"));
}

#[track_caller]
fn fails<T: std::fmt::Debug>(result: Result<T, LoadError>, expected: &str) {
    assert_eq!(result.expect_err(expected).to_string(), expected);
}

#[test]
fn errors_have_places() {
    fails(
        document("a = \n"),
        "job.toml:1:5: string values must be quoted, expected literal string\n  \
         expected a text in TOML 1.1",
    );
    let file = good("[optimizer]\nlearning = 1\nbeta = [0.9, \"x\"]\n");
    let table = file.root().table("optimizer").expect("a table");
    let table = table.expect("there");
    let betas = table.get("beta").expect("there").numbers();
    fails(
        betas,
        "job.toml:3:14: `beta` is \"x\"\n  expected finite numbers",
    );
    table.get("lr");
    table.get("learning_rate");
    fails(
        table.finish(),
        "job.toml:2:1: unknown key `learning` in [optimizer]\n  expected one of: beta, \
         learning_rate, lr",
    );
    fails(
        table.require("eps", "a number").map(|_| ()),
        "job.toml:1:1: `eps` is missing in [optimizer]\n  expected a number",
    );
}

#[test]
fn near_keys_and_words_are_suggested() {
    let file = good("iteratons = 3\nloss = \"l3\"\n");
    let root = file.root();
    root.get("iterations");
    let loss = root.get("loss").expect("there");
    fails(
        loss.choice(&[("l1", 1), ("l2", 2)]),
        "job.toml:2:8: `loss` is \"l3\"\n  expected one of \"l1\", \"l2\"",
    );
    fails(
        root.finish(),
        "job.toml:1:1: unknown key `iteratons` in the file\n  expected one of: iterations, \
         loss\n  did you mean \"iterations\"?",
    );
}
