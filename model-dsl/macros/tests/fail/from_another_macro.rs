macro_rules! cart {
    ($mass:expr) => {
        rig_macros::rig! {
            rig Cart {
                coord x: m;
                frame carriage = ground.translate(x, 0, 0);
                body load on carriage { mass $mass; }
            }
        }
    };
}

cart!(20 * mm);

fn main() {}
