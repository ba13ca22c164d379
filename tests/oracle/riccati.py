"""Riccati equations: SciPy's answers for random systems, and 100-digit answers for ill-conditioned ones.

Writes tests/oracle/riccati.json. Random systems are made from seeds by the generator that
tests/tests/riccati.rs has too (SplitMix64), so that only the answers are stored: X w for a fixed vector w, the norm
of X, and SciPy's residual. Benchmarks are stored with their data; their answers come from the matrix sign function
(CARE) and from doubling (DARE) in 100 digits, checked by their residual.

    python3 -m venv .venv && .venv/bin/pip install -r tests/oracle/requirements-riccati.txt
    .venv/bin/python tests/oracle/riccati.py
"""

import json
import pathlib
import warnings

import mpmath as mp
import numpy as np
from scipy.linalg import solve_continuous_are, solve_discrete_are

MASK = (1 << 64) - 1
mp.mp.dps = 100


class Random:
    """SplitMix64, as tests/src/random.rs."""

    def __init__(self, seed):
        self.state = ((seed * 0xD1B54A32D192ED03) & MASK) ^ 0x5851F42D4C957F2D

    def bits(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return z ^ (z >> 31)

    def below(self, n):
        return self.bits() % max(n, 1)

    def within(self, lo, hi):
        return lo + (hi - lo) * ((self.bits() >> 11) / float(1 << 53))

    def matrix(self, rows, columns, size=1.0):
        return np.array([[self.within(-size, size) for _ in range(columns)] for _ in range(rows)]).reshape(rows, columns)


def system(seed, discrete):
    """Stabilizable by construction: what no input reaches is stable. Same steps as in tests/tests/riccati.rs."""
    r = Random(seed)
    n = 1 + r.below(20)
    m = 1 + r.below(min(n, 4))
    kind = r.below(4)
    size = r.within(0.3, 2.0)
    a = r.matrix(n, n, size)
    b = r.matrix(n, m)
    if kind % 2 == 1 and n > 1:
        hidden = 1 + r.below(n // 2)
        for i in range(n - hidden, n):
            b[i, :] = 0.0
            for j in range(i):
                a[i, j] = 0.0
            a[i, i] = r.within(-0.9, 0.9) if discrete else r.within(-2.0, -0.1)
    v = r.matrix(n, 1)
    turn = np.eye(n) - v @ v.T * (2.0 / float((v.T @ v)[0, 0]))
    a, b = turn @ a @ turn, turn @ b
    if kind >= 2:
        d = np.array([2.0 ** round_half_away(r.within(-8.0, 8.0)) for _ in range(n)])
        a, b = a * d[:, None] / d[None, :], b * d[:, None]
    c = r.matrix(1 + r.below(n), n)
    f = r.matrix(m, m)
    return a, b, c.T @ c, f @ f.T + 0.1 * np.eye(m)


def round_half_away(x):
    return int(np.floor(abs(x) + 0.5)) * (1 if x >= 0 else -1)


def residual(a, b, q, r, x, discrete):
    """Norm of the equation over the sum of its terms' norms."""
    xb = x @ b
    if discrete:
        gain = np.linalg.solve(r + b.T @ xb, xb.T @ a)
        terms = [a.T @ x @ a, -x, -a.T @ xb @ gain, q]
    else:
        gain = np.linalg.solve(r, xb.T)
        terms = [x @ a, (x @ a).T, -xb @ gain, q]
    return float(np.linalg.norm(sum(terms)) / sum(np.linalg.norm(t) for t in terms))


def direction(n):
    return np.array([((7 * i) % 11 - 5) / 5.0 for i in range(n)])


def scipy_answer(a, b, q, r, discrete):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            x = (solve_discrete_are if discrete else solve_continuous_are)(a, b, q, r)
    except (np.linalg.LinAlgError, ValueError):
        return None
    return {"xw": list(x @ direction(len(a))), "norm": float(np.linalg.norm(x)), "residual": residual(a, b, q, r, x, discrete)}


def exact(a, b, q, r, discrete):
    """The stabilizing solution in 100 digits, from the double-precision data taken as exact."""
    n = len(a)
    a, b, q, r = (mp.matrix(m.tolist()) for m in (a, b, q, r))
    g = b * mp.inverse(r) * b.T
    if discrete:
        e, h = a, q
        for _ in range(80):
            w = mp.inverse(mp.eye(n) + g * h)
            step = e.T * h * w * e
            g, h, e = g + e * w * g * e.T, h + step, e * w * e
            if mp.mnorm(step, "f") <= mp.mpf(10) ** -50 * mp.mnorm(h, "f"):
                break
        x = h
        value = a.T * x * mp.inverse(mp.eye(n) + b * mp.inverse(r) * b.T * x) * a - x + q
    else:
        s = mp.zeros(2 * n)
        for i in range(n):
            for j in range(n):
                s[i, j], s[i, n + j], s[n + i, j], s[n + i, n + j] = a[i, j], -g[i, j], -q[i, j], -a[j, i]
        for step in range(200):
            inverse = mp.inverse(s)
            c = mp.sqrt(mp.mnorm(inverse, "f") / mp.mnorm(s, "f")) if step < 40 else mp.mpf(1)
            following = (s * c + inverse / c) / 2
            change = mp.mnorm(following - s, "f") / mp.mnorm(following, "f")
            s = following
            if change < mp.mpf(10) ** -45 and step < 40:
                continue
            if change < mp.mpf(10) ** -45:
                break
        one = mp.eye(n)
        left = mp.zeros(2 * n, n)
        right = mp.zeros(2 * n, n)
        for i in range(n):
            for j in range(n):
                left[i, j], left[n + i, j] = s[i, n + j], s[n + i, n + j] + one[i, j]
                right[i, j], right[n + i, j] = -(s[i, j] + one[i, j]), -s[n + i, j]
        x = mp.inverse(left.T * left) * (left.T * right)
        value = a.T * x + x * a - x * g * x + q
    relative = mp.mnorm(value, "f") / mp.mnorm(x, "f")
    size = mp.mnorm(a, "f") + mp.mnorm(g, "f") * mp.mnorm(x, "f") + 1
    assert relative < mp.mpf(10) ** -22 * size, f"100 digits do not suffice: {mp.nstr(relative, 3)}"
    return [[float((x[i, j] + x[j, i]) / 2) for j in range(n)] for i in range(n)]


def chain_of_vehicles(count):
    """CAREX 3.1: positions and speeds of vehicles in a row."""
    n = 2 * count - 1
    a, b, q = np.zeros((n, n)), np.zeros((n, count)), np.zeros((n, n))
    for i in range(count):
        a[2 * i, 2 * i] = -1.0
        b[2 * i, i] = 1.0
        if i < count - 1:
            a[2 * i + 1, 2 * i], a[2 * i + 1, 2 * i + 2] = 1.0, -1.0
            q[2 * i + 1, 2 * i + 1] = 10.0
    return a, b, q, np.eye(count)


def benchmarks():
    """(name, discrete, A, B, Q, R).

    Numbered as in P. Benner, A. Laub, V. Mehrmann, A collection of benchmark examples for the numerical solution of
    algebraic Riccati equations I (continuous) and II (discrete), Tech. Reports SPC 95_22 and 95_23, TU Chemnitz 1995.
    """
    one, col = np.eye, lambda *v: np.array(v, float).reshape(-1, 1)
    m = lambda *rows: np.array(rows, float)
    yield "carex 1.2", False, m([4, 3], [-4.5, -3.5]), col(1, -1), m([9, 6], [6, 4]), one(1)
    yield "carex 1.3", False, m([0, 1, 0, 0], [0, -1.89, 0.39, -5.53], [0, -0.034, -2.98, 2.43], [0.034, -0.0011, -0.99, -0.21]), m(
        [0, 0], [0.36, -1.6], [-0.95, -0.032], [0.03, 0]
    ), m([2.313, 2.727, 0.688, 0.023], [2.727, 4.271, 1.148, 0.323], [0.688, 1.148, 0.313, 0.102], [0.023, 0.323, 0.102, 0.083]), one(2)
    for e in (1.0, 1e-3, 1e-6, 1e-8):
        yield f"carex 2.1 {e:g}", False, np.diag([1.0, -2.0]), col(e, 0), np.ones((2, 2)), one(1)
    for e in (1e-2, 1e-6, 1e-8):
        yield f"carex 2.2 {e:g}", False, np.diag([-0.1, -0.02]), m([0.1, 0], [0.001, 0.01]), m([100, 1000], [1000, 10000]), m([1 + e, 1], [1, 1])
    for e in (1e-6, 1.0, 1e6):
        yield f"carex 2.3 {e:g}", False, m([0, e], [0, 0]), col(0, 1), one(2), one(1)
    for e in (1.0, 1e-5, 1e-7):
        yield f"carex 2.4 {e:g}", False, m([1 + e, 1], [1, 1 + e]), one(2), e * e * one(2), one(2)
    for e in (1.0, 1e-3, 1e-6):
        yield f"carex 2.5 {e:g}", False, m([3 - e, 1], [4, 2 - e]), col(1, 1), m([4 * e - 11, 2 * e - 5], [2 * e - 5, 2 * e - 2]), one(1)
    v = one(3) - np.ones((3, 3)) * (2 / 3)
    for e in (1.0, 1e3, 1e6):
        q = v @ np.diag([1 / e, 1, e]) @ v
        a = e * (v @ np.diag([1.0, 2, 3]) @ v)
        yield f"carex 2.6 {e:g}", False, a, one(3), (q + q.T) / 2, e * one(3)
    for e in (1.0, 1e-6):
        yield f"carex 2.7 {e:g}", False, m([0, 0.4, 0, 0], [0, 0, 0.345, 0], [0, -0.524 / e, -0.465 / e, 0.262 / e], [0, 0, 0, -1 / e]), col(
            0, 0, 0, 1 / e
        ), np.diag([1.0, 0, 1, 0]), one(1)
    for e in (1.0, 1e-3, 1e-6):
        yield f"carex 2.8 {e:g}", False, m([-e, 1, 0, 0], [-1, -e, 0, 0], [0, 0, e, 1], [0, 0, -1, e]), np.ones((4, 1)), np.ones((4, 4)), one(1)
    for count in (5, 10):
        yield f"carex 3.1 N = {count}", False, *chain_of_vehicles(count)
    n = 16
    ring = one(n, k=1) + one(n, k=-1) - 2 * one(n)
    ring[0, n - 1] = ring[n - 1, 0] = 1.0
    yield f"carex 3.2 n = {n}", False, ring, one(n), one(n), one(n)
    for n in (6, 12, 21):
        yield f"carex 3.3 n = {n}", False, one(n, k=1), one(n)[:, -1:], one(n)[:, :1] @ one(n)[:1, :], one(1)

    yield "darex 1.1", True, m([4, 3], [-4.5, -3.5]), col(1, -1), m([9, 6], [6, 4]), one(1)
    yield "darex 1.2", True, np.diag([0.9512, 0.9048]), m([4.877, 4.877], [-1.1895, 3.569]), np.diag([0.005, 0.02]), np.diag([1 / 3, 3.0])
    yield "darex 1.6", True, m([0.998, 0.067, 0, 0], [-0.067, 0.998, 0, 0], [0, 0, 0.998, 0.153], [0, 0, -0.153, 0.998]), m(
        [0.0033, 0.02], [0.1, -0.0007], [0.04, 0.0073], [-0.0028, 0.1]
    ), m([1.87, 0, 0, -0.244], [0, 0.744, 0.205, 0], [0, 0.205, 0.589, 0], [-0.244, 0, 0, 1.048]), one(2)
    yield "darex 1.7", True, m(
        [0.98475, -0.079903, 0.0009054, -0.0010765], [0.041588, 0.99899, -0.035855, 0.012684], [-0.54662, 0.044916, -0.32991, 0.19318], [2.6624, -0.10045, -0.92455, -0.26325]
    ), m([0.0037112, 0.0007361], [-0.087051, 9.3411e-6], [-1.19844, -4.1378e-4], [-3.1927, 9.2535e-4]), 0.01 * one(4), one(2)
    for e in (1.0, 1e3, 1e6):
        yield f"darex 2.1 {e:g}", True, m([0, e], [0, 0]), col(0, 1), one(2), one(1)
    for e in (1.0, 1e3, 1e6):
        a = v @ np.diag([0.0, 1, 3]) @ v
        yield f"darex 2.2 {e:g}", True, a, one(3), e * one(3), e * one(3)
    for e in (1e2, 1e4, 1e8):
        yield f"darex 2.3 {e:g}", True, m([1 - 1 / e, 0, 0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]), col(1 / e, 0, 0, 0), np.diag([0.0, 0, 0, 1]), m([0.25])
    for n in (5, 20):
        yield f"darex 3.1 n = {n}", True, one(n, k=1), one(n)[:, -1:], one(n), one(1)


def rows(matrix):
    return [[float(v) for v in row] for row in matrix]


def main():
    random = []
    for seed in range(200):
        for discrete in (False, True):
            a, b, q, r = system(seed, discrete)
            random.append({"seed": seed, "discrete": discrete, "n": len(a), "m": b.shape[1], "scipy": scipy_answer(a, b, q, r, discrete)})
    hard = []
    for name, discrete, a, b, q, r in benchmarks():
        answer = scipy_answer(a, b, q, r, discrete)
        truth = np.array(exact(a, b, q, r, discrete))
        error = None
        if answer is not None:
            w = direction(len(a))
            error = float(np.linalg.norm(np.array(answer["xw"]) - truth @ w) / (np.linalg.norm(truth) * np.linalg.norm(w)))
        hard.append(
            {
                "name": name,
                "discrete": discrete,
                "a": rows(a),
                "b": rows(b),
                "q": rows(q),
                "r": rows(r),
                "x": rows(truth),
                "scipy": None if answer is None else {"residual": answer["residual"], "error": error},
            }
        )
        print(name, answer and answer["residual"], error, flush=True)
    out = pathlib.Path(__file__).with_name("riccati.json")
    lines = [
        '{"scipy": "1.17.1",',
        '"random": [\n' + ",\n".join(json.dumps(x) for x in random) + "\n],",
        '"benchmarks": [\n' + ",\n".join(json.dumps(x) for x in hard) + "\n]}",
    ]
    out.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
