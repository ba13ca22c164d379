//! Pages are well-formed, self-contained, escaped and equal from run to run, whatever is put on them.

mod well_formed;

use report::{Axis, Block, Cell, Ink, Page, Plot, Series, Shape, Table, Tone};

const NASTY: &str = "<script>alert('x & \"y\"')</script> --> \u{1F681} a_very_long_name_without_any_place_to_break_it_that_goes_on_and_on";

fn plot(y: Vec<f64>) -> Plot {
    let x: Vec<f64> = (0..y.len()).map(|k| k as f64).collect();
    let band = y.iter().map(|v| v + 1.0).collect();
    Plot {
        series: vec![
            Series::line("", Ink::Measured, &x, &y),
            Series::line(NASTY, Ink::Model, &x, &y).drawn(Shape::Band(band)),
            Series::line("steps", Ink::Slot(17), &x, &y).drawn(Shape::Steps),
            Series::line("rings", Ink::Limit, &x, &y).drawn(Shape::Rings),
            Series::line("stems", Ink::Before, &x, &y).drawn(Shape::Stems),
        ],
        windows: vec![(1.0, 2.0)],
        levels: vec![0.5],
        note: Some(NASTY.to_owned()),
        wide: true,
        ..Plot::new(NASTY, NASTY, "y [rad]")
    }
}

fn page(plots: Vec<Plot>) -> Page {
    let text = || NASTY.to_owned();
    let table = Table {
        caption: text(),
        head: vec![text(), "value".to_owned(), "bar".to_owned(), "interval".to_owned()],
        rows: vec![
            vec![
                Cell::Text(text()),
                Cell::Number("1.5".to_owned()),
                Cell::Bar { share: f64::NAN, text: text() },
                Cell::Interval { value: 1.0, ends: Some((0.5, 1.5)), other: Some(3.0) },
            ],
            vec![
                Cell::Text(String::new()),
                Cell::Number(text()),
                Cell::Bar { share: 7.0, text: text() },
                Cell::Interval { value: f64::NAN, ends: None, other: None },
            ],
        ],
    };
    Page {
        mark: text(),
        title: text(),
        subtitle: text(),
        blocks: vec![
            Block::Heading(text()),
            Block::Subheading(text()),
            Block::Text(text()),
            Block::Callout { tone: Tone::Bad, word: text(), sentence: text() },
            Block::Facts(vec![(text(), text())]),
            Block::Table(table),
            Block::Plots(plots),
            Block::Difference { name: text(), old: format!("a\nb\n{NASTY}\n"), new: format!("a\n{NASTY} too\nb\n") },
            Block::Fold { title: text(), blocks: vec![Block::Code(text())] },
        ],
        provenance: vec![(text(), text())],
        time: Some(text()),
    }
}

#[test]
fn any_text_and_any_number() {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 1e-300, 0.0, -0.0];
    let long: Vec<f64> = (0..20_000).map(|k| (k as f64 * 0.01).sin() * 1e-7).collect();
    let log =
        Plot { x: Axis { label: "w".to_owned(), log: true, range: None }, y: Axis { log: true, ..Axis::default() }, ..plot(odd.to_vec()) };
    let plots = vec![
        plot(Vec::new()),
        plot(vec![3.0; 50]),
        plot(vec![f64::NAN; 5]),
        plot(odd.to_vec()),
        plot(long),
        log,
        Plot { equal: true, circle: true, ..plot(vec![1.0]) },
    ];
    let html = page(plots.clone()).html();
    well_formed::check(&html);
    assert!(!html.contains("<script"), "text is escaped");
    assert!(!html.contains("NaN") && !html.contains("inf "), "no number that is none in a drawing");
    assert!(html.lines().nth(1).is_some_and(|l| l.starts_with("<!-- ") && l.ends_with(" -->")), "the mark stands in the first lines");
    assert_eq!(html, page(plots).html(), "equal bytes");
    assert!(html.len() < 600_000, "long series are thinned: {} bytes", html.len());
}

#[test]
fn what_is_measured_decides_the_axis() {
    let x = [0.0, 1.0, 2.0];
    let lost = Plot {
        series: vec![
            Series::line("measured", Ink::Measured, &x, &[0.0, 1.0, 0.5]),
            Series::line("model", Ink::Model, &x, &[0.0, 1.0, 1e30]),
        ],
        ..Plot::new("lost", "t [s]", "y")
    };
    let html = Page { blocks: vec![Block::Plots(vec![lost])], ..page(Vec::new()) }.html();
    assert!(html.contains("Values beyond the frame are cut."), "a run that leaves does not flatten what was measured");
    let ticks: Vec<&str> =
        html.match_indices("text-anchor=\"end\">").filter_map(|(at, m)| html[at + m.len()..].split('<').next()).collect();
    assert_eq!(ticks, ["0", "0.5", "1.0", "1.5", "2.0"]);
}
