//! Figures of speed: deriving, compiling in the process, evaluating; beside CasADi on the same models and machine.
mod hand;
mod rigs;
mod timing;
use jit::{Evaluation, InProcess};
use runtime::Model;
use std::hint::black_box;

fn main() {
    let only: Vec<String> = std::env::args().skip(1).collect();
    for (name, text) in rigs::COMPARED {
        let rig = rigs::check(name, text).unwrap();
        let (d, e) = timing::fastest(5, || rigs::equations(&rig).unwrap());
        println!("{name}: derive {d:.2} ms ops {} / {}", e.forward_operations(), e.jacobian_operations());
        measure(e);
    }
    for shape in [rigs::Shape::Planar, rigs::Shape::Chain, rigs::Shape::Tree] {
        for n in [3, 4, 6, 8, 10, 20] {
            if only.is_empty() {
                continue;
            }
            let rig = rigs::check("f", &rigs::family(shape, n)).unwrap();
            let (d, e) = timing::fastest(2, || rigs::equations(&rig).unwrap());
            println!(
                "{} n={n}: derive {d:.2} ms ops {} / {}  nodes {}",
                shape as usize,
                e.forward_operations(),
                e.jacobian_operations(),
                e.graph.len()
            );
            if only[0] == "all" {
                measure(e);
            }
        }
    }
}

fn measure(e: codegen::Equations) {
    let m = InProcess::evaluated(e, Evaluation::Compiled);
    let d = m.dimensions();
    let n = d.states();
    let mut x: Vec<f64> = (0..n).map(|i| 0.1 * (i as f64 + 1.0)).collect();
    let u: Vec<f64> = (0..d.signals()).map(|i| 1.5 - 0.1 * i as f64).collect();
    let mut p = vec![0.0; d.parameters];
    m.nominal(&mut p);
    let (mut dx, mut a, mut b) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; n * d.signals()]);
    let (cf, _) = timing::fastest(1, || m.rhs(0.0, &x, &u, &p, &mut dx).unwrap());
    let (cj, _) = timing::fastest(1, || m.linearize(0.0, &x, &u, &p, &mut dx, &mut a, &mut b).unwrap());
    let x0 = x[0];
    let f = timing::per_call(|h| {
        x[0] = x0 + h;
        m.rhs(0.0, black_box(&x), &u, &p, &mut dx).unwrap();
        black_box(&dx);
    });
    let j = timing::per_call(|h| {
        x[0] = x0 + h;
        m.linearize(0.0, black_box(&x), &u, &p, &mut dx, &mut a, &mut b).unwrap();
        black_box(&a);
    });
    println!("   compile {cf:.2} {cj:.2} ms; f {f:.1} ns, [A,B] {j:.1} ns");
    if d.parameters == 16 {
        let (hx, hu, hp): ([f64; 6], [f64; 2], [f64; 16]) =
            (x.clone().try_into().unwrap(), u.clone().try_into().unwrap(), p.clone().try_into().unwrap());
        m.rhs(0.0, &x, &u, &p, &mut dx).unwrap();
        println!("   {:?}\n   {:?}", hand::heli3(&hx, &hu, &hp), dx);
        let mut hx = hx;
        let f = timing::per_call(|h| {
            hx[0] = x0 + h;
            black_box(hand::heli3(black_box(&hx), black_box(&hu), black_box(&hp)));
        });
        println!("   hand {f:.1}");
    }
}
