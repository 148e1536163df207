//! A stranger who has the built book and nothing else. They turn its pages, and do what the pages
//! say: put each listing where it belongs, type each command, and compare what their programs
//! draw with the book's pictures. If they get stuck, so would a reader.

use html5gum::{StartTag, Token, Tokenizer};
use std::fs;
use std::path::Path;
use std::process::Command;

mod build;

#[test]
fn a_stranger_gets_every_picture_by_following_the_pages() {
    let book = tempfile::tempdir().expect("a temporary folder");
    if !build::book(book.path()) {
        return;
    }
    let done = follow(book.path(), None).unwrap_or_else(|problem| panic!("{problem}"));
    assert!(
        done.pictures >= 24 && done.listings.len() > 100,
        "the stranger found only {} pictures and {} listings",
        done.pictures,
        done.listings.len()
    );
}

/// The stranger must notice each of them: what is not needed should not be on the page.
#[test]
#[ignore = "it takes half an hour: for every listing of chapters 0 to 5, the stranger leaves it out"]
fn no_listing_can_be_left_out() {
    let book = tempfile::tempdir().expect("a temporary folder");
    if !build::book(book.path()) {
        return;
    }
    let done = follow(book.path(), None).unwrap_or_else(|problem| panic!("{problem}"));
    let is_early =
        |page: &str| ["00", "01", "02", "03", "04", "05"].contains(&&page[..2]);
    let early = (0..done.listings.len()).filter(|&i| is_early(&done.listings[i].0));
    let mut red = 0;
    let mut superfluous = Vec::new();
    for i in early {
        let (page, file) = &done.listings[i];
        match follow(book.path(), Some(i)) {
            Ok(_) => superfluous.push(format!("{page}: a listing of {file}")),
            Err(problem) => {
                red += 1;
                let stuck = problem.lines().next().unwrap_or_default();
                println!("{page}: without listing {i}, of {file}: {stuck}");
            }
        }
    }
    println!(
        "{red} of {} turned the stranger red",
        red + superfluous.len()
    );
    assert!(superfluous.is_empty(), "\n{}\n", superfluous.join("\n"));
}

/// What the stranger has done.
#[derive(Default)]
struct Done {
    /// The page and the file of every listing.
    listings: Vec<(String, String)>,
    /// How many of their pictures were the book's.
    pictures: usize,
    /// How many tests the pages have them write.
    tests: usize,
}

/// Follows the pages from the first to the last, in an empty folder, but for the listing of the
/// number that is `left_out`. Returns where the stranger got stuck, if they did.
fn follow(book: &Path, left_out: Option<usize>) -> Result<Done, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let project = folder.path().join("tracer");
    fs::create_dir_all(project.join("pictures")).expect("an empty folder");
    let mut done = Done::default();
    let mut next = Some("index.html".to_string());
    while let Some(name) = next {
        let page = Page::read(&book.join(&name));
        let mut place: Option<(String, String)> = None;
        for part in &page.parts {
            let stuck = |problem: String| format!("{name}: {problem}");
            match part {
                Part::Paragraph { text, code, links } => {
                    place = code.first().and_then(|file| {
                        let place = text.strip_prefix(&format!("{file}, "))?;
                        Some((file.clone(), place.trim_end_matches(':').to_string()))
                    });
                    let pictures =
                        links.iter().filter(|link| link.starts_with("pictures/"));
                    let pictures: Vec<&String> = pictures.collect();
                    for picture in &pictures {
                        let kept = project.join(picture);
                        let folder = kept.parent().expect("a folder");
                        fs::create_dir_all(folder).expect("a folder");
                        fs::copy(book.join(picture), &kept).expect("the book's picture");
                    }
                    let picture = pictures.first();
                    if let (true, [file, ..], Some(picture)) =
                        (text.contains("the same as"), &code[..], picture)
                    {
                        compare(&project.join(file), &book.join(picture))
                            .map_err(stuck)?;
                        done.pictures += 1;
                    }
                }
                Part::Code { language, text } if language == "console" => {
                    for command in text
                        .lines()
                        .filter_map(|line| line.strip_prefix("tracer$ "))
                    {
                        run(&project, command).map_err(stuck)?;
                    }
                }
                Part::Code { text, .. } => {
                    let Some((file, place)) = place.take() else {
                        continue;
                    };
                    done.tests += text.matches("#[test]").count();
                    if left_out != Some(done.listings.len()) {
                        put(&project.join(&file), &place, text).map_err(stuck)?;
                    }
                    done.listings.push((name.clone(), file));
                }
            }
        }
        next = page.next;
    }
    // All of it is clean, and every test that the stranger has written passes.
    run(&project, "cargo fmt --all --check")?;
    run(
        &project,
        "cargo clippy --workspace --all-targets -- -D warnings",
    )?;
    let said = run(&project, "cargo test --workspace")?;
    let passed = said.matches(" ... ok").count();
    if passed != done.tests {
        return Err(format!("{passed} of {} tests passed:\n{said}", done.tests));
    }
    Ok(done)
}

/// Puts a listing into a file, where the page says.
fn put(file: &Path, place: &str, listing: &str) -> Result<(), String> {
    let old = fs::read_to_string(file);
    let text = match place {
        "new" => format!("{}\n", listing.trim_end()),
        "at the end" => {
            let old = old.map_err(|problem| format!("{}: {problem}", file.display()))?;
            format!("{old}\n{}\n", listing.trim_end())
        }
        _ => return Err(format!("{}: where is “{place}”?", file.display())),
    };
    fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    fs::write(file, text).map_err(|problem| problem.to_string())
}

/// Runs a command of the page's in the stranger's project, without a network or a display.
/// Returns what it says.
fn run(project: &Path, command: &str) -> Result<String, String> {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stranger");
    let output = Command::new("sh")
        .args(["-c", command])
        .current_dir(project)
        .env("CARGO_TARGET_DIR", target)
        .env("CARGO_NET_OFFLINE", "true")
        .env("CARGO_INCREMENTAL", "0")
        .env_remove("DISPLAY")
        .output()
        .map_err(|problem| format!("{command}: {problem}"))?;
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    match output.status.success() {
        true => Ok(said),
        false => Err(format!("{command}\n{said}")),
    }
}

/// Compares two pictures, pixel by pixel.
fn compare(mine: &Path, book: &Path) -> Result<(), String> {
    let [mine, book] = [mine, book].map(|path| {
        let image = image::open(path);
        image.map_err(|problem| format!("{}: {problem}", path.display()))
    });
    let [mine, book] = [mine?.into_rgb8(), book?.into_rgb8()];
    match mine == book {
        true => Ok(()),
        false => Err("the picture is not the book's".to_string()),
    }
}

/// A page, as far as a reader follows it.
struct Page {
    parts: Vec<Part>,
    /// The page that the arrow at its right leads to.
    next: Option<String>,
}

enum Part {
    Paragraph {
        text: String,
        code: Vec<String>,
        links: Vec<String>,
    },
    Code {
        language: String,
        text: String,
    },
}

impl Page {
    fn read(file: &Path) -> Self {
        let html = fs::read_to_string(file)
            .unwrap_or_else(|problem| panic!("{}: {problem}", file.display()));
        let (mut parts, mut next) = (Vec::new(), None);
        let mut open: Vec<(String, Option<String>)> = Vec::new();
        for Ok(token) in Tokenizer::new(&html) {
            match token {
                Token::StartTag(tag) => {
                    let name = string(&tag.name);
                    let attribute = |name| attribute(&tag, name);
                    if attribute("rel").is_some_and(|rel| rel.contains("next")) {
                        next = attribute("href");
                    }
                    match (name.as_str(), parts.last_mut()) {
                        ("p", _) => parts.push(Part::Paragraph {
                            text: String::new(),
                            code: Vec::new(),
                            links: Vec::new(),
                        }),
                        ("code", _) if is_open(&open, "pre") => parts.push(Part::Code {
                            language: attribute("class")
                                .and_then(|class| {
                                    let mut words = class.split(' ');
                                    words.find_map(|word| {
                                        Some(word.strip_prefix("language-")?.to_string())
                                    })
                                })
                                .unwrap_or_default(),
                            text: String::new(),
                        }),
                        ("code", Some(Part::Paragraph { code, .. }))
                            if is_open(&open, "p") =>
                        {
                            code.push(String::new());
                        }
                        ("a", Some(Part::Paragraph { links, .. }))
                            if is_open(&open, "p") =>
                        {
                            links.extend(attribute("href"));
                        }
                        _ => (),
                    }
                    if !tag.self_closing
                        && !["br", "img", "hr", "meta", "link", "input"]
                            .contains(&name.as_str())
                    {
                        open.push((name, attribute("class")));
                    }
                }
                Token::EndTag(tag) => {
                    let name = string(&tag.name);
                    if let Some(i) = open.iter().rposition(|(open, _)| *open == name) {
                        open.truncate(i);
                    }
                }
                Token::String(text) => {
                    // What a page hides is not there to be copied.
                    let is_hidden = open.iter().any(|(_, class)| {
                        class.as_ref().is_some_and(|class| class == "boring")
                    });
                    let new = string(&text);
                    match parts.last_mut() {
                        Some(Part::Code { text, .. })
                            if is_open(&open, "pre") && !is_hidden =>
                        {
                            *text += &new;
                        }
                        Some(Part::Paragraph { text, code, .. })
                            if is_open(&open, "p") =>
                        {
                            *text += &new;
                            if let (true, Some(code)) =
                                (is_open(&open, "code"), code.last_mut())
                            {
                                *code += &new;
                            }
                        }
                        _ => (),
                    }
                }
                _ => (),
            }
        }
        Self { parts, next }
    }
}

fn is_open(open: &[(String, Option<String>)], name: &str) -> bool {
    open.iter().any(|(open, _)| open == name)
}

fn attribute(tag: &StartTag<()>, name: &str) -> Option<String> {
    tag.attributes
        .get(name.as_bytes())
        .map(|value| string(value))
}

fn string(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
