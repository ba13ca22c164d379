"""Derivative regression by PySINDy: what the base leaves of the acceleration, regressed on a library of candidate terms.

Two targets: the *discrepancy* between a base model that output error fitted and the derivative of the measured rate, and the same with
the base's own three terms (command, sin(angle), rate) free beside the library, by projecting them out (what PySINDy's `sparse_ind`
means to do). Two forms: filtered derivatives, weak. Two optimizers: STLSQ, and an ensemble of them by bagging. Two libraries: all terms,
and one without terms that lie within |cos| 0.9 of an earlier one. Columns are scaled to a root mean square of one, so a threshold is an
acceleration (`absolute`), or a share of what the base leaves (`relative`).
"""

import time
import warnings

import numpy as np
import pysindy as ps
from pendulum import GRAVITY, MASS
from pysindy.utils import AxesArray
from scipy.signal import savgol_filter

WINDOWS = (15, 31)  # samples of the filter
HALVES = (0.15, 0.3)  # half widths of the weak form's test functions [s]
DOMAINS = 250  # test functions a record
ABSOLUTE = np.geomspace(0.01, 2.0, 11)
RELATIVE = np.geomspace(0.1, 0.85, 9)
# an ensemble is dear: fewer thresholds
ENSEMBLE, ENSEMBLE_ABSOLUTE, ENSEMBLE_RELATIVE = 12, np.geomspace(0.03, 0.8, 4), np.geomspace(0.15, 0.7, 5)


def terms(scales):
    """(effect, shape's first number in the simulator, positive, function of angle, rate, command, time, command's slope)."""
    s = scales.shape
    out = []

    def add(effect, name, positive, f):
        out.append((effect, name, positive, f))

    add("constant_torque", "constant", False, lambda q, v, u, t, d: np.ones_like(q))
    add("gravity_offset", "dx", False, lambda q, v, u, t, d: -np.cos(q))
    add("input_delay", "delay", True, lambda q, v, u, t, d: -d)
    add("coulomb", "coulomb1", True, lambda q, v, u, t, d: -np.tanh(v / s[0]))
    add("coulomb", "coulomb2", True, lambda q, v, u, t, d: -np.tanh(v / s[1]))
    add("coulomb", "coulomb3", True, lambda q, v, u, t, d: -np.tanh(v / s[2]))
    add("stribeck", "stribeck1", True, lambda q, v, u, t, d: -np.exp(-((v / s[3]) ** 2)) * np.tanh(v / (0.2 * s[3])))
    add("stribeck", "stribeck2", True, lambda q, v, u, t, d: -np.exp(-((v / s[4]) ** 2)) * np.tanh(v / (0.2 * s[4])))
    add("asymmetric_friction", "asymmetric_slope", False, lambda q, v, u, t, d: -np.abs(v))
    add("quadratic_drag", "quadratic", True, lambda q, v, u, t, d: -v * np.abs(v))
    add("spring", "spring", False, lambda q, v, u, t, d: -q)
    add("cubic_spring", "cubic", False, lambda q, v, u, t, d: -(q**3))
    add("sensor_scale", "y_scale", False, lambda q, v, u, t, d: q * np.cos(q))
    add("sensor_drift", "y_drift", False, lambda q, v, u, t, d: t * np.cos(q))
    add("gain_curvature", "curvature", False, lambda q, v, u, t, d: u**2)
    add("actuator_drift", "drift", False, lambda q, v, u, t, d: -t * u)
    add("actuator_deadzone", "deadzone", True, lambda q, v, u, t, d: -np.sign(u))
    add("actuator_saturation", "saturation", True, lambda q, v, u, t, d: -(u - np.clip(u, -s[9], s[9])))
    add("start_transient", "transient", False, lambda q, v, u, t, d: u * np.exp(-t / s[10]))
    for n, (low, high) in enumerate(((s[5], s[6]), (s[7], s[8])), 1):
        add("hard_stop", f"stop{n}_low", True, lambda q, v, u, t, d, at=low: np.maximum(at - q, 0.0))
        add("hard_stop", f"stop{n}_high", True, lambda q, v, u, t, d, at=high: -np.maximum(q - at, 0.0))
    if scales.range[1] - scales.range[0] > np.pi:
        for n in (2, 3, 4):
            add("periodic_torque", f"ps{n}", False, lambda q, v, u, t, d, n=n: np.sin(n * q))
            add("periodic_torque", f"pc{n}", False, lambda q, v, u, t, d, n=n: np.cos(n * q))
    return out


def library(functions):
    """PySINDy's library; it counts a function's arguments, so defaults are bound first."""

    def bound(f):
        return lambda q, v, u, t, d: f(q, v, u, t, d)

    return ps.CustomLibrary(library_functions=[bound(f) for f in functions], interaction_only=True)


BASE = (lambda q, v, u, t, d: u, lambda q, v, u, t, d: -np.sin(q), lambda q, v, u, t, d: -v)


def matrices(train, functions, form, width, seed):
    """Target, base columns and candidate columns over all records."""
    count = len(BASE)
    target, columns = [], []
    weak = None
    for r in train:
        step = r.even[1]
        slope = np.gradient(r.mean_u, step)
        fields = np.column_stack((r.q, r.v, r.mean_u, r.even, slope))
        if form == "filtered":
            kind = ps.SmoothedFiniteDifference(smoother_kws={"window_length": width, "polyorder": 3})
            x_dot = kind(r.v[:, None], r.even)[:, 0]
            theta = np.asarray(library([*BASE, *functions]).fit_transform(AxesArray(fields, {"ax_time": 0, "ax_coord": 1})))
            theta = savgol_filter(theta, width, 3, axis=0)
            target.append(np.asarray(x_dot)[width:-width])
            columns.append(theta[width:-width])
        else:
            # records of one length have one grid but for microseconds; weights are dear
            if weak is None or len(weak.spatiotemporal_grid) != len(r.even):
                np.random.seed(seed)  # the library draws its domains from the global state
                weak = ps.WeakPDELibrary(
                    function_library=library([*BASE, *functions]), spatiotemporal_grid=r.even, H_xt=width, K=DOMAINS, p=4
                )
            theta = np.asarray(weak.fit_transform(AxesArray(fields, {"ax_time": 0, "ax_coord": 1})))
            x_dot = np.asarray(weak.convert_u_dot_integral(r.v[:, None]))[:, 0]
            # so that a constant has size one
            size = np.sqrt(np.mean([np.sum(w) ** 2 for w in weak.fullweights0]))
            target.append(x_dot / size)
            columns.append(theta / size)
    columns = np.vstack(columns)
    return np.concatenate(target), columns[:, :count], columns[:, count:]


def apart(columns):
    """Columns that are not within |cos| 0.9 of an earlier one that was kept."""
    unit = columns / np.linalg.norm(columns, axis=0)
    kept = []
    for k in range(columns.shape[1]):
        if all(abs(unit[:, k] @ unit[:, j]) < 0.9 for j in kept):
            kept.append(k)
    return kept


def names(train, scales, p, seed=1):
    """What each setting names, the largest first: {setting: ([(effect, number)], seconds)}."""
    found = {}
    every = terms(scales)
    inertia = p[1] + MASS * p[0] ** 2
    fitted = np.array([1.0, MASS * GRAVITY * p[0], p[2]]) / inertia
    for form, widths in (("filtered", WINDOWS), ("weak", HALVES)):
        for width in widths:
            began = time.process_time()
            target, base, columns = matrices(train, [f for *_, f in every], form, width, seed)
            built = time.process_time() - began
            q, _ = np.linalg.qr(base)
            for what in ("discrepancy", "base free"):
                if what == "discrepancy":
                    y, x = target - base @ fitted, columns
                else:
                    y, x = target - q @ (q.T @ target), columns - q @ (q.T @ columns)
                # what the base eats is no candidate
                own = np.linalg.norm(columns - q @ (q.T @ columns), axis=0) > np.sqrt(0.05) * np.linalg.norm(columns, axis=0)
                able = np.flatnonzero(own)
                for shelf in ("all terms", "terms apart"):
                    chosen = able if shelf == "all terms" else able[apart(x[:, able])]
                    sizes = np.sqrt(np.mean(x[:, chosen] ** 2, axis=0))
                    scaled = x[:, chosen] / sizes
                    left = float(np.sqrt(np.mean(y**2)))
                    for optimizer in ("STLSQ", "ensemble"):
                        if optimizer == "ensemble" and shelf == "all terms":
                            continue
                        absolute, relative = (ABSOLUTE, RELATIVE) if optimizer == "STLSQ" else (ENSEMBLE_ABSOLUTE, ENSEMBLE_RELATIVE)
                        grid = [("absolute", a, a) for a in absolute] + [("relative", a, a * left) for a in relative]
                        for kind, number, threshold in grid:
                            began = time.process_time()
                            coefficients = regress(scaled, y, threshold, optimizer, seed)
                            seconds = built + time.process_time() - began
                            order = np.argsort(-np.abs(coefficients))
                            named = []
                            for k in order:
                                effect, number_name, positive, _ = every[chosen[k]]
                                # what pushes instead of braking is nothing that could be there
                                if coefficients[k] == 0.0 or (positive and coefficients[k] < 0.0):
                                    continue
                                named.append((effect, number_name))
                            found[f"{form}, {optimizer} | {width}, {what}, {shelf}, {kind} {number:.3g}"] = (named, seconds)
    return found


def regress(x, y, threshold, optimizer, seed):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        one = ps.STLSQ(threshold=threshold, alpha=1e-3 * len(y), max_iter=20, unbias=optimizer == "STLSQ")
        if optimizer == "ensemble":
            np.random.seed(seed)
            one = ps.EnsembleOptimizer(one, bagging=True, n_models=ENSEMBLE, n_subset=int(0.6 * len(y)), replace=False)
        one.fit(x, y)
    return np.asarray(one.coef_).ravel()
