//! What records could not have shown of an effect that was found: next to rest friction has many laws, and most records hurry past.

use crate::effects::Effect;
use crate::search::{Round, State};

/// Static friction beyond Coulomb friction, in parts of it, that a rig may well have.
const AT_REST: f64 = 0.6;

/// Dry friction that was found, where a peak next to rest as it is usual would have gone unseen. `left` are the candidates of `round`, the
/// screening of `state`.
pub(crate) fn unseen(state: &State, left: &[&Effect], round: &Round) -> Option<String> {
    let of = |(included, own): (&crate::model::Included, &Vec<usize>)| {
        let effect = &included.effect;
        let level = state.fitted.mean().get(*own.first()?)?.abs();
        if effect.id != "coulomb" {
            return None;
        }
        let peaks = left.iter().zip(&round.scores).filter(|(e, _)| e.id == "stribeck" && e.place == effect.place);
        let least = peaks.filter_map(|(_, s)| s.minimal_detectable.first().copied()).fold(f64::INFINITY, f64::min);
        (least > AT_REST * level).then(|| {
            let more = if least.is_finite() {
                format!("static friction of up to {:.1} times it", 1.0 + least / level)
            } else {
                "any static friction".to_owned()
            };
            format!("{} is all that these records show of the friction on {}: next to rest {more} would go unseen", effect.id, effect.place)
        })
    };
    state.accepted.iter().zip(&state.prepared.of_effect).find_map(of)
}
