//! No text makes the front end panic, point outside of its text, or take long: seeded mutations of the rigs of this
//! project, and texts made to be deep, long or strange.
//!
//! `RIG_FUZZ=600 cargo test -p model-dsl --test hostile -- --ignored` searches for as many seconds, from a seed that it prints
//! (`RIG_FUZZ_SEED` repeats it); a text that breaks something is printed with it.

#[path = "../../tests/src/random.rs"]
mod random;
#[path = "../../tests/src/random_rig.rs"]
mod random_rig;

use model_dsl::{CheckOptions, Checked, Loader, Severity, check, check_text, check_tokens};
use random::Random;
use std::path::Path;
use std::time::{Duration, Instant};

/// One text of any bytes; other files are rigs of this project.
struct Bytes<'a>(&'a [u8]);

impl Loader for Bytes<'_> {
    fn load(&self, name: &str) -> Result<Vec<u8>, String> {
        if name == "hostile.rig" {
            return Ok(self.0.to_vec());
        }
        Err("there is no such file".to_owned())
    }
}

/// Checks, and demands what holds for every text.
fn survive(bytes: &[u8]) -> Checked {
    let checked = check("hostile.rig", &Bytes(bytes), &CheckOptions::default());
    let errors = checked.diagnostics.iter().any(|d| d.severity == Severity::Error);
    assert_eq!(checked.rig.is_none(), errors, "a rig comes out if and only if there is no error");
    for d in &checked.diagnostics {
        assert!(!d.labels.is_empty() && !d.message.is_empty(), "{d:?}");
        for (span, _) in &d.labels {
            let text = &checked.sources.files[span.file as usize].1;
            assert!(text.get(span.start as usize..span.end as usize).is_some(), "{d:?} points outside of the text, or into a character");
        }
    }
    for d in checked.diagnostics.iter().take(12) {
        assert!(d.render(&checked.sources, false).contains(d.code));
    }
    checked
}

/// Good rigs, and wrong ones.
fn rigs() -> [Vec<Vec<u8>>; 2] {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    [&["examples/rigs", "tests/rigs/statements", "tests/rigs/pass"][..], &["tests/rigs/fail"][..]].map(|folders| {
        let entries = folders.iter().flat_map(|f| std::fs::read_dir(root.join(f)).expect("rigs").flatten());
        let mut paths: Vec<_> = entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")).collect();
        paths.sort();
        paths.into_iter().map(|p| std::fs::read(p).expect("a readable file")).collect()
    })
}

const PIECES: [&str; 40] = [
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    ";",
    ",",
    ".",
    "..",
    ":",
    "=",
    "+-",
    "^",
    "-",
    "*",
    "/",
    "//",
    "/*",
    "\"",
    "'",
    "%",
    "1e308",
    "1e999",
    "0",
    "-1",
    "10deg",
    "9.81 [m/s^2]",
    "\u{feff}",
    "é",
    "\u{202e}",
    "𝜃",
    "\0",
    "in",
    "rig X {",
    "use \"hostile.rig\";",
    "extends Base",
    "replace",
    "remove",
    "theta.dot",
];

fn mutate(r: &mut Random, [good, wrong]: &[Vec<Vec<u8>>; 2]) -> Vec<u8> {
    let all = if r.chance(0.7) { good } else { wrong };
    let mut bytes = all[r.below(all.len())].clone();
    for _ in 0..1 + r.below(2) {
        let at = r.below(bytes.len() + 1);
        let until = (at + r.below(40)).min(bytes.len());
        match r.below(14) {
            0 if !bytes.is_empty() => {
                let at = at.min(bytes.len() - 1);
                bytes[at] ^= 1 << r.below(8);
            }
            1 => bytes.truncate(at),
            2 => {
                bytes.drain(at..until);
            }
            3 => {
                let piece = bytes[at..until].to_vec();
                bytes.splice(at..at, piece);
            }
            8..=10 => {
                // a digit becomes another
                if let Some(at) = (at..bytes.len()).find(|&k| bytes[k].is_ascii_digit()) {
                    bytes[at] = b'0' + r.below(10) as u8;
                }
            }
            11 | 12 => {
                // a blank more
                if let Some(at) = (at..bytes.len()).find(|&k| bytes[k] == b' ') {
                    bytes.insert(at, b" \n\t"[r.below(3)]);
                }
            }
            4 | 5 => {
                let piece = PIECES[r.below(PIECES.len())].as_bytes().to_vec();
                bytes.splice(at..at, piece);
            }
            6 => {
                // a line of another rig
                let other = &all[r.below(all.len())];
                let lines: Vec<&[u8]> = other.split(|b| *b == b'\n').collect();
                let line = lines[r.below(lines.len())].to_vec();
                bytes.splice(at..at, line);
            }
            _ => {
                // two words change places
                let text = String::from_utf8_lossy(&bytes).into_owned();
                let mut words: Vec<&str> = text.split_inclusive(' ').collect();
                if words.len() > 2 {
                    let (i, j) = (r.below(words.len()), r.below(words.len()));
                    words.swap(i, j);
                }
                bytes = words.concat().into_bytes();
            }
        }
    }
    bytes
}

#[test]
fn mutated_rigs_never_panic_and_every_place_lies_in_the_text() {
    let all = rigs();
    let mut r = Random::new(7);
    let mut good = 0;
    for _ in 0..2500 {
        let bytes = mutate(&mut r, &all);
        good += usize::from(survive(&bytes).rig.is_some());
    }
    println!("{good} of 2500 are good rigs");
    // mutations that leave nothing right, or nothing wrong, test little
    assert!(good > 100 && good < 2000, "{good} of 2500 are good rigs");
}

#[test]
fn tokens_of_a_macro_never_panic() {
    let all = rigs();
    let mut r = Random::new(11);
    for _ in 0..500 {
        let text = String::from_utf8_lossy(&mutate(&mut r, &all)).into_owned();
        // Rust's own lexer turns away what never reaches a macro
        if let Ok(stream) = text.parse() {
            let (checked, origin) = check_tokens("src/lib.rs", stream, &model_dsl::NoFiles, &CheckOptions::default());
            for d in &checked.diagnostics {
                let _ = origin.origin(d.labels[0].0);
                assert!(d.render(&checked.sources, false).contains(d.code));
            }
        }
    }
}

#[test]
fn noise_never_panics() {
    let mut r = Random::new(3);
    for k in 0..600 {
        let length = r.below(200);
        let text: String = match k % 3 {
            0 => (0..length).filter_map(|_| char::from_u32(r.below(0x11_0000) as u32)).collect(),
            1 => (0..length).map(|_| PIECES[r.below(PIECES.len())]).collect(),
            _ => (0..length).map(|_| format!("{} ", PIECES[r.below(PIECES.len())])).collect(),
        };
        survive(text.as_bytes());
        survive(format!("rig A {{ coord x: m; {text} }}").as_bytes());
        let bytes: Vec<u8> = (0..length).map(|_| r.below(256) as u8).collect();
        survive(&bytes);
    }
}

#[test]
fn random_rigs_that_are_right_are_taken() {
    for seed in 0..300 {
        let text = random_rig::random_rig(seed, 1 + seed as usize % 8);
        let checked = survive(text.as_bytes());
        let shown: Vec<String> = checked.diagnostics.iter().map(|d| d.render(&checked.sources, false)).collect();
        assert!(checked.rig.is_some(), "seed {seed}:\n{text}\n{}", shown.join("\n"));
    }
}

/// Far above what the texts need (most take milliseconds), far below what anything exponential or cubic takes.
fn bounded(what: &str, text: &str) -> Checked {
    let start = Instant::now();
    let checked = survive(text.as_bytes());
    let taken = start.elapsed();
    println!("{what}: {} bytes in {:.0} ms, {} findings", text.len(), taken.as_secs_f64() * 1e3, checked.diagnostics.len());
    assert!(taken < Duration::from_secs(10), "{what} took {taken:?}");
    checked
}

fn many(n: usize, line: impl Fn(usize) -> String) -> String {
    (0..n).map(line).collect()
}

const BODY: &str = "coord x: m; frame f = ground.translate(x, 0, 0); body b on f { mass 1; }";

#[test]
fn deep_texts_take_no_time() {
    let n = 10_000;
    let around = |open: &str, close: &str| format!("rig A {{ {BODY} potential v: {}1 [N*m]{}; }}", open.repeat(n), close.repeat(n));
    for (open, close) in
        [("(", ")"), ("-", ""), ("sin(", ")"), ("1 ^ (", ")"), ("[", "]"), ("1 / (1 + ", ")"), ("min(1, ", ")"), ("2^", ""), ("- (", ")")]
    {
        let checked = bounded(open, &around(open, close));
        assert!(checked.rig.is_none());
    }
    // as deep and as long as is allowed, level by level
    let mut deep = "1".to_owned();
    for _ in 0..30 {
        deep = format!("({deep}{})", " + 1".repeat(200));
    }
    bounded("sums in sums", &format!("rig A {{ {BODY} potential v: {deep} * 1 [N*m]; }}"));
    bounded("braces", &format!("rig A {{ {BODY} {} }}", "mix { ".repeat(n)));
    bounded("units", &format!("rig A {{ {BODY} param p: {}kg{} = 1; }}", "(".repeat(n), ")".repeat(n)));
    bounded("torque", &format!("rig A {{ {BODY} {} }}", format!("torque t on x: {} ", "(".repeat(3000)).repeat(20)));
}

#[test]
fn long_texts_take_time_in_proportion() {
    let n = 5_000;
    bounded("sum", &format!("rig A {{ {BODY} potential v: {}; }}", "1 [N*m] + ".repeat(n)));
    bounded("parameters", &format!("rig A {{ {BODY} {} }}", many(n, |k| format!("param p{k}: m = {k};\n"))));
    bounded(
        "derived, backwards",
        &format!("rig A {{ {BODY} {} derived d{n}: m = 1 m; }}", many(n, |k| format!("derived d{k}: m = d{} + 1 m;\n", k + 1))),
    );
    bounded(
        "derived in a circle",
        &format!("rig A {{ {BODY} {} derived d{n}: m = d0; }}", many(n, |k| format!("derived d{k}: m = d{} + 1 m;\n", k + 1))),
    );
    bounded(
        "chain of frames",
        &format!("rig A {{ {BODY} frame f0 = f; {} }}", many(n, |k| format!("frame f{} = f{k}.translate(1, 0, 0);\n", k + 1))),
    );
    bounded(
        "frames, backwards",
        &format!("rig A {{ {BODY} {} frame f{n} = f; }}", many(n, |k| format!("frame f{k} = f{}.translate(1, 0, 0);\n", k + 1))),
    );
    bounded(
        "coordinates",
        &format!(
            "rig A {{ {} }}",
            many(2000, |k| format!(
                "coord q{k}: rad; frame f{k} = ground.rotate(z, q{k}); body b{k} on f{k} {{ mass 1; at (1, 0, 0); }}\n"
            ))
        ),
    );
    bounded(
        "60 coordinates in a chain",
        &format!(
            "rig A {{ frame f0 = ground; {} }}",
            many(60, |k| format!(
                "coord q{k}: rad; frame f{} = f{k}.rotate(z, q{k}).translate(1, 0, 0); body b{k} on f{} {{ mass 1; }}\n",
                k + 1,
                k + 1
            ))
        ),
    );
    bounded(
        "unknown names",
        &format!(
            "rig A {{ {BODY} {} {} }}",
            many(n, |k| format!("param p{k}: m = 1;\n")),
            many(n, |k| format!("torque t{k} on x: u{k}n * 1 N;\n"))
        ),
    );
    bounded("unknown statements", &format!("rig A {{ {BODY} {} }}", many(n, |k| format!("parameter p{k}: m = 1;\n"))));
    bounded("same name", &format!("rig A {{ {BODY} {} }}", many(n, |_| "param p: m = 1;\n".to_owned())));
    bounded("forces", &format!("rig A {{ {BODY} {} }}", many(n, |k| format!("force t{k} on f: (1, 0, 0);\n"))));
    bounded(
        "extends",
        &format!("rig A0 {{ {BODY} }} {}", many(n / 2, |k| format!("rig A{} extends A{k} {{ param p{k}: m = 1; }}\n", k + 1))),
    );
    bounded(
        "replaced",
        &format!(
            "rig A0 {{ {BODY} param p: m = 1; }} {}",
            many(n / 2, |k| format!("rig A{} extends A{k} {{ replace param p: m = {k}; }}\n", k + 1))
        ),
    );
    bounded("comments", &format!("rig A {{ {} {BODY} }}", many(n, |k| format!("/// {k}\n"))));
    bounded("comments in a statement", &format!("rig A {{ {BODY} param {} p: m = 1; }}", many(n, |k| format!("/// {k}\n"))));
    bounded("rigs", &many(n, |k| format!("rig A{k} {{ {BODY} }}\n")));
    bounded("long word", &format!("rig A {{ {BODY} {} }}", "a".repeat(1_000_000)));
    bounded("long number", &format!("rig A {{ {BODY} param p: m = {}; }}", "9".repeat(300_000)));
    bounded("assumptions", &format!("rig A {{ {BODY} assume {{ {} }} }}", many(n, |_| "neglect coriolis;\n".to_owned())));
    bounded("entries", &format!("rig A {{ {BODY} friction x {{ {} }} }}", many(n, |k| format!("entry{k} 1;\n"))));
    bounded("trim", &format!("rig A {{ {BODY} trim t {{ {} }} }}", many(n, |_| "zero x;\n".to_owned())));
}

#[test]
fn numbers_of_any_size_come_out_finite_or_as_an_error() {
    for value in ["1e308", "1e-308", "4.9e-324", "0", "-0.0", "1e400", "1e-400", "9007199254740993"] {
        for rig in [
            format!(
                "rig A {{ param m: kg = {value}; coord x: m; frame f = ground.translate(x, 0, 0); body b on f {{ mass m; at (m / 1 kg * 1 m, 0, 0); inertia diag({value}, {value}, {value}); }} }}"
            ),
            format!(
                "rig A {{ {BODY} param k: N/m = {value}; derived d: N/m = k * k / k * 2; spring s on x {{ stiffness d; }} lump e = k^64; torque t on x: e * 0; }}"
            ),
            format!(
                "rig A {{ param m: kt = {value}; {BODY} body c on f {{ mass m; }} prescribed p: m = {value} m * exp({value} * t / 1 s); }}"
            ),
        ] {
            let checked = survive(rig.as_bytes());
            if let Some(rig) = checked.rig {
                assert!(rig.parameters.iter().all(|p| p.value.is_finite()));
            }
        }
    }
}

#[test]
fn a_text_of_any_size_is_refused_or_read() {
    assert!(check_text("empty.rig", "").rig.is_none());
    assert!(check_text("blank.rig", &" \n".repeat(100_000)).rig.is_none());
}

#[test]
#[ignore = "a search of RIG_FUZZ seconds"]
fn a_longer_search() {
    let number = |name: &str| std::env::var(name).ok().and_then(|v| v.parse::<u64>().ok());
    let seconds = number("RIG_FUZZ").unwrap_or(60);
    let seed = number("RIG_FUZZ_SEED")
        .unwrap_or_else(|| std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(1, |d| d.as_nanos() as u64));
    println!("seed {seed}, {seconds} s");
    let all = rigs();
    let mut r = Random::new(seed);
    let start = Instant::now();
    let mut texts = 0_u64;
    while start.elapsed() < Duration::from_secs(seconds) {
        let mut bytes = mutate(&mut r, &all);
        for _ in 0..r.below(3) {
            let other = mutate(&mut r, &all);
            let at = r.below(bytes.len() + 1);
            bytes.splice(at..at, other);
        }
        let before = Instant::now();
        let survived = std::panic::catch_unwind(|| drop(survive(&bytes)));
        assert!(survived.is_ok() && before.elapsed() < Duration::from_secs(10), "this text:\n{}", String::from_utf8_lossy(&bytes));
        texts += 1;
    }
    println!("{texts} texts");
}
