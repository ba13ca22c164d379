//! `rig base-parameters` as its users run it.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn rig(arguments: &[&str]) -> Output {
    let rigs = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, |p| p.join("examples/rigs"));
    Command::new(env!("CARGO_BIN_EXE_rig")).current_dir(rigs).args(arguments).output().expect("the program starts")
}

fn text(arguments: &[&str]) -> String {
    let output = rig(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn json_names_the_base_and_the_broken_relation() {
    let document: Value = serde_json::from_str(&text(&["base-parameters", "googol_identified.rig", "--json"])).expect("one document");
    assert_eq!(document["base"].as_array().map(Vec::len), Some(10));
    assert_eq!(document["freedom"], 8);
    let relations = document["relations"].as_array().expect("relations");
    assert_eq!((&relations[0]["product"], &relations[0]["broken"]), (&"a1 b2/(a3 b1)".into(), &true.into()));
    assert_eq!(relations[1]["broken"], false);
}

#[test]
fn the_screen_says_what_is_broken_and_by_how_much() {
    let screen = text(&["base-parameters", "googol_identified.rig"]);
    assert!(screen.contains("a1 b2/(a3 b1) = l_df/l_oc = 0.217949;  the values give 0.103066: BROKEN by a factor 2.11"), "{screen}");
    let expanded = text(&["base-parameters", "googol_identified.rig", "--expand-lumps"]);
    assert!(!expanded.contains("BROKEN"), "the definitions agree with themselves: {expanded}");
}

/// Design C.0, model 3.0 of the same laboratory as the example rig.
#[test]
fn a_published_set_that_no_body_can_have_is_named() {
    let set = [
        "m_1=0.6416937799349799",
        "r_1=0.2",
        "l_1=0.2",
        "I_1=0.02671076499939512",
        "m_2=0.563935954099688",
        "r_2=0.3212669909674605",
        "I_2=0.053878129629650884",
        "I_r=9.937281205437459e-05",
    ];
    let mut arguments = vec!["base-parameters", "double_pendulum.rig"];
    set.iter().for_each(|s| arguments.extend(["--set", s]));
    let screen = text(&arguments);
    assert!(screen.contains("upper_link  possible"), "{screen}");
    assert!(screen.contains("lower_link  IMPOSSIBLE: about its centre of mass a moment of inertia would be -0.0043271 kg m^2"), "{screen}");
}

#[test]
fn a_wrong_name_is_told() {
    let output = rig(&["base-parameters", "googol.rig", "--known", "l_dc"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && said.contains("did you mean"), "{said}");
}
