"""Counts of what each peer named: settings chosen, rows of the table, Wilson's intervals.

A name is right if it is the hidden effect, or of its class by the table in peers.py, or if its signature lies within |cos| 0.9 of the
hidden one's; for `rig diagnose` also if the hidden effect is among those that it calls equivalent, for its screening if of one class.
"""

import json
from collections import Counter

import numpy as np
from output_error import Problem, held_out
from peers import ALIKE, CLASSES, COMMON, TEST_WINDOW, records
from pendulum import AT, Scales, candidates

FALSE = 0.05  # share of runs with nothing hidden in which a calibrated setting may name something
THRESHOLDS = (0.0, -10.0, -30.0, -100.0, -300.0, -1000.0, -3000.0)
SCREENING = "rig diagnose, first screening alone"
GATES = {"": (None,), " and held-out": (0.0, 0.1, 0.3)}


def share(hits, of):
    """A share with its 95 % interval (E. B. Wilson, JASA 22, 1927)."""
    if of == 0:
        return "-"
    p, z = hits / of, 1.959964
    middle = (p + z * z / (2 * of)) / (1 + z * z / of)
    half = z / (1 + z * z / of) * np.sqrt(p * (1 - p) / of + z * z / (4 * of * of))
    return f"{100 * p:.0f} % [{100 * max(middle - half, 0):.0f}, {100 * min(middle + half, 1):.0f}] ({hits}/{of})"


def plain(name):
    return name.split(" ")[0]


def own_class(name, o):
    """By effect and table."""
    hidden = o["hidden"][0]["effect"]
    key = "periodic_torque 1" if hidden == "periodic_torque" else hidden
    return plain(name) == hidden or any(name in c and key in c for c in CLASSES)


def right(name, o):
    alike = max((v for k, v in o["alike"].items() if name in (k, plain(k))), default=0.0)
    return alike >= ALIKE or own_class(name, o)


class Peer:
    """A method at a setting: what it named in each run, its held-out gain where known, seconds."""

    def __init__(self, family, setting, runs, named, seconds, gains=None):
        self.family, self.setting, self.runs, self.named, self.seconds, self.gains = family, setting, runs, named, seconds, gains

    def over(self, chosen=lambda o: True):
        nothing = [n for o, n in zip(self.runs, self.named) if not o["hidden"] and chosen(o)]
        one = [(o, n) for o, n in zip(self.runs, self.named) if o["hidden"] and chosen(o)]
        return {
            "nothing": len(nothing),
            "false": sum(bool(n) for n in nothing),
            "one": len(one),
            "said": sum(bool(n) for _, n in one),
            "right": sum(bool(n) and self.first_right(n, o) for o, n in one),
            "table": sum(bool(n) and own_class(n[0], o) for o, n in one),
            "only": sum(len({plain(x) for x in n}) == 1 and self.first_right(n, o) for o, n in one),
        }

    def first_right(self, names, o):
        if self.family == "rig diagnose" and any(e == o["hidden"][0]["effect"] for e, _ in o["said"][0]["equivalent"]):
            return True
        if self.family == SCREENING and o["strongest"][2] == o["truth_class"][0]:
            return True
        return right(names[0], o)


def output_error(runs):
    """All settings of output error: window, change of BIC that is enough, gate on the test record."""
    peers = []
    for window in runs[0]["output_error"]:
        for gate_name, gates in GATES.items():
            for gate in gates:
                for enough in THRESHOLDS:
                    named, gains = [], []
                    for o in runs:
                        names, gain = [], 0.0
                        for step in o["output_error"][window]["path"]:
                            better = 1 - (1 - step["gain"]) / max(1 - gain, 1e-12)
                            if step["bic"] >= enough or (gate is not None and better <= gate):
                                break
                            names.append(step["name"])
                            gain = step["gain"]
                        named.append(names)
                        gains.append(gain)
                    seconds = [o["output_error"][window]["seconds"] for o in runs]
                    setting = f"{window}, BIC < {enough:g}" + ("" if gate is None else f", gain > {100 * gate:g} %")
                    peers.append(Peer("OE + BIC" + gate_name, setting, runs, named, seconds, gains))
    return peers


def derivative_regression(runs):
    peers = []
    for key in runs[0]["regression"]:
        family, setting = key.split(" | ")
        found = [o["regression"][key] for o in runs]
        named = [[f"periodic_torque {k[-1]}" if e == "periodic_torque" else e for e, k in names] for names, _ in found]
        peer = Peer("PySINDy " + family, setting, runs, named, [s for _, s in found])
        peer.numbers = [names for names, _ in found]
        peers.append(peer)
    return peers


def rig(runs):
    named = [[s["effect"] for s in o["said"]] for o in runs]
    return Peer("rig diagnose", "as it is", runs, named, [o["seconds"] for o in runs])


def screening(runs):
    """What the first screening of `rig diagnose` puts first, where it is significant; the rest of the workflow may yet refuse it."""
    named = [[o["strongest"][0]] if o["strongest"] and o["screening_p"] < 0.05 else [] for o in runs]
    return Peer(SCREENING, "p < 0.05", runs, named, [o["seconds"] for o in runs])


class Refits:
    """Held-out gains of names, refitted by output error in windows of one second: one yardstick for peers that do not fit themselves."""

    def __init__(self, folder):
        self.folder, self.memory, self.problems = folder, {}, {}

    def problem(self, o):
        key = (o["row"], o["part"], o["number"])
        if key not in self.problems:
            train, test = records(self.folder, o)
            scales = Scales.of(train)
            problem, trial = Problem(train, scales, COMMON), Problem(test, scales, TEST_WINDOW)
            fit = problem.base()
            self.problems[key] = (candidates(scales), problem, trial, fit, held_out(trial, fit))
        return key, *self.problems[key]

    def gain(self, o, names, numbers):
        if not names:
            return 0.0
        key, every, problem, trial, fit, before = self.problem(o)
        wanted = []
        for name, number in zip(names, numbers or [None] * len(names)):
            # without a shape: each, the one that fits the training records
            able = [c for c in every if (AT[number[1]] in c.numbers if number else c.effect == plain(name))]
            if able and able not in wanted:
                wanted.append(able)
        memory = (key, tuple(tuple(c.shape + c.effect for c in w) for w in wanted))
        if memory not in self.memory:
            for able in wanted[:5]:
                fit = min((problem.with_effects(fit, fit.added + [c]) for c in able), key=lambda f: f.error)
            self.memory[memory] = 1 - held_out(trial, fit) / before
        return self.memory[memory]


def row(peer, refits, label):
    k = peer.over()
    if peer.gains is None:
        numbers = getattr(peer, "numbers", [None] * len(peer.runs))
        peer.gains = [refits.gain(o, n, m) if o["hidden"] else 0.0 for o, n, m in zip(peer.runs, peer.named, numbers)]
    gains = np.array([g for o, g in zip(peer.runs, peer.gains) if o["hidden"]])
    said = np.array([bool(n) for o, n in zip(peer.runs, peer.named) if o["hidden"]])
    worse = int(np.sum(gains[said] < 0))
    print(
        f"| {peer.family}{label} | {peer.setting} | {share(k['false'], k['nothing'])} | {share(k['right'], k['one'])} "
        f"| {share(k['table'], k['one'])} | {share(k['only'], k['one'])} | {k['said'] - k['right']}/{k['said']} "
        f"| {np.median(gains[said]) if said.any() else 0:.2f} | {np.median(gains):.2f} | {worse}/{int(said.sum())} | {np.median(peer.seconds):.1f} |"
    )


def best(peers, chosen=lambda o: True, allowed=1.0):
    """The setting that names most, among those that name nothing falsely more often than allowed."""
    counted = [(peer, peer.over(chosen)) for peer in peers]
    able = [(p, k) for p, k in counted if k["false"] <= allowed * k["nothing"]]
    if not able:
        return None
    return max(able, key=lambda pk: (pk[1]["right"], pk[1]["only"], -pk[1]["false"]))[0]


def table(folder, paths):
    runs = [json.loads(line) for path in paths for line in open(path)]
    runs.sort(key=lambda o: (o["row"], o["part"], o["number"]))
    refits = Refits(folder)
    peers = output_error(runs) + derivative_regression(runs)
    families = list(dict.fromkeys(p.family for p in peers))
    print(
        "| way | setting | named with nothing hidden | first name right | by table | right, and nothing else | wrong first "
        "| median gain where named | over all | test worse | median s |\n|---|---|---|---|---|---|---|---|---|---|---|"
    )
    row(rig(runs), refits, "")
    row(screening(runs), refits, "")
    for p in peers:
        if p.family == "OE + BIC" and p.setting in ("free run, BIC < 0", "free run, BIC < -10"):
            row(p, refits, ", textbook")
    for family in families:
        own = [p for p in peers if p.family == family]
        row(best(own), refits, ", names most")
        calibrated = best(own, allowed=FALSE)
        if calibrated:
            row(calibrated, refits, ", calibrated")

    print("\n| way | chosen on one half of the runs, counted on the other: named with nothing hidden | first name right |\n|---|---|---|")
    for family in families:
        own = [p for p in peers if p.family == family]
        counts = Counter()
        for half in (0, 1):
            p = best(own, lambda o: o["number"] % 2 == half, FALSE)
            if p:
                counts.update(p.over(lambda o: o["number"] % 2 != half))
        print(f"| {family} | {share(counts['false'], counts['nothing'])} | {share(counts['right'], counts['one'])} |")

    allowed = (0, 1, 2, 4, 8, 16, 32)
    of = sum(not o["hidden"] for o in runs)
    print(f"\n| runs with the right name first at most, by how many of {of} runs with nothing hidden may be named | " + " | ".join(map(str, allowed)) + " |")
    print("|---" * (1 + len(allowed)) + "|")
    for family in families:
        own = [p for p in peers if p.family == family]
        cells = []
        for a in allowed:
            p = best(own, allowed=a / max(of, 1))
            cells.append(str(p.over()["right"]) if p else "-")
        print(f"| {family} | " + " | ".join(cells) + " |")

    print("\n| run | hidden | rig diagnose | " + " | ".join(families) + " |\n" + "|---" * (3 + len(families)) + "|")
    shown = [best([p for p in peers if p.family == f], allowed=FALSE) or best([p for p in peers if p.family == f]) for f in families]
    for k, o in enumerate(runs):
        cells = [rig(runs).named[k]] + [p.named[k] for p in shown]
        if not o["hidden"] and not any(cells):
            continue
        marks = []
        for p, names in zip([rig(runs), *shown], cells):
            mark = "" if not names or not o["hidden"] else ("+" if p.first_right(names, o) else "!")
            marks.append((", ".join(names) + mark) or o["verdict"] * (p.family == "rig diagnose"))
        hidden = o["hidden"][0]["effect"] if o["hidden"] else "nothing"
        print(f"| {o['part']} {o['number']} | {hidden} | " + " | ".join(marks) + " |")
