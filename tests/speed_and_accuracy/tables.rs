//! The files of measurements.

use speed_and_accuracy::table::{Measurement, Table, for_readers, three_digits};

#[test]
fn a_number_has_three_digits() {
    for (number, written) in [
        (0.0, "0"),
        (0.12345, "0.123"),
        (1000.0, "1000"),
        (123_456.0, "123000"),
        (-2.5, "-2.5"),
        (999.9, "1000"),
        (0.001, "0.001"),
        (3e-4, "3e-4"),
        (1e6, "1e6"),
        (1.23456e-7, "1.23e-7"),
        (f64::INFINITY, "inf"),
    ] {
        assert_eq!(three_digits(number), written);
    }
}

#[test]
fn a_number_is_written_as_by_hand() {
    for (number, written) in [
        (0.0, "0"),
        (4.45, "4.45"),
        (-2.5, "−2.5"),
        (999.4, "999"),
        (999.6, "1,000"),
        (307_000.0, "307,000"),
        (1.13e6, "1.13\u{a0}×\u{a0}10⁶"),
        (1.2e-7, "1.2\u{a0}×\u{a0}10⁻⁷"),
        (f64::INFINITY, "∞"),
    ] {
        assert_eq!(for_readers(number), written);
    }
}

#[test]
fn a_table_is_read_as_it_was_written() {
    let row = Measurement {
        work: Some(1.5),
        max: Some(f64::INFINITY),
        wrong: Some(0.0),
        ns: Some(1.2e-7),
        ..Measurement::of("nested, \"cut off\"", "4 × 4", 1e-7)
    };
    let table = Table {
        machine: "a machine, x86".to_string(),
        rows: vec![row, Measurement::of("", "", -1.0)],
    };
    let csv = table.to_csv();
    let lines = "# a machine, x86
scene,method,setting,work,max,rms,wrong,ns
\"nested, \"\"cut off\"\"\",4 × 4,1e-7,1.5,inf,,0,1.2e-7
,,-1,,,,,
";
    assert_eq!(csv, lines);
    assert_eq!(Table::from_csv(&csv).expect("just written"), table);
    let without_times = table.without_times().to_csv();
    assert!(without_times.starts_with("# \n") && without_times.contains(",0,\n"));
}

#[test]
fn what_is_no_table_is_refused_in_a_line() {
    let header = "# a machine\nscene,method,setting,work,max,rms,wrong,ns\n";
    for (text, complaint) in [
        ("", "machine"),
        ("scene,method\n", "machine"),
        (&format!("{header}a,b,many,,,,,\n"), "invalid float"),
        (&format!("{header}a,b,1,,,,\n"), "7 fields"),
        (&format!("{header}a,b,,,,,,\n"), "float"),
    ] {
        let error = Table::from_csv(text).expect_err("no table").to_string();
        assert!(
            error.contains(complaint) && !error.contains('\n'),
            "{error}"
        );
    }
}

#[test]
fn errors_are_the_largest_and_the_mean_of_squares() {
    let row = Measurement::of("", "", 0.0);
    let of = |errors: &[f64]| {
        let row = row.clone().with_errors(errors.iter().copied());
        (row.max, row.rms)
    };
    assert_eq!(of(&[3.0, -4.0, 0.0, 0.0]), (Some(4.0), Some(2.5)));
    assert_eq!(of(&[]), (None, None));
    let infinite = Some(f64::INFINITY);
    assert_eq!(of(&[1.0, f64::NAN]), (infinite, infinite));
}
