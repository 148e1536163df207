//! A study's measurements, and the file of comma-separated values that keeps them.

pub use crate::digits::{for_readers, three_digits, with_separators};
use serde::{Deserialize, Serialize, Serializer};
use std::io;

// ANCHOR: measurement
/// The cost and the errors of one method at one setting, in the study's units.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// The scene or the set of inputs.
    pub scene: String,
    /// The method's name.
    pub method: String,
    /// The knob's setting.
    #[serde(serialize_with = "rounded")]
    pub setting: f64,
    /// The cost in rays or operations, which are counted, not timed.
    #[serde(serialize_with = "rounded")]
    pub work: Option<f64>,
    /// The largest error.
    #[serde(serialize_with = "rounded")]
    pub max: Option<f64>,
    /// The root of the mean of the errors' squares.
    #[serde(serialize_with = "rounded")]
    pub rms: Option<f64>,
    /// Wrong decisions, such as a hit where there is none, in percent.
    #[serde(serialize_with = "rounded")]
    pub wrong: Option<f64>,
    /// The time in nanoseconds.
    #[serde(serialize_with = "rounded")]
    pub ns: Option<f64>,
}

/// The measurements of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The machine on which the times were measured.
    pub machine: String,
    /// One row for each scene, method and setting.
    pub rows: Vec<Measurement>,
}
// ANCHOR_END: measurement

impl Table {
    /// Returns the table as comma-separated values below a line that names the machine,
    /// every number rounded to three digits.
    pub fn to_csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let written = self.rows.iter().try_for_each(|row| writer.serialize(row));
        written.expect("memory takes everything");
        let bytes = writer.into_inner().expect("memory takes everything");
        let rows = String::from_utf8(bytes).expect("written from strings");
        format!("# {}\n{rows}", self.machine)
    }

    /// Reads what [`Table::to_csv`] wrote.
    ///
    /// # Errors
    /// If the first line names no machine, or a row is not a [`Measurement`].
    pub fn from_csv(text: &str) -> csv::Result<Self> {
        let lines = text
            .strip_prefix("# ")
            .and_then(|text| text.split_once('\n'));
        let no_machine = || io::Error::other("the first line names no machine");
        let (machine, rows) = lines.ok_or_else(no_machine)?;
        let rows = csv::Reader::from_reader(rows.as_bytes()).into_deserialize();
        Ok(Self {
            machine: machine.trim_end().to_string(),
            rows: rows.collect::<csv::Result<_>>()?,
        })
    }

    // ANCHOR: without-times
    /// Returns the table without its times, which no test may compare.
    pub fn without_times(mut self) -> Self {
        self.machine.clear();
        self.rows.iter_mut().for_each(|row| row.ns = None);
        self
    }
    // ANCHOR_END: without-times
}

fn rounded<S: Serializer>(
    x: &(impl Copy + Into<Option<f64>>),
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&(*x).into().map_or_else(String::new, three_digits))
}
