"""The battery's pendulum with every candidate effect in it, and its records.

Equations and shapes are those of battery/rigs/pendulum.rig and of the catalogue of `rig diagnose`; nothing is shared with the
simulator that made the records. Integrated by Runge-Kutta of fourth order, a step a sample, and to the times at which the
held command changes. Knows no statistics.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numba import njit
from scipy.signal import savgol_filter

MASS, GRAVITY = 0.3, 9.81
NOMINAL = (0.25, 0.002, 0.006)
# what the fit starts from may not be left by more than this
BASE_BOUNDS = ((0.05, 0.8), (0.0, 0.03), (0.0, 0.08))

# index of each number: l, J, b, then one or two of each effect
NAMES = (
    "l J b coulomb1 coulomb2 coulomb3 stribeck1 stribeck2 asymmetric_slope asymmetric_offset quadratic spring spring_offset cubic "
    "constant ps1 pc1 ps2 pc2 ps3 pc3 ps4 pc4 stop1_low stop1_high stop2_low stop2_high bias curvature drift deadzone saturation "
    "transient delay lag y_bias y_scale y_delay y_drift dx tilt"
).split()
AT = {name: k for k, name in enumerate(NAMES)}
COUNT = len(NAMES)


@dataclass(frozen=True)
class Candidate:
    """An effect with a shape: its numbers, whether they cannot be negative, a typical size of each."""

    effect: str
    shape: str
    numbers: tuple
    positive: bool
    size: tuple


def _one(effect, names, size, positive=False, shape=""):
    names = names.split()
    size = size if isinstance(size, tuple) else (size,) * len(names)
    return Candidate(effect, shape, tuple(AT[n] for n in names), positive, size)


def candidates(scales):
    """The catalogue for this rig. Left out: what the base eats whole (viscous, actuator_gain, added_mass, gravity_offset along the rod)."""
    torque = 5e-3
    rate = scales.rate
    all_ = [_one("coulomb", f"coulomb{k}", torque, True, f"width {w:.3g}") for k, w in zip((1, 2, 3), scales.shape[:3])]
    all_ += [_one("stribeck", f"stribeck{k}", torque, True, f"speed {s:.3g}") for k, s in zip((1, 2), scales.shape[3:5])]
    all_ += [
        _one("asymmetric_friction", "asymmetric_slope asymmetric_offset", (torque / rate, torque)),
        _one("quadratic_drag", "quadratic", torque / rate**2, True),
        _one("spring", "spring spring_offset", (torque, torque)),
        _one("cubic_spring", "cubic", torque),
        _one("constant_torque", "constant", torque),
        _one("hard_stop", "stop1_low stop1_high", 0.1, True, "at 15 %"),
        _one("hard_stop", "stop2_low stop2_high", 0.1, True, "at 3 %"),
        _one("actuator_bias", "bias", torque),
        _one("gain_curvature", "curvature", 0.05),
        _one("actuator_drift", "drift", 3e-3),
        _one("actuator_deadzone", "deadzone", torque, True),
        _one("actuator_saturation", "saturation", 0.1, True),
        _one("start_transient", "transient", 0.1),
        _one("input_delay", "delay", 2e-3, True),
        _one("actuator_lag", "lag", 2e-3, True),
        _one("sensor_bias", "y_bias", 5e-3),
        _one("sensor_scale", "y_scale", 3e-3),
        _one("sensor_delay", "y_delay", 2e-3, True),
        _one("sensor_drift", "y_drift", 1e-3),
        _one("gravity_offset", "dx", 2e-3),
        _one("base_tilt", "tilt", 1e-2),
    ]
    if scales.range[1] - scales.range[0] > np.pi:
        all_ += [_one("periodic_torque", f"ps{n} pc{n}", torque, False, f"{n} per turn") for n in (1, 2, 3, 4)]
    return all_


@dataclass
class Record:
    t: np.ndarray
    y: np.ndarray
    u: np.ndarray
    # on an even grid: time, angle, rate and the command's mean about each instant
    even: np.ndarray
    q: np.ndarray
    v: np.ndarray
    mean_u: np.ndarray

    @staticmethod
    def read(path: Path):
        t, y, u = np.loadtxt(path, delimiter=",", skiprows=1).T.copy()
        t = t - t[0]
        even = np.linspace(t[0], t[-1], len(t))
        step = even[1]
        q = np.interp(even, t, y)
        v = savgol_filter(q, 11, 3, deriv=1, delta=step)
        impulse = np.concatenate(([0.0], np.cumsum(u[:-1] * np.diff(t))))
        edges = np.clip(np.concatenate((even - step / 2, even[-1:] + step / 2)), t[0], t[-1])
        mean_u = np.diff(np.interp(edges, t, impulse)) / np.diff(edges)
        return Record(t, y, u, even, savgol_filter(q, 7, 3), v, mean_u)


@dataclass
class Scales:
    """How far and fast the training records moved, and the fixed numbers of the catalogue's shapes that follow."""

    rate: float
    range: tuple
    shape: np.ndarray

    @staticmethod
    def of(train):
        rate = float(np.sqrt(np.mean(np.concatenate([r.v for r in train]) ** 2)))
        low, high = min(r.y.min() for r in train), max(r.y.max() for r in train)
        span = high - low
        largest = max(np.abs(r.u).max() for r in train)
        duration = max(r.t[-1] for r in train)
        widths = [0.03 * rate, 0.15 * rate, 0.006 * rate, 0.1 * rate, 0.3 * rate]
        stops = [low + 0.15 * span, high - 0.15 * span, low + 0.03 * span, high - 0.03 * span]
        rest = [0.75 * largest, float(np.clip(0.05 * duration, 0.2, 5.0))]
        return Scales(rate, (low, high), np.array(widths + stops + rest))


@njit(cache=True)
def _acceleration(q, v, t, u, p, s):
    c = u * (1.0 + p[28] * u) * (1.0 - p[29] * t)
    if p[32] != 0.0:
        c += u * p[32] * np.exp(-t / s[10])
    c += p[27]
    if p[30] != 0.0:
        c -= min(max(u, -p[30]), p[30])
    if p[31] != 0.0:
        c -= p[31] * (u - min(max(u, -s[9]), s[9]))
    f = c - p[2] * v
    if p[3] != 0.0:
        f -= p[3] * np.tanh(v / s[0])
    if p[4] != 0.0:
        f -= p[4] * np.tanh(v / s[1])
    if p[5] != 0.0:
        f -= p[5] * np.tanh(v / s[2])
    if p[6] != 0.0:
        f -= p[6] * np.exp(-((v / s[3]) ** 2)) * np.tanh(v / (0.2 * s[3]))
    if p[7] != 0.0:
        f -= p[7] * np.exp(-((v / s[4]) ** 2)) * np.tanh(v / (0.2 * s[4]))
    f -= p[8] * abs(v) + p[9] + p[10] * v * abs(v)
    f += p[12] - p[11] * q - p[13] * q * q * q + p[14]
    for n in range(1, 5):
        if p[13 + 2 * n] != 0.0 or p[14 + 2 * n] != 0.0:
            f += p[13 + 2 * n] * np.sin(n * q) + p[14 + 2 * n] * np.cos(n * q)
    for k in range(2):
        f += p[23 + 2 * k] * max(s[5 + 2 * k] - q, 0.0) - p[24 + 2 * k] * max(q - s[6 + 2 * k], 0.0)
    f -= MASS * GRAVITY * (p[0] * np.sin(q - p[40]) + p[39] * np.cos(q - p[40]))
    return f / (p[1] + MASS * (p[0] * p[0] + p[39] * p[39]))


@njit(cache=True)
def simulate(t, u, p, s, starts, q0, v0, out):
    """Measured angle at each stamp; the state is set anew at each of `starts`."""
    n = len(t)
    delay, lag = p[33], p[34]
    j = 0  # command that acts
    z = u[0]
    window = -1
    q = v = q_was = v_was = t_was = 0.0
    for k in range(n):
        if window + 1 < len(starts) and starts[window + 1] == k:
            window += 1
            q, v = q0[window], v0[window]
            q_was, v_was, t_was = q, v, t[k]
        # what the sensor shows: by Hermite's cubic back in time, before a start by its tangent
        back = t[k] - p[37]
        seen = q
        if p[37] != 0.0:
            h = t[k] - t_was
            if h <= 0.0 or back < t_was:
                seen = q_was + (back - t_was) * v_was
            else:
                x = (back - t_was) / h
                a, b = (1 + 2 * x) * (1 - x) ** 2, x * (1 - x) ** 2
                seen = a * q_was + b * h * v_was + (1 - a) * q + x * x * (x - 1) * h * v
        out[k] = (1.0 + p[36]) * seen + p[35] + p[38] * t[k]
        if k + 1 == n:
            break
        q_was, v_was, t_was = q, v, t[k]
        at = t[k]
        while at < t[k + 1] - 1e-12:
            while j + 1 < n and t[j + 1] + delay <= at + 1e-12:
                j += 1
            until = t[k + 1]
            if j + 1 < n:
                until = min(until, t[j + 1] + delay)
            # a lag that is short beside a step needs shorter ones; below 0.1 ms its impulse is spread over the step
            most = 0.011 if lag < 1e-4 else min(0.011, 2.0 * lag)
            steps = int(np.ceil((until - at) / most))
            h = (until - at) / steps
            for _ in range(steps):
                c = u[j]
                u0, u1, u2 = c, c, c
                if lag > 0.0 and lag < 1e-4:
                    u0 = c + (z - c) * lag / h * (1.0 - np.exp(-h / lag))
                    u1, u2, z = u0, u0, c + (z - c) * np.exp(-h / lag)
                elif lag > 0.0:
                    half = np.exp(-0.5 * h / lag)
                    u0, u1, u2 = z, c + (z - c) * half, c + (z - c) * half * half
                    z = u2
                a1 = _acceleration(q, v, at, u0, p, s)
                v2 = v + 0.5 * h * a1
                a2 = _acceleration(q + 0.5 * h * v, v2, at + 0.5 * h, u1, p, s)
                v3 = v + 0.5 * h * a2
                a3 = _acceleration(q + 0.5 * h * v2, v3, at + 0.5 * h, u1, p, s)
                v4 = v + h * a3
                a4 = _acceleration(q + h * v3, v4, at + h, u2, p, s)
                q += h / 6.0 * (v + 2 * v2 + 2 * v3 + v4)
                v += h / 6.0 * (a1 + 2 * a2 + 2 * a3 + a4)
                at += h
            at = until
    return out
