//! The book as mdBook builds it: whole, and in need of no network.

use html5gum::{Token, Tokenizer};
use speed_and_accuracy::STUDIES;
use speed_and_accuracy::study::Study;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

mod build;

#[test]
fn the_built_book_needs_no_network_and_has_no_loose_ends() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    if !build::book(folder.path()) {
        return;
    }

    let mut problems = Vec::new();
    let files = files_in(folder.path());
    let built_pages: BTreeMap<_, _> = with_ending(&files, "html")
        .map(|file| (file, Page::read(file)))
        .collect();
    for (file, page) in &built_pages {
        check_page(file, page, &built_pages, &mut problems);
    }
    for study in STUDIES {
        check_charts(study, &built_pages, &mut problems);
    }
    for file in with_ending(&files, "css") {
        let css = fs::read_to_string(file).expect("a style sheet");
        for url in css_urls(&css) {
            check_asset(file, url, &mut problems);
        }
    }
    assert!(problems.is_empty(), "\n{}\n", problems.join("\n"));
}

/// A built page, as far as it is checked.
struct Page {
    text: String,
    tags: Vec<(String, BTreeMap<String, String>)>,
}

impl Page {
    fn read(file: &Path) -> Self {
        let text = fs::read_to_string(file).expect("a page");
        let tags = Tokenizer::new(&text)
            .filter_map(|Ok(token)| match token {
                Token::StartTag(tag) => Some(tag),
                _ => None,
            })
            .map(|tag| {
                let string = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
                let attributes = tag
                    .attributes
                    .iter()
                    .map(|(name, value)| (string(name), string(value)));
                (string(&tag.name), attributes.collect())
            })
            .collect();
        Self { text, tags }
    }

    fn has_id(&self, id: &str) -> bool {
        self.tags
            .iter()
            .any(|(_, attributes)| attributes.get("id").is_some_and(|it| it == id))
    }
}

fn check_page(
    file: &Path,
    page: &Page,
    pages: &BTreeMap<&PathBuf, Page>,
    problems: &mut Vec<String>,
) {
    for left in ["{{#", "$$"] {
        if page.text.contains(left) {
            problems.push(format!("{}: {left} is left", file.display()));
        }
    }
    for (tag, attributes) in &page.tags {
        if tag == "img"
            && attributes
                .get("alt")
                .is_none_or(|alt| alt.trim().is_empty())
        {
            problems.push(format!(
                "{}: {attributes:?} has no alt text",
                file.display()
            ));
        }
        if let Some(style) = attributes.get("style") {
            css_urls(style).for_each(|url| check_asset(file, url, problems));
        }
        if let Some(url) = attributes.get("src") {
            check_asset(file, url, problems);
        }
        match attributes.get("href") {
            Some(url) if ["link", "image"].contains(&tag.as_str()) => {
                check_asset(file, url, problems)
            }
            Some(url) if tag == "a" => check_link(file, url, pages, problems),
            _ => (),
        }
    }
}

/// A study's charts are whole on every page that asks for them, and so in the book for print.
fn check_charts(
    study: &Study,
    pages: &BTreeMap<&PathBuf, Page>,
    problems: &mut Vec<String>,
) {
    let book = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../src"));
    let svg = Page::read(&book.join(format!("studies/{}.svg", study.name)));
    let command = format!("{{{{#chart {}}}}}", study.name);
    for (file, page) in pages {
        let name = Path::new(file.file_name().expect("a name"));
        let source = fs::read_to_string(book.join(name.with_extension("md")));
        let is_asked = source.is_ok_and(|source| source.contains(&command));
        let mut parts = page.tags.windows(svg.tags.len());
        let is_there = parts.any(|tags| tags == svg.tags);
        if (is_asked || name == "print.html") && !is_there {
            let problem = format!("{}: no {}.svg", file.display(), study.name);
            problems.push(problem);
        }
    }
}

/// What a page is made of comes with it.
fn check_asset(file: &Path, url: &str, problems: &mut Vec<String>) {
    if is_remote(url) {
        problems.push(format!("{} fetches {url}", file.display()));
    } else if !url.starts_with("data:") && !file.with_file_name(url).is_file() {
        problems.push(format!("{}: {url} does not exist", file.display()));
    }
}

/// A link within the book leads somewhere; others are for the reader to follow.
fn check_link(
    file: &Path,
    url: &str,
    pages: &BTreeMap<&PathBuf, Page>,
    problems: &mut Vec<String>,
) {
    if is_remote(url) || url.starts_with("mailto:") {
        return;
    }
    let (path, id) = url.split_once('#').unwrap_or((url, ""));
    let target = if path.is_empty() {
        file.to_path_buf()
    } else {
        file.with_file_name(path)
    };
    let found = match pages.get(&target) {
        Some(page) => id.is_empty() || page.has_id(id),
        None => id.is_empty() && target.is_file(),
    };
    if !found {
        problems.push(format!("{}: the link {url} leads nowhere", file.display()));
    }
}

fn is_remote(url: &str) -> bool {
    ["http:", "https:", "//"]
        .iter()
        .any(|start| url.starts_with(start))
}

/// What a style sheet fetches, by `url(…)` or `@import "…"`.
fn css_urls(css: &str) -> impl Iterator<Item = &str> {
    let urls = css
        .split("url(")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let imports = css
        .split("@import")
        .skip(1)
        .filter_map(|rest| rest.split(';').next());
    let imports = imports.filter(|import| !import.contains("url("));
    urls.chain(imports)
        .map(|url| url.trim().trim_matches(['"', '\'']))
}

fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .flat_map(|path| {
            if path.is_dir() {
                files_in(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}

fn with_ending<'a>(
    files: &'a [PathBuf],
    ending: &'a str,
) -> impl Iterator<Item = &'a PathBuf> {
    files
        .iter()
        .filter(move |file| file.extension().is_some_and(|it| it == ending))
}
