//! Prepares the book's pages for mdBook: formulas become MathML, figures come from the chapters' stages
//! and manifests, charts and measured numbers from the studies.

mod dependencies;
mod figures;
mod maths;
mod page;

use mdbook_preprocessor::errors::{Error, Result};
use std::env;
use std::io;

fn main() -> Result<()> {
    // mdBook first queries whether its renderer is supported; the exit code says so.
    if env::args().nth(1).as_deref() == Some("supports") {
        return Ok(());
    }
    let (context, mut book) = mdbook_preprocessor::parse_input(io::stdin())?;
    // A teacher may hand out pages without the solutions of the exercises.
    let has_solutions = context.config.get("preprocessor.pages.solutions")?;
    let has_solutions = has_solutions.unwrap_or(true);
    let mut result = Ok(());
    book.for_each_chapter_mut(|chapter| {
        if !has_solutions {
            chapter.content = page::without_solutions(&chapter.content);
        }
        match page::prepare(&chapter.content) {
            Ok(content) => chapter.content = content,
            Err(problem) if result.is_ok() => {
                result = Err(Error::msg(format!("page “{}”: {problem}", chapter.name)));
            }
            Err(_) => (),
        }
    });
    result?;
    serde_json::to_writer(io::stdout(), &book)?;
    Ok(())
}
