//! Every figure is drawn, small, and the report is opened.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use capwalk_paper::{ALL, Failure, Figure, Quality, Row, Settings, write};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // What an earlier run left.
    let _ = fs::remove_dir_all(&folder);
    folder
}

/// Everything there is in the report: a section, every claim, every image.
fn check_page(page: &str, figures: &[Figure]) {
    assert!(!page.contains("<script"), "the page needs no script");
    assert!(page.ends_with("</html>\n"));
    for raw in ["`", "± inf", "± NaN", "NaN ±"] {
        assert!(!page.contains(raw), "{raw} on the page");
    }
    for tag in ["table", "section", "figure", "div", "svg", "a"] {
        let opened =
            page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
        let closed = page.matches(&format!("</{tag}>")).count();
        assert_eq!(opened, closed, "<{tag}>");
    }
    let images: usize = figures
        .iter()
        .flat_map(|figure| &figure.rows)
        .map(|row| match row {
            Row::Images(shown) => shown.len(),
            Row::Plots(plots) => {
                plots.iter().for_each(|plot| {
                    assert!(
                        !plot.curves.is_empty() && plot.curves.iter().all(|c| c.points.len() > 1)
                    );
                });
                0
            }
        })
        .sum();
    assert_eq!(page.matches("class=\"image\"").count(), images);
    // Nothing is loaded from elsewhere, and every image can be decoded.
    for source in page.split(" src=\"").skip(1) {
        let source = source.split('"').next().unwrap_or("");
        let data = source.strip_prefix("data:image/png;base64,");
        let bytes = STANDARD.decode(data.expect("an image inside the page"));
        let bytes = bytes.expect("base64");
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .expect("a PNG file");
        let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
        reader.next_frame(&mut pixels).expect("all of its pixels");
        assert!(
            pixels.iter().any(|&p| p != pixels[0]),
            "an image of one colour"
        );
    }
    for figure in figures {
        assert!(page.contains(&format!("<section id=\"{}\">", figure.name)));
        assert!(!figure.claims.is_empty() && !figure.caption.is_empty());
        for claim in &figure.claims {
            // Once in the table of all claims, once in its section.
            let text = claim.statement.replace('&', "&amp;").replace('<', "&lt;");
            assert_eq!(page.matches(&text).count(), 2, "{text}");
        }
    }
}

#[test]
fn every_figure_is_drawn() {
    let settings = Settings::new(Quality::Smoke);
    let drawn: Vec<Figure> = ALL
        .iter()
        .map(|entry| {
            let drawn = entry.draw(&settings);
            drawn.unwrap_or_else(|error| panic!("{}: {error}", entry.name))
        })
        .collect();
    let folder = folder("every_figure");
    let written = write(&drawn, &folder).expect("a folder for tests can be written to");
    let names: BTreeSet<&PathBuf> = written.iter().collect();
    assert_eq!(names.len(), written.len(), "a file is written twice");
    for path in &written {
        assert!(
            fs::metadata(path).expect("it was written").len() > 20,
            "{path:?}"
        );
    }
    for name in ["fig01", "fig09"] {
        let path = folder.join(format!("{name}-reach.csv"));
        let table = fs::read_to_string(path).expect("it was written");
        // Six reaches, two baselines, names of columns.
        assert_eq!(table.lines().count(), 9, "{table}");
    }
    // The sphere stands in for the bunny.
    let bunny = |figure: &Figure| (figure.title.to_owned() + &figure.caption).contains("bunny");
    assert!(!drawn.iter().any(bunny));
    let report = folder.join("report.html");
    let page = fs::read_to_string(&report).expect("it was written");
    check_page(&page, &drawn);
    open_in_browser(&folder, &page);
}

/// The page in a real browser, where there is one: no image is missing.
fn open_in_browser(folder: &Path, page: &str) {
    let names = [
        "chromium",
        "chromium-browser",
        "google-chrome",
        "chrome-headless-shell",
    ];
    let starts = |name: &str| {
        let answer = Command::new(name).arg("--version").output();
        answer.is_ok_and(|answer| answer.status.success())
    };
    let given = std::env::var("CAPWALK_BROWSER").ok();
    if let Some(name) = &given {
        assert!(
            starts(name),
            "CAPWALK_BROWSER is {name}, which does not start"
        );
    }
    let found = given
        .as_deref()
        .or_else(|| names.into_iter().find(|name| starts(name)));
    let Some(browser) = found else {
        println!(
            "SKIPPED: no browser ({}), and CAPWALK_BROWSER is not set",
            names.join(", ")
        );
        return;
    };
    // The page itself has no script: a copy counts what the browser shows.
    let counting = "<script>addEventListener('load', () => { \
        const all = [...document.images]; \
        const shown = all.filter(i => i.complete && i.naturalWidth > 0 && i.getBoundingClientRect().width > 0); \
        const drawn = [...document.querySelectorAll('svg')].filter(s => s.getBBox().width > 0); \
        document.title = `shown ${shown.length} of ${all.length}, drawn ${drawn.length}, \
            wider ${document.documentElement.scrollWidth > innerWidth}`; });</script></body>";
    let copy = folder.join("counting.html");
    fs::write(&copy, page.replace("</body>", counting)).expect("it can be written");
    let answer = Command::new(browser)
        .args([
            "--headless",
            "--disable-gpu",
            "--no-sandbox",
            "--virtual-time-budget=20000",
        ])
        .arg("--dump-dom")
        .arg(format!("file://{}", copy.display()))
        .output()
        .expect("it said its version");
    let dom = String::from_utf8_lossy(&answer.stdout);
    let [images, plots] = [page.matches("<img ").count(), page.matches("<svg ").count()];
    let expected = format!("<title>shown {images} of {images}, drawn {plots}, wider false</title>");
    let title = dom
        .split("<title>")
        .nth(1)
        .unwrap_or("")
        .split("</title>")
        .next();
    assert!(dom.contains(&expected), "{expected}, found {title:?}");
}

#[test]
fn stopped_figures_are_errors() {
    struct Impatient;
    impl capwalk_diff::Watch for Impatient {
        fn progress(&self, _: u64, _: u64) {}
        fn should_stop(&self) -> bool {
            true
        }
    }
    let settings = Settings {
        stages: &|_| Box::new(Impatient),
        ..Settings::new(Quality::Smoke)
    };
    for entry in &ALL {
        let failure = entry.draw(&settings).expect_err("it was stopped");
        assert_eq!(failure, Failure::Stopped, "{}", entry.name);
    }
}
