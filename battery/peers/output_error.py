"""Output error: fits of the pendulum to records by least squares, and effects added one by one by BIC.

Records go over the top, where a free run forgets how it began. So each record is cut into windows, the state at each window's start free:
as long as the user likes; one window is the free run. Knows the truth of no run.
"""

from dataclasses import dataclass, field

import numpy as np
from pendulum import AT, BASE_BOUNDS, COUNT, NOMINAL, simulate
from scipy.optimize import least_squares

BASE_SIZE = (0.01, 5e-4, 1e-3)
# a candidate of which less is its own is eaten by the base
OWN = 0.05


@dataclass
class Fit:
    p: np.ndarray
    states: list  # of each record: angles and rates at its windows' starts
    residual: np.ndarray
    jacobian: np.ndarray
    added: list = field(default_factory=list)

    @property
    def error(self):
        return float(self.residual @ self.residual)


class Problem:
    """Records cut into windows of `seconds`."""

    def __init__(self, records, scales, seconds):
        self.records, self.scales = records, scales
        self.starts = []
        for r in records:
            count = max(1, round(r.t[-1] / seconds))
            self.starts.append(np.array([len(r.t) * k // count for k in range(count)]))
        self.count = sum(len(r.t) for r in records)

    def first_states(self):
        return [(np.interp(r.t[s], r.even, r.q), np.interp(r.t[s], r.even, r.v)) for r, s in zip(self.records, self.starts)]

    def run(self, p, states):
        out = [simulate(r.t, r.u, p, self.scales.shape, s, q, v, np.empty(len(r.t))) for r, s, (q, v) in zip(self.records, self.starts, states)]
        return np.concatenate(out)

    def measured(self):
        return np.concatenate([r.y for r in self.records])

    def columns(self, p, states, base, numbers, sizes):
        """Derivatives by numbers, in their sizes."""
        out = np.empty((self.count, len(numbers)))
        for k, (i, size) in enumerate(zip(numbers, sizes)):
            moved = p.copy()
            moved[i] += 1e-3 * size
            out[:, k] = (self.run(moved, states) - base) / 1e-3
        return out

    def state_columns(self, p, states, base):
        windows = sum(len(s) for s in self.starts)
        out = np.zeros((self.count, 2 * windows))
        for which, size in ((0, 1e-3), (1, 1e-2)):
            moved = [tuple(x + (1e-2 * size if k == which else 0.0) for k, x in enumerate(s)) for s in states]
            change = (self.run(p, moved) - base) / 1e-2
            row = column = 0
            for r, s in zip(self.records, self.starts):
                edges = np.append(s, len(r.t))
                for a, b in zip(edges[:-1], edges[1:]):
                    out[row + a : row + b, 2 * column + which] = change[row + a : row + b]
                    column += 1
                row += len(r.t)
        return out

    def pack(self, p, states, numbers, sizes):
        inner = [np.column_stack((q / 1e-3, v / 1e-2)).ravel() for q, v in states]
        return np.concatenate([p[list(numbers)] / sizes] + inner)

    def unpack(self, x, p, numbers, sizes):
        p = p.copy()
        p[list(numbers)] = x[: len(numbers)] * sizes
        states, at = [], len(numbers)
        for s in self.starts:
            pair = x[at : at + 2 * len(s)].reshape(-1, 2)
            states.append((pair[:, 0] * 1e-3, pair[:, 1] * 1e-2))
            at += 2 * len(s)
        return p, states

    def fit(self, p, states, numbers, sizes, bounds, added=(), most=25):
        """Least squares over `numbers` (none: the states alone) and the states."""
        sizes = np.array(sizes, float)
        y = self.measured()
        memory = {}

        def residual(x):
            own = self.unpack(x, p, numbers, sizes)
            memory["x"], memory["run"] = x.copy(), self.run(*own)
            value = memory["run"] - y
            return np.where(np.isfinite(value), np.clip(value, -1e3, 1e3), 1e3)

        def jacobian(x):
            own = self.unpack(x, p, numbers, sizes)
            base = memory["run"] if np.array_equal(memory["x"], x) else self.run(*own)
            found = np.hstack((self.columns(*own, base, numbers, sizes), self.state_columns(*own, base)))
            # a run that flies off has no slope
            return np.clip(np.nan_to_num(found, nan=0.0, posinf=0.0, neginf=0.0), -1e6, 1e6)

        x0 = self.pack(p, states, numbers, sizes)
        low, high = np.full(len(x0), -np.inf), np.full(len(x0), np.inf)
        for k, (a, b) in enumerate(bounds):
            low[k], high[k] = a / sizes[k], b / sizes[k]
        margin = 1e-9 + 1e-6 * np.abs(x0)
        x0 = np.clip(x0, low + margin, high - margin)
        found = least_squares(residual, x0, jacobian, (low, high), x_scale="jac", ftol=1e-7, xtol=1e-9, gtol=1e-12, max_nfev=most)
        fitted, states = self.unpack(found.x, p, numbers, sizes)
        return Fit(fitted, states, found.fun, found.jac, list(added))

    def base(self):
        """The rig without an effect. Short windows first: they are followed from any start."""
        p = np.zeros(COUNT)
        p[:3] = NOMINAL
        for seconds in (0.4, 1.0):
            if seconds < self.records[0].t[-1] / len(self.starts[0]):
                short = Problem(self.records, self.scales, seconds)
                p = short.fit(p, short.first_states(), (0, 1, 2), BASE_SIZE, BASE_BOUNDS).p
        return self.fit(p, self.first_states(), (0, 1, 2), BASE_SIZE, BASE_BOUNDS, most=60)

    def with_effects(self, fit, chosen, guess=None, most=25):
        """Refits everything with these effects; `guess`: numbers of the last one."""
        numbers, sizes, bounds = [0, 1, 2], list(BASE_SIZE), list(BASE_BOUNDS)
        for c in chosen:
            for i, size in zip(c.numbers, c.size):
                if i not in numbers:
                    numbers.append(i)
                    sizes.append(size)
                    bounds.append((0.0 if c.positive else -np.inf, np.inf))
        p = fit.p.copy()
        if guess is not None:
            p[list(chosen[-1].numbers)] = guess
        # timing starts off zero, where it has a slope
        for name in ("delay", "lag", "y_delay"):
            if AT[name] in numbers:
                p[AT[name]] = max(p[AT[name]], 2e-4)
        return self.fit(p, fit.states, numbers, sizes, bounds, chosen, most)

    def screen(self, fit, among):
        """Candidates by what a linear step would gain: (gain, guess, candidate), best first; those that the base eats are left out."""
        base = self.run(fit.p, fit.states)
        q, _ = np.linalg.qr(fit.jacobian)
        windows = 2 * sum(len(s) for s in self.starts)
        z, _ = np.linalg.qr(fit.jacobian[:, -windows:])
        found = []
        for c in among:
            columns = self.columns(fit.p, fit.states, base, c.numbers, c.size)
            if not np.all(np.isfinite(columns)):
                continue
            own = columns - q @ (q.T @ columns)
            # short windows eat a part of everything; what counts is what the base eats of the rest
            seen = columns - z @ (z.T @ columns)
            keep = [k for k in range(len(c.numbers)) if own[:, k] @ own[:, k] > OWN * (seen[:, k] @ seen[:, k])]
            guess = np.zeros(len(c.numbers))
            while keep:
                step = np.linalg.lstsq(own[:, keep], -fit.residual, rcond=1e-6)[0]
                if c.positive and step.min() <= 0.0:
                    keep.pop(int(step.argmin()))
                    continue
                guess[keep] = step * np.array(c.size)[keep]
                left = fit.residual + own[:, keep] @ step
                gain = fit.error - float(left @ left)
                found.append((gain - len(c.numbers) * fit.error * np.log(self.count) / self.count, guess, c))
                break
        return sorted(found, key=lambda f: -f[0])

    def greedy(self, fit, among, steps, refits):
        """The path of effects added by BIC: (candidate, change of BIC, fit), as long as BIC falls."""
        path = []
        for _ in range(steps):
            taken = {(c.effect, c.shape if c.effect == "periodic_torque" else "") for c in fit.added}
            left = [c for c in among if (c.effect, c.shape if c.effect == "periodic_torque" else "") not in taken]
            best = None
            for _, guess, c in self.screen(fit, left)[:refits]:
                new = self.with_effects(fit, fit.added + [c], guess)
                bic = self.count * np.log(new.error / fit.error) + len(c.numbers) * np.log(self.count)
                if best is None or bic < best[0]:
                    best = (bic, c, new)
            if best is None or best[0] >= 0.0:
                break
            path.append((best[1], best[0], best[2]))
            fit = best[2]
        return path


def held_out(problem, fit):
    """Squared error of the test record, its states fitted."""
    return problem.fit(fit.p, problem.first_states(), (), (), ()).error
