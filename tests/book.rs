//! The book's source: its listings are the chapters' code, and its pictures exist.

use canvas::Stage;
use preprocessor::{drawings, measured, studies};
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd};
use serde_json::Value;
use stages::STAGES;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

mod the_source {
    use super::*;

    #[test]
    fn has_every_page_of_the_summary_and_every_chapter_in_order() {
        let mut problems = Vec::new();
        for page in pages() {
            if !book().join(&page).is_file() {
                problems.push(format!("SUMMARY.md lists {page}, which does not exist"));
            }
        }
        let chapters = STAGES.map(page_of);
        let listed: Vec<_> = pages()
            .into_iter()
            .filter(|page| chapters.contains(page))
            .collect();
        if listed != chapters {
            problems.push(format!(
                "SUMMARY.md lists {listed:?}, but the chapters are {chapters:?}"
            ));
        }
        none(&problems);
    }

    #[test]
    fn includes_only_what_exists() {
        let mut problems = Vec::new();
        for page in pages() {
            for command in commands(&read(&page), "include") {
                if let Err(problem) = included(&command) {
                    problems.push(format!("{page}: {problem}"));
                }
            }
        }
        none(&problems);
    }

    #[test]
    fn lists_every_line_of_every_chapters_library() {
        let mut problems = Vec::new();
        // The canvas grows on several pages.
        let texts = pages().into_iter().map(|page| read(&page));
        let includes: Vec<_> =
            texts.flat_map(|text| commands(&text, "include")).collect();
        for stage in STAGES {
            let library = format!("../../chapters/{}/src/lib.rs", stage.name);
            let listed: BTreeSet<usize> = includes
                .iter()
                .filter(|command| command.split(':').next() == Some(&library))
                .filter_map(|command| included(command).ok())
                .flatten()
                .collect();
            let mut is_ours = false;
            for (number, line) in (1..).zip(read(&library).lines()) {
                if is_anchor(line) {
                    is_ours = anchor_in(line, "ANCHOR:") == Some(OURS);
                } else if !line.trim().is_empty() && !is_ours && !listed.contains(&number)
                {
                    problems.push(format!(
                        "{} does not list {library}:{number}: {line}",
                        page_of(stage)
                    ));
                }
            }
        }
        none(&problems);
    }

    /// A file, and a place in it: of every listing that a reader copies, up to chapter 11.
    #[test]
    fn says_of_every_listing_where_it_goes() {
        let mut problems = Vec::new();
        for stage in &STAGES[..12] {
            let page = read(&page_of(stage));
            let mut before = "";
            for line in page.lines().filter(|line| !line.is_empty()) {
                if line.starts_with("{{#include ../../chapters/")
                    && !line.contains("/exercises.rs:")
                    && !(before.starts_with("**`")
                        && (before.ends_with("`**, new:")
                            || before.ends_with("`**, at the end:")))
                {
                    problems
                        .push(format!("{}: where does it go? {line}", page_of(stage)));
                }
                if line != "```rust" {
                    before = line;
                }
            }
        }
        none(&problems);
    }

    /// A reader's project imports what ours does.
    #[test]
    fn names_the_versions_that_the_manifest_names() {
        let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("a manifest");
        let manifest: toml::Table = manifest.parse().expect("a manifest");
        let ours = &manifest["workspace"]["dependencies"];
        let (mut count, mut problems) = (0, Vec::new());
        for page in pages() {
            let text = read(&page);
            let commands = text
                .lines()
                .filter(|line| line.starts_with("tracer$ cargo add"));
            let words = commands.flat_map(str::split_whitespace);
            for (name, version) in words.filter_map(|word| word.split_once('@')) {
                count += 1;
                let known = &ours[name];
                let known = known.get("version").unwrap_or(known).as_str();
                if known != Some(version) {
                    problems.push(format!(
                        "{page}: {name}@{version}, but we import {known:?}"
                    ));
                }
            }
        }
        none(&problems);
        assert!(count > 12, "only {count} versions were found");
    }

    /// Nobody wants to wait for it longer, and the introduction before it is short, too.
    #[test]
    fn comes_to_the_first_ray_soon() {
        let [canvas, rays] =
            [page_of(STAGES[0]), page_of(STAGES[1])].map(|page| read(&page));
        let (before, _) = rays
            .split_once(
                "```rust\n{{#include ../../chapters/01-ray-casting/src/lib.rs:ray}}",
            )
            .expect("a listing of the first ray");
        let (words, _) =
            prose_and_listings(&(read("introduction.md") + &read("follow-along.md")));
        assert!(words <= 1800, "{words} words of introduction");
        let (words, lines) = prose_and_listings(&(canvas + before));
        assert!(
            words <= 900 && lines <= 90,
            "{words} words, {lines} lines of listings"
        );
    }

    /// Those of chapters 0 to 11, without the exercises.
    #[test]
    fn prints_as_many_lines_of_rust_as_the_introduction_says() {
        assert!(read("introduction.md").contains("some three thousand lines of Rust"));
        let chapters = STAGES[..12].iter().map(|stage| read(&page_of(stage)));
        let listings = chapters.flat_map(|page| {
            let (text, _) = page.split_once("\n## Exercises").expect("exercises");
            commands(text, "include")
        });
        let listings = listings.filter(|command| command.contains(".rs:"));
        let lines: usize = listings
            .map(|command| included(&command).expect("a listing").len())
            .sum();
        assert!((2_700..=3_300).contains(&lines), "{lines} lines");
    }

    /// Those of twelve that a reader looked for in vain, and of others that name what a page is
    /// about.
    #[test]
    fn has_the_words_that_readers_search_for() {
        const WORDS: &str = "gamma, bias, supersampling, checkerboard, dielectric, radiance, BVH, \
            moiré, overflow, WSL, macOS, AZERTY, SIMD, occlusion, left-handed, cancellation, \
            benchmark, rounding error, sRGB, linear light, Blinn-Phong, Schlick, Snell, \
            total internal reflection, Beer-Lambert, caustic, nested dielectrics, priority, \
            fireflies, clamp, jitter, stratified, Sobol";
        // That page quotes the words themselves.
        let others = pages().into_iter().filter(|page| page != "faults.md");
        let text: Vec<String> = others.map(|page| read(&page)).collect();
        let text = text.concat();
        let missing = WORDS.split(", ").filter(|word| !text.contains(word));
        none(
            &missing
                .map(|word| format!("no page says {word}"))
                .collect::<Vec<_>>(),
        );
    }

    /// What the last page would change is what there is.
    #[test]
    fn names_what_there_is_where_it_says_what_comes_next() {
        let page = read("where-next.md");
        let sources = rust_files(&root().join("chapters")).concat();
        let names = Parser::new(&page).filter_map(|event| match event {
            Event::Code(name) => Some(name.into_string()),
            _ => None,
        });
        let is_there = |name: &str| match name.contains('/') {
            true => root().join(name).is_file(),
            false => name.split("::").all(|part| {
                let mut words = sources.split(|c: char| !c.is_alphanumeric() && c != '_');
                words.any(|word| word == part)
            }),
        };
        let missing = names.filter(|name| !is_there(name));
        none(
            &missing
                .map(|name| format!("there is no {name}"))
                .collect::<Vec<_>>(),
        );
    }

    #[test]
    fn shows_only_pictures_that_exist_and_every_view_of_every_chapter() {
        let mut problems = Vec::new();
        for page in pages() {
            for command in figures(&read(&page)) {
                for (stage, word) in figure(&command) {
                    let picture = picture(stage, word);
                    if !book().join(&picture).is_file() {
                        problems.push(format!(
                            "{page}: {stage} {word} has no picture {picture}"
                        ));
                    }
                }
            }
        }
        let texts = pages().into_iter().filter(|page| page != COLLECTION);
        let text: String = texts.map(|page| read(&page)).collect();
        for stage in STAGES {
            let shown = views_of(stage, &text);
            for view in stage.views {
                if !shown.contains(view.name) {
                    problems.push(format!("no page shows {} {}", stage.name, view.name));
                }
            }
        }
        none(&problems);
    }

    #[test]
    fn shows_every_studys_chart_and_every_drawing_once() {
        let mut problems = Vec::new();
        let charts: Vec<&str> = studies().map(|study| study.name).collect();
        let drawings: Vec<&str> = drawings::names().collect();
        for (kind, names) in [("chart", charts), ("drawing", drawings)] {
            let shown = pages().into_iter();
            let shown: Vec<String> = shown
                .flat_map(|page| commands(&read(&page), kind))
                .collect();
            for name in names {
                let times = shown.iter().filter(|shown| *shown == name).count();
                if times != 1 {
                    problems.push(format!("the {kind} of {name} is shown {times} times"));
                }
            }
        }
        none(&problems);
    }

    #[test]
    fn asks_only_for_charts_drawings_and_numbers_that_there_are() {
        let mut problems = Vec::new();
        for page in pages() {
            let text = read(&page);
            for name in commands(&text, "chart") {
                if studies().all(|study| study.name != name) {
                    problems.push(format!("{page}: there is no study {name}"));
                }
            }
            for name in commands(&text, "drawing") {
                if drawings::names().all(|known| known != name) {
                    problems.push(format!("{page}: there is no drawing {name}"));
                }
            }
            for reference in commands(&text, "measured") {
                if let Err(problem) = measured(&reference) {
                    problems.push(format!("{page}: {problem}"));
                }
            }
        }
        none(&problems);
    }

    /// A mark of its difficulty, a hint, and an answer that is folded away; or a solution that is
    /// compiled, and a test that the page names.
    #[test]
    fn has_a_hint_and_an_answer_to_every_exercise_and_a_check_of_every_solution() {
        let mut problems = Vec::new();
        for stage in STAGES {
            let page = exercises_page_of(stage);
            let exercises = exercises(&page);
            if !(3..=5).contains(&exercises.len()) {
                problems.push(format!("{}: {} exercises", stage.name, exercises.len()));
            }
            let mut judged = BTreeSet::new();
            for (number, exercise) in (1..).zip(exercises) {
                match check_exercise(stage, number, exercise) {
                    Ok(is_judged) => judged.extend(is_judged),
                    Err(problem) => problems
                        .push(format!("{}, exercise {number}: {problem}", stage.name)),
                }
            }
            let tests = ignored_tests_of(&test_of(stage));
            if judged != tests {
                problems.push(format!(
                    "{}: the page has {judged:?}, the tests are {tests:?}",
                    stage.name
                ));
            }
        }
        let pages = STAGES.map(exercises_page_of).concat();
        let shown = pages.split("](pictures/solutions/").skip(1);
        let shown = shown.filter_map(|rest| rest.split(')').next());
        let shown: BTreeSet<String> = shown.map(str::to_string).collect();
        let pictures = fs::read_dir(book().join("pictures/solutions"));
        let pictures = pictures.expect("the solutions' pictures");
        let pictures = pictures.map(|picture| picture.expect("a picture").file_name());
        let pictures = pictures.map(|name| name.to_string_lossy().into_owned());
        let pictures: BTreeSet<String> =
            pictures.filter(|name| name.ends_with(".png")).collect();
        if shown != pictures {
            let differing: Vec<_> = shown.symmetric_difference(&pictures).collect();
            problems.push(format!("shown or there, and not both: {differing:?}"));
        }
        none(&problems);
    }

    #[test]
    fn would_notice_an_exercise_that_lacks_something() {
        let stage = STAGES[0];
        let page = exercises_page_of(stage);
        let exercises = exercises(&page);
        let solved = exercises[0];
        assert_eq!(
            check_exercise(stage, 1, solved),
            Ok(Some("exercise_1".to_string()))
        );
        for part in [
            "(easy)",
            "<summary>Hint</summary>",
            "<summary>Solution</summary>",
            "canvas exercise_1 -- --ignored",
            "{{#include ../../tests/canvas/solutions.rs:exercise-1}}",
        ] {
            assert!(solved.contains(part), "{part}");
            let lacking = solved.replace(part, "");
            assert!(check_exercise(stage, 1, &lacking).is_err(), "{part}");
        }
        assert!(check_exercise(stage, 2, solved).is_err(), "another number");
    }

    /// Each folder is a stage in the list, in its order, with a program and a test target of its own.
    #[test]
    fn knows_every_chapter() {
        let folders = fs::read_dir(root().join("chapters")).expect("the chapters");
        let names = folders.map(|folder| folder.expect("a folder").file_name());
        let names = names.map(|name| name.to_string_lossy().into_owned());
        let is_numbered = |name: &String| name.starts_with(|c: char| c.is_ascii_digit());
        let chapters: BTreeSet<String> = names.filter(is_numbered).collect();
        let listed = STAGES.map(|stage| stage.name.to_string());
        assert_eq!(chapters.into_iter().collect::<Vec<_>>(), listed);

        let targets = targets();
        for name in listed {
            let (_, test) = name.split_once('-').expect("a number and a name");
            assert!(targets["bin"].contains(&name), "no program {name}");
            let test = test.replace('-', "_");
            assert!(targets["test"].contains(&test), "no tests of {name}");
            let names = tests_of(&test);
            assert!(
                names.iter().any(|name| name.starts_with("every_picture"))
                    && names.len() > 3,
                "hardly a test of {name}: {names:?}"
            );
        }
    }

    /// Every command has one of the few forms that `check_command` knows.
    #[test]
    fn names_no_command_that_runs_nothing() {
        let targets = targets();
        let readme = fs::read_to_string(root().join("README.md")).expect("the README");
        let texts = pages().into_iter().map(|page| (page.clone(), read(&page)));
        let (mut count, mut problems) = (0, Vec::new());
        for (page, text) in texts.chain([("README.md".to_string(), readme)]) {
            for command in cargo_commands(&text) {
                count += 1;
                if let Err(problem) = check_command(&command, &targets) {
                    problems.push(format!("{page}: cargo {command}: {problem}"));
                }
            }
        }
        none(&problems);
        assert!(count > 30, "only {count} commands were found");
    }

    #[test]
    fn would_notice_a_command_that_runs_nothing() {
        let targets = targets();
        for command in [
            "test packets",
            "test --test sphere",
            "test --test Sphere_hit",
            "test --test=sphere_hit",
            "test --test sphere_hit half_the_light",
            "test --test sphere_hit -- nonsense",
            "test --test sphere_hit exercise_1",
            "test --test sphere_hit exercise_9 -- --ignored",
            "test --test sphere_hit every_picture -- --ignored",
            "test --doc",
            "-q test --test sphere_hit",
            "t --test sphere_hit",
            "+stable test",
            "bench --bench studies -- nonsense",
            "bench --bench nonsense",
            "run --bin=00-canvas",
            "run --bin nonsense",
            "run --bin 00-canvas -- --view nonsense",
        ] {
            assert!(check_command(command, &targets).is_err(), "{command}");
        }
        for command in [
            "test",
            "test --test sphere_hit every_picture",
            "test --test sphere_hit exercise_1 -- --ignored",
            "run",
        ] {
            assert_eq!(check_command(command, &targets), Ok(()), "{command}");
        }
    }

    /// A bug is a view that its stage calls one, and every view that its chapter shows of what goes wrong.
    #[test]
    fn collects_every_bug_on_the_page_for_when_things_go_wrong() {
        let mut problems = Vec::new();
        for stage in STAGES {
            let page = read(&page_of(stage));
            let mut sections = page.split("\n## ");
            let section = sections.find(|section| section.starts_with("What goes wrong"));
            let mut bugs = views_of(stage, section.unwrap_or_default());
            bugs.extend(stage.bugs.iter().map(|bug| bug.to_string()));
            for missing in bugs.difference(&views_of(stage, &read(COLLECTION))) {
                problems.push(format!(
                    "{COLLECTION} does not show {} {missing}",
                    stage.name
                ));
            }
        }
        none(&problems);
    }
}

/// The page that shows all bugs once more.
const COLLECTION: &str = "when-things-go-wrong.md";

/// The anchor of what only this project needs, and no page prints.
const OURS: &str = "ours";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder of the pages' source.
fn book() -> PathBuf {
    root().join("book/src")
}

/// The targets of all packages: `bin`, `test` and `bench`, each with its names.
fn targets() -> BTreeMap<&'static str, BTreeSet<String>> {
    let metadata = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--no-deps",
            "--format-version",
            "1",
            "--offline",
        ])
        .current_dir(root())
        .output();
    let metadata = metadata.expect("cargo runs").stdout;
    let metadata: Value = serde_json::from_slice(&metadata).expect("cargo's metadata");
    let packages = metadata["packages"].as_array().expect("packages");
    let all = packages
        .iter()
        .flat_map(|package| package["targets"].as_array());
    let of_kind = |kind: &'static str| {
        // What `cargo test` leaves out does not count.
        let is_it = |target: &&Value| {
            target["kind"][0] == kind && (kind != "test" || target["test"] == true)
        };
        let names = all.clone().flatten().filter(is_it);
        let names = names.filter_map(|target| Some(target["name"].as_str()?.to_string()));
        (kind, names.collect())
    };
    ["bin", "test", "bench"].map(of_kind).into()
}

/// Checks a command: `test`, `bench` or `run`, perhaps a target that exists, perhaps a filter that a test of this
/// target holds in its name, or the name of an exercise, whose test is ignored, and what the program is given, as
/// far as that is a view or a study.
fn check_command(
    command: &str,
    targets: &BTreeMap<&str, BTreeSet<String>>,
) -> Result<(), String> {
    let (cargo, program) = command.split_once(" -- ").unwrap_or((command, ""));
    let words: Vec<&str> = cargo.split_whitespace().collect();
    let words: Vec<&str> = words
        .into_iter()
        .filter(|word| !["--release", "--no-fail-fast"].contains(word))
        .collect();
    let program: Vec<&str> = program.split_whitespace().collect();
    // The names in a general form.
    let exists = |kind: &str, name: &str| {
        ["NAME", "CHAPTER"].contains(&name) || targets[kind].contains(name)
    };
    match words[..] {
        ["test" | "run" | "bench"] if program.is_empty() => Ok(()),
        ["test", "--test", name] if program.is_empty() && exists("test", name) => Ok(()),
        ["test", "--test", name, filter] if program.is_empty() => {
            let ignored = ignored_tests_of(name);
            let is_run = |test: &&str| test.contains(filter) && !ignored.contains(*test);
            let tests = tests_of(name);
            // What follows a name is its parentheses.
            let names = tests.iter().filter_map(|test| test.split('(').next());
            let is_one = names.filter(is_run).count() > 0;
            is_one.then_some(()).ok_or("no such test".to_string())
        }
        ["test", "--test", name, filter] if program == ["--ignored"] => {
            let is_one =
                filter == "exercise_N" || ignored_tests_of(name).contains(filter);
            is_one.then_some(()).ok_or("no such exercise".to_string())
        }
        ["bench", "--bench", name] if exists("bench", name) => match program[..] {
            [study] if name == "studies" && studies().all(|it| it.name != study) => {
                Err(format!("there is no study {study}"))
            }
            _ => Ok(()),
        },
        ["run", "--bin", name] if exists("bin", name) => {
            let stage = STAGES.into_iter().find(|stage| stage.name == name);
            match (stage, program[..].iter().position(|&word| word == "--view")) {
                (Some(stage), Some(option)) => {
                    let view = program.get(option + 1).copied().unwrap_or_default();
                    let view = stage.view(view).map(|_| ());
                    view.ok_or("no such view".to_string())
                }
                _ => Ok(()),
            }
        }
        _ => Err("this is no form of a command that a test knows".to_string()),
    }
}

/// The names of a target's tests, and of the modules that they stand in.
fn tests_of(target: &str) -> Vec<String> {
    let folder = root().join("tests").join(target);
    let mut texts = if folder.is_dir() {
        rust_files(&folder)
    } else {
        Vec::new()
    };
    let file = root().join("tests").join(format!("{target}.rs"));
    texts.extend(fs::read_to_string(file));
    let mut names = Vec::new();
    for text in texts {
        let mut is_test = false;
        for line in text.lines().map(str::trim) {
            let name = |prefix| line.strip_prefix(prefix).map(str::to_string);
            names.extend(name("mod "));
            if is_test {
                names.extend(name("fn "));
            }
            is_test = line == "#[test]" || is_test && line.starts_with('#');
        }
    }
    names
}

/// The names of a target's tests that `cargo test` ignores: the exercises.
fn ignored_tests_of(target: &str) -> BTreeSet<String> {
    let folder = root().join("tests").join(target);
    let texts = if folder.is_dir() {
        rust_files(&folder)
    } else {
        Vec::new()
    };
    let mut names = BTreeSet::new();
    for text in texts {
        // The function comes on the next line.
        for rest in text.split("#[ignore = \"an exercise for you\"]").skip(1) {
            let name = rest.trim_start().strip_prefix("fn ");
            let name = name.and_then(|rest| rest.split('(').next());
            names.extend(name.map(str::to_string));
        }
    }
    names
}

/// The name of a chapter's test target: `ray_casting` of `01-ray-casting`.
fn test_of(stage: &Stage) -> String {
    let (_, name) = stage.name.split_once('-').expect("a number and a name");
    name.replace('-', "_")
}

/// The exercises of a page, each from its heading on.
fn exercises(page: &str) -> Vec<&str> {
    let section = page.split("\n## ").find(|it| it.starts_with("Exercises\n"));
    let exercises = section.unwrap_or_default().split("\n### ");
    exercises.skip(1).collect()
}

/// Checks an exercise of a chapter. Returns the name of its test, if it has one.
fn check_exercise(
    stage: &Stage,
    number: usize,
    text: &str,
) -> Result<Option<String>, String> {
    let heading = text.lines().next().unwrap_or_default();
    let is_marked = ["easy", "medium", "hard"].iter().any(|mark| {
        let start = format!("Exercise {number} ({mark}): ");
        heading.len() > start.len() && heading.starts_with(&start)
    });
    if !is_marked {
        return Err(format!("the heading is “{heading}”"));
    }
    let fold = |summary: &str| {
        let (_, rest) = text.split_once(&format!("<summary>{summary}</summary>"))?;
        let (fold, _) = rest.split_once("</details>")?;
        (!fold.trim().is_empty()).then_some(fold)
    };
    fold("Hint").ok_or("no hint")?;
    let test = test_of(stage);
    let command = format!("`cargo test --test {test} exercise_{number} -- --ignored`");
    match (fold("Solution"), fold("Answer")) {
        (Some(solution), None) => {
            let code = format!("../../tests/{test}/solutions.rs:exercise-{number}");
            let start = format!(
                "../../chapters/{}/src/exercises.rs:exercise-{number}",
                stage.name
            );
            if !commands(solution, "include").contains(&code) {
                return Err("the solution has no code".to_string());
            }
            if !commands(text, "include").contains(&start) {
                return Err("what to begin with is not printed".to_string());
            }
            if !text.contains(&command) {
                return Err(format!("no {command}"));
            }
            // What a reader compares in a project of one's own.
            if !solution.contains("pictures/solutions/")
                && !solution.contains("{{#include numbers/")
            {
                return Err("the solution has neither picture nor number".to_string());
            }
            Ok(Some(format!("exercise_{number}")))
        }
        (None, Some(answer))
            if commands(answer, "include")
                .iter()
                .all(|it| !it.contains("solutions.rs")) =>
        {
            Ok(None)
        }
        _ => Err("neither a solution nor an answer, or both".to_string()),
    }
}

/// The texts of all Rust files in a folder.
fn rust_files(folder: &Path) -> Vec<String> {
    let mut texts = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            texts.extend(rust_files(&path));
        } else if path.extension().is_some_and(|it| it == "rs") {
            texts.push(fs::read_to_string(path).expect("a source file"));
        }
    }
    texts
}

/// What follows `cargo` in every command that runs something, in a line of a console or between backticks.
fn cargo_commands(text: &str) -> Vec<String> {
    let mut commands = Vec::new();
    // Those for a project of the reader's own are followed, to the letter, by another test.
    let ours = text.lines().filter(|line| !line.starts_with("tracer$ "));
    let text = ours.collect::<Vec<_>>().join("\n");
    for rest in text.split("cargo ").skip(1) {
        let command = rest.split(['\n', '`', '#', '&', '|', ';', ')']).next();
        let command = command.unwrap_or_default().trim();
        let verb = command.split(' ').next().unwrap_or_default();
        let verbs = ["test", "bench", "run", "t", "b", "r", "nextest"];
        if verbs.contains(&verb) || verb.starts_with(['-', '+']) {
            commands.push(command.to_string());
        }
    }
    commands
}

fn read(file: &str) -> String {
    fs::read_to_string(book().join(file))
        .unwrap_or_else(|problem| panic!("{file}: {problem}"))
}

/// The pages that SUMMARY.md links.
fn pages() -> Vec<String> {
    Parser::new(&read("SUMMARY.md"))
        .filter_map(|event| match event {
            Event::Start(Tag::Link { dest_url, .. }) => Some(dest_url.into_string()),
            _ => None,
        })
        .collect()
}

fn page_of(stage: &Stage) -> String {
    format!("{}.md", stage.name)
}

/// The number of words of a page's prose and of lines of its Rust listings, without what is folded away.
fn prose_and_listings(page: &str) -> (usize, usize) {
    let (mut words, mut lines, mut language) = (0, 0, None);
    let mut is_folded = false;
    for event in Parser::new(page) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(it))) => {
                language = Some(it)
            }
            Event::End(TagEnd::CodeBlock) => language = None,
            Event::Html(html) | Event::InlineHtml(html) => {
                is_folded = (is_folded || html.contains("<details"))
                    && !html.contains("</details>");
            }
            _ if is_folded => (),
            Event::Text(text) if language.as_deref() == Some("rust") => {
                for command in commands(&text, "include") {
                    let numbers = included(&command).expect("a listing");
                    let [Some(first), Some(last)] = [numbers.first(), numbers.last()]
                    else {
                        continue;
                    };
                    lines += last - first + 1;
                }
            }
            Event::Text(text) if language.is_none() && !text.starts_with("{{#") => {
                words += text.split_whitespace().count();
            }
            Event::Code(_) => words += 1,
            _ => (),
        }
    }
    (words, lines)
}

/// The text of the page with a chapter's exercises. The canvas's have a page of their own: they need what comes later.
fn exercises_page_of(stage: &Stage) -> String {
    if stage.name == STAGES[0].name {
        read("inside-the-canvas.md")
    } else {
        read(&page_of(stage))
    }
}

/// What follows `name` in every `{{#name …}}` of a page.
fn commands(page: &str, name: &str) -> Vec<String> {
    page.split("{{#")
        .skip(1)
        .filter_map(|rest| rest.split_once("}}")?.0.strip_prefix(name))
        .map(|rest| rest.trim().to_string())
        .collect()
}

/// The numbers of the lines that `{{#include FILE:ANCHOR}}` includes.
fn included(command: &str) -> Result<Vec<usize>, String> {
    let (file, anchor) = match command.split_once(':') {
        Some((file, anchor)) => (file, Some(anchor)),
        None => (command, None),
    };
    let text = fs::read_to_string(book().join(file))
        .map_err(|problem| format!("{file}: {problem}"))?;
    let lines: Vec<&str> = text.lines().collect();
    let range = match anchor {
        None => 0..lines.len(),
        Some(anchor) => {
            let find = |keyword: &str| {
                let openings = (0..lines.len())
                    .filter(|&line| anchor_in(lines[line], keyword) == Some(anchor));
                match openings.collect::<Vec<_>>()[..] {
                    [opening] => Ok(opening),
                    [] => Err(format!("{file} has no {keyword} {anchor}")),
                    _ => Err(format!("{file} has more than one {keyword} {anchor}")),
                }
            };
            find("ANCHOR:")? + 1..find("ANCHOR_END:")?
        }
    };
    let has_content =
        |&line: &usize| !lines[line].trim().is_empty() && !is_anchor(lines[line]);
    let numbers: Vec<_> = range.filter(has_content).map(|line| line + 1).collect();
    if numbers.is_empty() {
        return Err(format!("nothing is in {command}"));
    }
    Ok(numbers)
}

fn is_anchor(line: &str) -> bool {
    ["ANCHOR:", "ANCHOR_END:"]
        .iter()
        .any(|keyword| anchor_in(line, keyword).is_some())
}

/// The anchor that a line opens or closes, as `keyword` says.
fn anchor_in<'a>(line: &'a str, keyword: &str) -> Option<&'a str> {
    line.split_once(keyword)?.1.split_whitespace().next()
}

/// What follows `figure` in a page's commands, and what follows `crop` but for its rectangle.
fn figures(page: &str) -> Vec<String> {
    let is_view = |word: &&str| word.parse::<u32>().is_err();
    let crops = commands(page, "crop").into_iter();
    let crops = crops.map(|crop| {
        let words = crop.split_whitespace().filter(is_view);
        words.collect::<Vec<_>>().join(" ")
    });
    commands(page, "figure").into_iter().chain(crops).collect()
}

/// The stage of a figure with each `VIEW` or `VIEW=KNOB` in it.
fn figure(command: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut words = command.split_whitespace();
    let stage = words.next().unwrap_or_default();
    words.map(move |word| (stage, word))
}

/// The views of a stage that a page, or a part of one, has figures of.
fn views_of(stage: &Stage, page: &str) -> BTreeSet<String> {
    let figures = figures(page);
    let views = figures.iter().flat_map(|command| figure(command));
    views
        .filter(|&(name, _)| name == stage.name)
        .filter_map(|(_, word)| Some(word.split('=').next()?.to_string()))
        .collect()
}

/// The picture's file of one `VIEW` or `VIEW=KNOB` in a figure.
fn picture(stage: &str, word: &str) -> String {
    let (name, setting) = word.split_once('=').unzip();
    let name = name.unwrap_or(word);
    let stage = STAGES.into_iter().find(|known| known.name == stage);
    let picture = stage.and_then(|stage| {
        let view = stage.view(name)?;
        let setting = setting
            .map_or(Some(view.default_setting()), |setting| setting.parse().ok())?;
        Some(stage.picture_name(view, setting))
    });
    let picture = picture.unwrap_or_else(|| "of that name".to_string());
    format!("pictures/{picture}.snap.png")
}

fn none(problems: &[String]) {
    assert!(problems.is_empty(), "\n{}\n", problems.join("\n"));
}
