//! Equations as a person writes them.
use std::path::PathBuf;
fn rigs() -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs");
    let mut paths: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().flatten().map(|e| e.path()).filter(|p| p.extension().is_some_and(|x| x == "rig")).collect();
    paths.sort();
    paths
}
#[test]
fn look() {
    for path in rigs() {
        let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        let rig = checked.rig.unwrap();
        let e = codegen::derive(&rig, codegen::Options::default()).unwrap();
        println!("{}", codegen::display::text(&rig, &e));
        println!("{}", codegen::display::latex(&rig, &e));
        println!("{:#?}", codegen::display::strings(&rig, &e).input_map);
    }
}
#[test]
fn differences() {
    let get = |n: &str| {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../examples/rigs").join(n);
        let checked = model_dsl::check(&path.display().to_string(), &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        let rig = checked.rig.unwrap();
        let e =
            codegen::derive(&rig, codegen::Options { lumps: codegen::Lumps::Expanded, jacobians: false, ..codegen::Options::default() })
                .unwrap();
        (rig, e)
    };
    for (a, b) in [
        ("googol.rig", "googol_mrb.rig"),
        ("googol_mrb.rig", "googol_eq13.rig"),
        ("googol_mrb.rig", "googol_identified.rig"),
        ("googol_srb.rig", "googol.rig"),
        ("googol.rig", "googol.rig"),
    ] {
        let (a1, b1) = (get(a), get(b));
        println!("$ {a} {b}\n{}", codegen::display::diff((&a1.0, &a1.1), (&b1.0, &b1.1)));
    }
}
#[test]
fn odd() {
    for name in ["/tmp/odd.rig", "/tmp/six.rig"] {
        let checked = model_dsl::check(name, &model_dsl::FileLoader, &model_dsl::CheckOptions::default());
        for d in &checked.diagnostics { println!("{}", d.render(&checked.sources, false)); }
        let Some(rig) = checked.rig else { continue };
        let e = codegen::derive(&rig, codegen::Options { jacobians: false, ..codegen::Options::default() }).unwrap();
        let t = std::time::Instant::now();
        println!("{}", codegen::display::text(&rig, &e));
        println!("TIME {:?}", t.elapsed());
        let t = std::time::Instant::now();
        println!("{}", codegen::display::diff((&rig, &e), (&rig, &e)));
        println!("TIME diff {:?}", t.elapsed());
    }
}
