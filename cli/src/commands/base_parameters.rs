//! `rig base-parameters`.

use crate::args::BaseParameters;
use crate::failure::Failure;
use crate::load::{self, Loaded, unknown};
use crate::output::{Answer, number};
use codegen::Options;
use parameters::{Base, Finding, Known, Links, Relations, TOLERANCE, Verdict};
use serde_json::{Value, json};
use std::fmt::Write;

/// Deviation from 1 beyond which a relation counts as broken.
const BROKEN: f64 = 0.05;

pub fn run(args: &BaseParameters) -> Result<Answer, Failure> {
    let loaded = load::load(&args.rig)?;
    let equations = load::equations(&loaded, Options { jacobians: false, ..Options::default() })?;
    let known = known(args, &loaded)?;
    let rig = &loaded.rig;
    let base = parameters::base_parameters(rig, &equations, args.seed);
    let links = parameters::links(rig, loaded.lumps, args.seed);
    let relations = base.as_ref().map(|b| {
        let alone: Vec<String> =
            b.parameters.iter().map(|b| b.text.clone()).filter(|t| rig.parameters.iter().any(|p| p.name == *t)).collect();
        let lumps = if args.rig.expand_lumps { None } else { parameters::of_lumps(rig, &known, &alone, args.seed) };
        lumps.unwrap_or_else(|| parameters::of_base(rig, b, &known, args.seed))
    });
    let bodies = parameters::bodies(rig, loaded.lumps);
    let text = text(&loaded, base.as_ref(), links.as_ref(), relations.as_ref(), &bodies);
    Ok(Answer { text, json: document(&loaded, base.as_ref(), links.as_ref(), relations.as_ref(), &bodies) })
}

fn known(args: &BaseParameters, loaded: &Loaded) -> Result<Known, Failure> {
    let Some(names) = &args.known else { return Ok(Known::Lengths) };
    let names: Vec<&str> = names.iter().map(|n| n.trim()).filter(|n| !n.is_empty()).collect();
    let all: Vec<&str> = loaded.rig.parameters.iter().map(|p| p.name.as_str()).collect();
    match names.iter().find(|n| !all.contains(n)) {
        Some(wrong) => Err(unknown("parameter", wrong, &all)),
        None => Ok(Known::These(names.into_iter().map(str::to_owned).collect())),
    }
}

fn text(loaded: &Loaded, base: Option<&Base>, links: Option<&Links>, relations: Option<&Relations>, bodies: &[Finding]) -> String {
    let mut out = String::new();
    let title = loaded.rig.doc.lines().next().unwrap_or(&loaded.rig.name).trim();
    let _ = writeln!(out, "{title}: what the equations depend on\n");
    match base {
        Some(base) => base_text(&mut out, base),
        None => out.push_str("  the equations are too long to be multiplied out; the links' parameters are below\n"),
    }
    if let Some(links) = links {
        links_text(&mut out, links);
    }
    if let Some(relations) = relations {
        relations_text(&mut out, relations);
    }
    if !bodies.is_empty() {
        bodies_text(&mut out, bodies);
    }
    out
}

fn base_text(out: &mut String, base: &Base) {
    let width = base.parameters.iter().map(|b| b.text.chars().count()).max().unwrap_or(0).min(60);
    for b in &base.parameters {
        let pad = " ".repeat(width.saturating_sub(b.text.chars().count()));
        let _ = writeln!(out, "  {}{pad}  = {}", b.text, number(b.value));
    }
    let _ = writeln!(out, "\n  {} base parameters out of {} products of parameters (SI units).", base.parameters.len(), base.products);
    let _ = write!(
        out,
        "  Rank at {} random states: a column that was kept adds {:.0} % of its length or more",
        base.states,
        100.0 * base.least_kept
    );
    let _ = match base.most_dropped {
        0.0 => writeln!(out, "."),
        dropped => writeln!(out, ",\n  one that was put together {dropped:.0e} or less (limit {TOLERANCE:.0e})."),
    };
    list(out, "only in combination", &base.combined);
    list(out, "in no equation by themselves", &base.dead);
    list(out, "inside functions of the motion, held at their values", &base.inside);
}

fn list(out: &mut String, what: &str, names: &[String]) {
    if !names.is_empty() {
        let _ = writeln!(out, "  {what}: {}", names.join(", "));
    }
}

fn links_text(out: &mut String, links: &Links) {
    let _ = writeln!(
        out,
        "\nlinks, geometry and gravity known (mass m, first moments mc, inertias I about the link's origin; full derivation)\n  \
         {} of {} entries are independent",
        links.rank, links.entries
    );
    for c in &links.combined {
        let _ = writeln!(out, "  together: {c}");
    }
    list(out, "in no equation", &links.dead);
    list(out, "not affine, taken as known", &links.known);
}

fn relations_text(out: &mut String, relations: &Relations) {
    let count = relations.quantities.len();
    let _ = write!(out, "\nrelations: {count} quantities, {} of them free", relations.freedom);
    let _ = if relations.known.is_empty() { writeln!(out) } else { writeln!(out, " if {} are known", relations.known.join(", ")) };
    for r in &relations.products {
        let means = if r.means.is_empty() { String::new() } else { format!(" = {}", r.means) };
        let _ = write!(out, "  {}{means} = {}", r.product(), number(r.expected));
        if r.found == r.expected {
            out.push('\n');
        } else if (r.factor() - 1.0).abs() <= BROKEN {
            let _ = writeln!(out, ";  the values give {} ({:+.2} %)", number(r.found), 100.0 * (r.factor() - 1.0));
        } else {
            let factor = if r.factor().abs() < 1.0 { 1.0 / r.factor() } else { r.factor() };
            let _ = writeln!(out, ";  the values give {}: BROKEN by a factor {factor:.2}", number(r.found));
        }
    }
    let further = count.saturating_sub(relations.freedom + relations.products.len());
    if further > 0 {
        let _ = writeln!(out, "  {further} more that {} no product of powers", if further == 1 { "is" } else { "are" });
    }
}

fn words(verdict: Verdict) -> String {
    match verdict {
        Verdict::Possible => "possible".to_owned(),
        Verdict::NegativeMass => "IMPOSSIBLE: its mass is negative".to_owned(),
        Verdict::NegativeMoment { least } => format!(
            "IMPOSSIBLE: about its centre of mass a moment of inertia would be {} kg m^2; the one about the origin is below m r^2",
            number(least)
        ),
        Verdict::Triangle { missing } => format!(
            "not a body as declared: one central moment exceeds the sum of the others by {} kg m^2 (of no effect where the others are in no equation)",
            number(missing)
        ),
    }
}

fn bodies_text(out: &mut String, bodies: &[Finding]) {
    let _ = writeln!(out, "\nbodies: can masses, centres and inertias belong to one (pseudo-inertia without a negative eigenvalue)");
    let width = bodies.iter().map(|b| b.body.chars().count()).max().unwrap_or(0);
    for b in bodies {
        let pad = " ".repeat(width - b.body.chars().count());
        let _ = writeln!(out, "  {}{pad}  {}", b.body, words(b.verdict));
    }
}

fn document(loaded: &Loaded, base: Option<&Base>, links: Option<&Links>, relations: Option<&Relations>, bodies: &[Finding]) -> Value {
    let relation = |r: &parameters::Relation| {
        json!({"product": r.product(), "powers": r.powers.iter().map(|(n, k)| json!([n, k])).collect::<Vec<_>>(), "means": r.means,
               "expected": r.expected, "found": r.found, "factor": r.factor(), "broken": (r.factor() - 1.0).abs() > BROKEN})
    };
    json!({
        "rig": loaded.rig.name,
        "base": base.map_or_else(Vec::new, |b| b.parameters.iter().map(|b| json!({"parameter": b.text, "value": b.value})).collect()),
        "products": base.map(|b| b.products),
        "combined": base.map(|b| &b.combined),
        "dead": base.map(|b| &b.dead),
        "inside": base.map(|b| &b.inside),
        "tolerance": TOLERANCE,
        "links": links.map(|l| json!({"entries": l.entries, "rank": l.rank, "combined": l.combined, "dead": l.dead, "known": l.known})),
        "relations": relations.map_or_else(Vec::new, |r| r.products.iter().map(relation).collect()),
        "quantities": relations.map(|r| &r.quantities),
        "freedom": relations.map(|r| r.freedom),
        "known": relations.map(|r| &r.known),
        "bodies": bodies.iter().map(|b| json!({"body": b.body, "possible": b.verdict == Verdict::Possible, "verdict": words(b.verdict),
            "mass": b.inertia.mass, "center": b.inertia.center.as_slice(), "least_eigenvalue": b.least_eigenvalue})).collect::<Vec<_>>(),
    })
}
