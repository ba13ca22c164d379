rig_macros::rig! {
    use "tests/fail/rigs/wrong.rig";

    rig Heavier extends Wrong {
        body load on cart { mass 1 kg; }
    }
}

fn main() {}
