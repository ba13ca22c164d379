"""How deriving grows with joints in CasADi and SymPy, on the rigs of the bench's growth table (rigs.rs, `family`).

usage: growth_peers.py [SECONDS]

One JSON line a model: seconds to M, forces and x' with [A, B], operations after common-subexpression elimination. CasADi:
Lagrange's equation with its automatic differentiation, as in casadi_peer.py. SymPy: Kane's method, then cse of M, forcing
and forcing's Jacobian (x' itself is not formed there). A model that takes more than SECONDS (60) ends its series.
"""

import json
import multiprocessing
import sys
import time

JOINTS = [2, 3, 4, 6, 8, 10, 15, 20, 30]


def parent(shape, i):
    """Parent of joint i (from 1); 0 is ground."""
    return i // 2 if shape == "tree" else i - 1


def axis(shape, i):
    """Axis of joint i."""
    return "y" if shape == "planar" else "zyx"[(i - 1) % 3]


def casadi(shape, n):
    """Seconds and operations of CasADi."""
    import casadi as ca
    from casadi_peer import Model, rotation, unit

    begin = time.perf_counter()
    m = Model(n, n, 1 + 3 * n)
    turns, ends, omegas = [ca.SX.eye(3)], [ca.SX.zeros(3)], [ca.SX.zeros(3)]
    for i in range(1, n + 1):
        mass, length, inertia = m.p[3 * i - 2], m.p[3 * i - 1], m.p[3 * i]
        before, step = parent(shape, i), rotation(axis(shape, i), m.q[i - 1])
        turn = turns[before] @ step
        omega = step.T @ omegas[before] + unit(axis(shape, i)) * m.v[i - 1]
        m.weigh(mass, ends[before] + turn @ ca.vertcat(length / 2, 0, 0), m.p[0])
        m.kinetic += inertia * ca.dot(omega, omega) / 2
        turns.append(turn)
        omegas.append(omega)
        ends.append(ends[before] + turn @ ca.vertcat(length, 0, 0))
    m.force = m.u
    x = ca.vertcat(m.q, m.v)
    (dx,) = ca.cse([m.dynamics()])
    a, b = ca.cse([ca.jacobian(dx, x), ca.jacobian(dx, m.u)])
    seconds = time.perf_counter() - begin
    forward = ca.Function("f", [x, m.u, m.p], [dx]).n_instructions()
    return seconds, forward, ca.Function("j", [x, m.u, m.p], [a, b]).n_instructions()


def sympy(shape, n):
    """Seconds and operations of SymPy."""
    import sympy as sm
    import sympy.physics.mechanics as me

    begin = time.perf_counter()
    q, v, u = me.dynamicsymbols(f"q1:{n + 1}"), me.dynamicsymbols(f"v1:{n + 1}"), sm.symbols(f"u1:{n + 1}")
    g = sm.Symbol("g")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    frames, ends, bodies, loads = [ground], [origin], [], []
    for i in range(1, n + 1):
        mass, length, inertia = sm.symbols(f"m_{i} l_{i} I_{i}")
        before = parent(shape, i)
        direction = getattr(frames[before], axis(shape, i))
        frame = frames[before].orientnew(f"F{i}", "Axis", (q[i - 1], direction))
        frame.set_ang_vel(frames[before], v[i - 1] * direction)
        center = ends[before].locatenew(f"C{i}", length / 2 * frame.x)
        center.v2pt_theory(ends[before], ground, frame)
        end = ends[before].locatenew(f"E{i}", length * frame.x)
        end.v2pt_theory(ends[before], ground, frame)
        bodies.append(me.RigidBody(f"B{i}", center, frame, mass, (me.inertia(frame, inertia, inertia, inertia), center)))
        loads += [(center, -mass * g * ground.z), (frame, u[i - 1] * direction), (frames[before], -u[i - 1] * direction)]
        frames.append(frame)
        ends.append(end)
    loads = [load for load in loads if load[0] is not ground]
    kane = me.KanesMethod(ground, q_ind=q, u_ind=v, kd_eqs=[a.diff() - b for a, b in zip(q, v)])
    kane.kanes_equations(bodies, loads)
    mass, forcing = kane.mass_matrix, kane.forcing
    forward = count(sm, [mass, forcing])
    return time.perf_counter() - begin, forward, count(sm, [mass, forcing, forcing.jacobian(q + v)])


def count(sm, what):
    """Operations after common-subexpression elimination."""
    subexpressions, results = sm.cse(what)
    return int(sum(e.count_ops() for _, e in subexpressions) + sum(sum(e.count_ops() for e in r) for r in results))


def one(tool, shape, n, answer):
    """A child process's work."""
    answer.put(tool(shape, n))


if __name__ == "__main__":
    limit = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    for tool in (casadi, sympy):
        for shape in ("planar", "chain", "tree"):
            for n in JOINTS:
                answer = multiprocessing.Queue()
                child = multiprocessing.Process(target=one, args=(tool, shape, n, answer))
                child.start()
                try:
                    seconds, forward, jacobians = answer.get(timeout=limit)
                except Exception:
                    child.terminate()
                    print(json.dumps({"tool": tool.__name__, "shape": shape, "joints": n, "seconds": f"more than {limit:g}"}), flush=True)
                    break
                child.join()
                line = {"tool": tool.__name__, "shape": shape, "joints": n, "seconds": round(seconds, 3), "f": forward, "jacobians": jacobians}
                print(json.dumps(line), flush=True)
