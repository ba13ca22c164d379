"""Others beside `rig diagnose`, on the battery's pendulum: output error with BIC, and derivative regression by PySINDy.

    python peers.py run RECORDS OUT.jsonl RESULTS.jsonl ..     each run of the battery's results by all peers, at all settings
    python peers.py table RECORDS OUT.jsonl ..                 counts, each peer at its best setting

RECORDS is the folder that the battery wrote with --records, RESULTS what it wrote with --out. A run is done once: `run` goes on.
"""

import json
import os
import sys
import time
import warnings
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from output_error import Problem, held_out
from pendulum import AT, Record, Scales, candidates

WINDOWS = {"0.25 s": 0.25, "0.5 s": 0.5, "1 s": 1.0, "free run": 1e3}
TEST_WINDOW = 2.0
# the window in which names of others are refitted, and signatures compared
COMMON = 1.0
STEPS, REFITS = 2, 6

# signatures that this rig cannot tell apart, or hardly
CLASSES = (
    {"input_delay", "actuator_lag", "sensor_delay"},
    {"constant_torque", "actuator_bias", "sensor_bias", "gravity_offset", "base_tilt", "periodic_torque 1"},
    {"spring", "cubic_spring", "sensor_scale"},
)
ALIKE = 0.9


def records(folder, o):
    stem = f"{o['row']}_{o['part']}_{o['rig']}_{o['number']}"
    train = [Record.read(Path(folder) / f"{stem}_{k}.csv") for k in ("steps", "sines")]
    return train, [Record.read(Path(folder) / f"{stem}_chirp.csv")]


def likeness(problem, fit, every, hidden):
    """|cos| of each candidate's signatures with that of the hidden effect as it was sized, the base projected out."""
    base = problem.run(fit.p, fit.states)
    q, _ = np.linalg.qr(fit.jacobian)

    def space(c, sizes=None):
        x = problem.columns(fit.p, fit.states, base, c.numbers, c.size)
        if sizes is not None:
            x = (x / np.array(c.size)) @ np.array(sizes[: len(c.numbers)])[:, None]
        x = x - q @ (q.T @ x)
        u, s, _ = np.linalg.svd(x, full_matrices=False)
        return u[:, s > 1e-6 * s[0]]

    spaces = [(c, space(c)) for c in every]
    own = [space(c, hidden["sizes"]) for c in every if c.effect == hidden["effect"] and c.shape != "at 3 %" and c.shape[:1] not in ("2", "3", "4")]
    out = {}
    for c, u in spaces:
        alike = max((float(np.linalg.svd(u.T @ v)[1][0]) for v in own), default=0.0)
        out[titled(c)] = max(out.get(titled(c), 0.0), round(alike, 4))
    return out


def titled(c):
    return f"periodic_torque {c.shape[0]}" if c.effect == "periodic_torque" else c.effect


def one_run(folder, o):
    import regression

    train, test = records(folder, o)
    scales = Scales.of(train)
    every = candidates(scales)
    trial = Problem(test, scales, TEST_WINDOW)
    kept = "row part rig number hidden verdict screening_p said strongest truth_class test_ratio seconds".split()
    out = {k: o[k] for k in kept}
    out["output_error"] = {}
    for title, seconds in WINDOWS.items():
        began = time.process_time()
        problem = Problem(train, scales, seconds)
        fit = problem.base()
        fitted = time.process_time() - began
        # where nothing is hidden the first name is false, whatever follows
        path = problem.greedy(fit, every, STEPS if o["hidden"] else 1, REFITS)
        took = time.process_time() - began
        before = held_out(trial, fit)
        steps = [
            {"name": titled(c), "bic": round(bic, 2), "gain": round(1 - held_out(trial, new) / before, 5)} for c, bic, new in path
        ]
        out["output_error"][title] = {"path": steps, "seconds": took, "base": [float(x) for x in fit.p[:3]]}
        if seconds == COMMON:
            common, base_seconds = (problem, fit), fitted
    if o["hidden"]:
        out["alike"] = likeness(*common, every, o["hidden"][0])
    found = regression.names(train, scales, common[1].p)
    out["regression"] = {k: (names, round(s + base_seconds, 3)) for k, (names, s) in found.items()}
    return out


def run(folder, out, results):
    done = set()
    if Path(out).exists():
        done = {(o["row"], o["part"], o["number"]) for o in map(json.loads, open(out))}
    for path in results:
        for o in map(json.loads, open(path)):
            if o["rig"] != "pendulum" or o["failed"] or (o["row"], o["part"], o["number"]) in done:
                continue
            began = time.process_time()
            found = one_run(folder, o)
            with open(out, "a") as f:
                f.write(json.dumps(found) + "\n")
            print(o["row"], o["part"], o["number"], f"{time.process_time() - began:.0f} s", file=sys.stderr)


if __name__ == "__main__":
    warnings.filterwarnings("ignore")
    if len(sys.argv) < 4 or sys.argv[1] not in ("run", "table"):
        sys.exit(__doc__)
    if sys.argv[1] == "run":
        run(sys.argv[2], sys.argv[3], sys.argv[4:])
    else:
        import counts

        counts.table(sys.argv[2], sys.argv[3:])
