//! The book's source: its listings are the chapters' code, and its pictures exist.

use canvas::{Stage, View};
use light_backwards::STAGES;
use pulldown_cmark::{Event, Parser, Tag};
use speed_and_accuracy::STUDIES;
use speed_and_accuracy::studies;
use speed_and_accuracy::study::{Study, Table};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

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
        for stage in STAGES {
            let library = format!("../../chapters/{}/src/lib.rs", stage.name);
            let listed: BTreeSet<usize> = commands(&read(&page_of(stage)), "include")
                .iter()
                .filter(|command| command.split(':').next() == Some(&library))
                .filter_map(|command| included(command).ok())
                .flatten()
                .collect();
            for (number, line) in (1..).zip(read(&library).lines()) {
                if !line.trim().is_empty()
                    && !is_anchor(line)
                    && !listed.contains(&number)
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

    #[test]
    fn shows_only_pictures_that_exist_and_every_view_of_every_chapter() {
        let mut problems = Vec::new();
        for page in pages() {
            for command in commands(&read(&page), "figure") {
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
        for stage in STAGES {
            let page = read(&page_of(stage));
            let mut shown = views_of(stage, &page);
            if stage.name == speed_and_accuracy::STAGE.name {
                shown.extend(commands(&page, "chart"));
            }
            for view in stage.views {
                if !shown.contains(view.name) {
                    problems.push(format!(
                        "{} does not show “{}”",
                        page_of(stage),
                        view.name
                    ));
                }
            }
        }
        none(&problems);
    }

    #[test]
    fn shows_every_studys_chart_in_chapter_13_and_in_the_one_it_belongs_to() {
        let last = &speed_and_accuracy::STAGE;
        let shows = |stage: &Stage, study: &Study| {
            commands(&read(&page_of(stage)), "chart").contains(&study.name.to_string())
        };
        let mut problems = Vec::new();
        for study in STUDIES {
            if !shows(last, study) {
                problems.push(format!("{} does not show {}", page_of(last), study.name));
            }
            let mut others = STAGES.into_iter().filter(|stage| stage.name != last.name);
            // The planner's chapter is the last itself.
            if study.name != "plan" && !others.any(|stage| shows(stage, study)) {
                problems.push(format!("no other chapter shows {}", study.name));
            }
        }
        none(&problems);
    }

    #[test]
    fn asks_only_for_charts_and_numbers_that_there_are() {
        let mut problems = Vec::new();
        for page in pages() {
            let text = read(&page);
            let charts = commands(&text, "chart");
            let charts = charts.iter().map(|name| studies::find(name).map(drop));
            let numbers = commands(&text, "measured");
            let numbers = numbers.iter().map(|asked| measured(asked).map(drop));
            for problem in charts.chain(numbers).filter_map(Result::err) {
                problems.push(format!("{page}: {problem}"));
            }
        }
        none(&problems);
    }

    /// A bug is a view whose caption says so, and whatever its chapter shows of what goes wrong.
    #[test]
    fn collects_every_bug_on_the_page_for_when_things_go_wrong() {
        const COLLECTION: &str = "when-things-go-wrong.md";
        let mut problems = Vec::new();
        for stage in STAGES {
            let page = read(&page_of(stage));
            let mut sections = page.split("\n## ");
            let section = sections.find(|section| section.starts_with("What goes wrong"));
            let mut bugs = views_of(stage, section.unwrap_or_default());
            let says_so = |view: &&View| {
                view.caption.starts_with("The bug") || view.caption.contains("failed")
            };
            let captioned = stage.views.iter().filter(says_so);
            bugs.extend(captioned.map(|view| view.name.to_string()));
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

/// The folder of the pages' source.
fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src")
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
                let places = (0..lines.len())
                    .filter(|&line| anchor_in(lines[line], keyword) == Some(anchor));
                match places.collect::<Vec<_>>()[..] {
                    [place] => Ok(place),
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

/// The stage of a figure with each `VIEW` or `VIEW=KNOB` in it.
fn figure(command: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut words = command.split_whitespace();
    let stage = words.next().unwrap_or_default();
    words.map(move |word| (stage, word))
}

/// The views of a stage that a page, or a part of one, has figures of.
fn views_of(stage: &Stage, page: &str) -> BTreeSet<String> {
    let figures = commands(page, "figure");
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
        let view = &stage.views[stage.find(name)?];
        let setting = setting
            .map_or(Some(view.default_setting()), |setting| setting.parse().ok())?;
        Some(stage.picture_name(view, setting))
    });
    let picture = picture.unwrap_or_else(|| "of that name".to_string());
    format!("pictures/{picture}.snap.png")
}

/// The number for `{{#measured STUDY; SCENE; METHOD; SETTING; COLUMN}}`.
fn measured(asked: &str) -> Result<f64, String> {
    let asked = asked.split_whitespace().collect::<Vec<_>>().join(" ");
    let words: Vec<_> = asked.split(';').map(str::trim).collect();
    let [name, scene, method, setting, column] = words[..] else {
        return Err(format!("{asked} is not five words"));
    };
    let setting = setting
        .parse()
        .map_err(|_| format!("“{setting}” is no setting"))?;
    let table = Table::from_csv(studies::find(name)?.table)?;
    table.number(scene, method, setting, column)
}

fn none(problems: &[String]) {
    assert!(problems.is_empty(), "\n{}\n", problems.join("\n"));
}
