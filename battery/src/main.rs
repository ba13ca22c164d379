//! `cargo run --release -p battery -- --row ROW --runs N --out FILE [--resume] [--threads 2] [--rigs a,b] [--part NAME] [--numbers 3,7]
//! [--effect ID] [--records FOLDER] [--aloud]`; `--table FILE ..` prints what files hold; `--growth` what a diagnosis costs; `--again RESULTS --records FOLDER
//! --out FILE` diagnoses records once more that were kept; `--examples FOLDER` writes the
//! records of `examples/hidden`.

use battery::growth;
use battery::rigs::Rig;
use battery::rows::{ROWS, tasks};
use battery::run::{Hiding, Outcome, Task, run};
use battery::table::tables;
use std::collections::BTreeSet;
use std::io::Write;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

const USAGE: &str = "usage: battery --row ROW --runs N --out FILE [--resume] [--threads N] [--rigs a,b] [--part NAME] [--numbers 3,7] [--effect ID] [--records FOLDER] [--aloud]\n       battery --table FILE ..\n       battery --growth\n       battery --again RESULTS --records FOLDER --out FILE\n       battery --examples FOLDER";

fn main() -> ExitCode {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let done = match given.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--growth"] => growth::table().map(|table| say(&table)),
        ["--growth-case", samples, entries] => one_case(samples, entries),
        ["--again", results, "--records", records, "--out", out] => again(results, records, out),
        _ => work(given),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// To who reads it; nobody has to read to the end.
fn say(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// A case of the growth, for the process that asked for it.
fn one_case(samples: &str, entries: &str) -> Result<(), String> {
    let number = |text: &str| text.parse::<usize>().map_err(|_| format!("`{text}` is no number\n{USAGE}"));
    let cost = growth::case(number(samples)?, number(entries)?)?;
    say(&serde_json::to_string(&cost).map_err(|e| e.to_string())?);
    Ok(())
}

/// Records that were kept, diagnosed again.
fn again(results: &str, records: &str, out: &str) -> Result<(), String> {
    let mut file = std::fs::OpenOptions::new().create_new(true).append(true).open(out).map_err(|e| format!("{out}: {e}"))?;
    for outcome in read(results)? {
        let new = battery::run::again(&outcome, std::path::Path::new(records))?;
        let line = serde_json::to_string(&new).map_err(|e| e.to_string())?;
        writeln!(file, "{line}").map_err(|e| format!("{out}: {e}"))?;
    }
    Ok(())
}

struct Arguments {
    rows: Vec<&'static str>,
    runs: u64,
    out: Option<String>,
    resume: bool,
    threads: usize,
    rigs: Vec<Rig>,
    part: Option<String>,
    table: Vec<String>,
    examples: Option<String>,
    records: Option<String>,
    numbers: Vec<u64>,
    aloud: bool,
    effect: Option<&'static str>,
}

fn arguments(given: Vec<String>) -> Result<Arguments, String> {
    let mut own = Arguments {
        rows: Vec::new(),
        runs: 20,
        out: None,
        resume: false,
        threads: 2,
        rigs: Rig::ALL.to_vec(),
        part: None,
        table: Vec::new(),
        examples: None,
        records: None,
        numbers: Vec::new(),
        aloud: false,
        effect: None,
    };
    let mut given = given.into_iter().peekable();
    while let Some(word) = given.next() {
        let mut value = || given.next().ok_or_else(|| format!("{word} needs a value\n{USAGE}"));
        match word.as_str() {
            "--row" => {
                let name = value()?;
                let known =
                    ROWS.iter().find(|r| **r == name).ok_or_else(|| format!("there is no row `{name}`; rows are {}", ROWS.join(", ")))?;
                own.rows.push(known);
            }
            "--runs" => own.runs = value()?.parse().map_err(|_| format!("--runs needs a number\n{USAGE}"))?,
            "--threads" => own.threads = value()?.parse().map_err(|_| format!("--threads needs a number\n{USAGE}"))?,
            "--out" => own.out = Some(value()?),
            "--part" => own.part = Some(value()?),
            "--rigs" => {
                let list = value()?;
                own.rigs = list
                    .split(',')
                    .map(|name| Rig::ALL.into_iter().find(|r| r.name() == name.trim()).ok_or_else(|| format!("there is no rig `{name}`")))
                    .collect::<Result<_, _>>()?;
            }
            "--effect" => {
                let id = value()?;
                let known = diagnose::effects::IDS.into_iter().find(|known| *known == id);
                own.effect =
                    Some(known.ok_or_else(|| format!("there is no effect `{id}`; effects are {}", diagnose::effects::IDS.join(", ")))?);
            }
            "--records" => own.records = Some(value()?),
            "--examples" => own.examples = Some(value()?),
            "--numbers" => {
                let list = value()?;
                let each = list.split(',').map(|n| n.trim().parse().map_err(|_| format!("`{n}` is no number of a run\n{USAGE}")));
                own.numbers = each.collect::<Result<_, _>>()?;
            }
            "--aloud" => own.aloud = true,
            "--resume" => own.resume = true,
            "--table" => own.table = given.by_ref().collect(),
            _ => return Err(format!("`{word}` is not known\n{USAGE}")),
        }
    }
    Ok(own)
}

fn read(path: &str) -> Result<Vec<Outcome>, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{path}: {e}"))?;
    let mut all = Vec::new();
    for (number, line) in text.lines().enumerate() {
        match serde_json::from_str(line) {
            Ok(outcome) => all.push(outcome),
            // such as the last one of a battery that was stopped: it is made again
            Err(why) => eprintln!("{path}:{}: left out, since it cannot be read: {why}", number + 1),
        }
    }
    Ok(all)
}

fn work(given: Vec<String>) -> Result<(), String> {
    let arguments = arguments(given)?;
    if !arguments.table.is_empty() {
        let mut all = Vec::new();
        for path in &arguments.table {
            all.extend(read(path)?);
        }
        say(&tables(&all));
        return Ok(());
    }
    if let Some(folder) = &arguments.examples {
        for (name, text) in battery::examples::files() {
            let path = std::path::Path::new(folder).join(name);
            std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))?;
        }
        return Ok(());
    }
    let (Some(out), false) = (&arguments.out, arguments.rows.is_empty()) else { return Err(USAGE.to_owned()) };
    let exists = std::path::Path::new(out).exists();
    if exists && !arguments.resume {
        return Err(format!("{out} is there already; --resume goes on with it"));
    }
    let before = if exists { read(out)? } else { Vec::new() };
    let key = |row: &str, part: &str, rig: &str, number: u64| format!("{row}|{part}|{rig}|{number}");
    let done: BTreeSet<String> = before.iter().map(|o| key(&o.row, &o.part, &o.rig, o.number)).collect();
    let all: Vec<_> = arguments
        .rows
        .iter()
        .flat_map(|row| tasks(row, arguments.runs, &arguments.rigs))
        .filter(|t| arguments.part.as_ref().is_none_or(|p| t.part == *p))
        .filter(|t| arguments.numbers.is_empty() || arguments.numbers.contains(&t.number))
        .map(|t| match (arguments.effect, t.hiding) {
            // this one instead of any
            (Some(effect), Hiding::Some(1, multiple)) => Task { hiding: Hiding::This(effect, multiple), ..t },
            _ => t,
        })
        .filter(|t| !done.contains(&key(t.row, &t.part, t.rig.name(), t.number)))
        .collect();
    let file = std::fs::OpenOptions::new().create(true).append(true).open(out).map_err(|e| format!("{out}: {e}"))?;
    let (file, next, found) = (Mutex::new(file), AtomicUsize::new(0), Mutex::new(before));
    let began = std::time::Instant::now();
    std::thread::scope(|scope| {
        for _ in 0..arguments.threads.max(1) {
            scope.spawn(|| {
                while let Some(task) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let Some(outcome) = run(task, arguments.records.as_deref().map(std::path::Path::new), arguments.aloud) else {
                        continue;
                    };
                    if let (Ok(line), Ok(mut file)) = (serde_json::to_string(&outcome), file.lock()) {
                        let _ = writeln!(file, "{line}");
                    }
                    if let Ok(mut found) = found.lock() {
                        found.push(outcome);
                        if found.len() % 20 == 0 {
                            eprintln!("{} runs, {:.0} s", found.len(), began.elapsed().as_secs_f64());
                        }
                    }
                }
            });
        }
    });
    say(&tables(&found.into_inner().map_err(|_| "a thread failed")?));
    Ok(())
}
