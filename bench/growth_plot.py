"""docs/growth.svg: our figures from the table in docs/speed.md beside the lines of growth_peers.py.

usage: growth_plot.py LINES.jsonl (from the project's folder; needs matplotlib)
"""

import json
import re
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "rig"})
import matplotlib.pyplot as plt

SHAPES = {"planar": "planar chain", "chain": "chain z, y, x", "tree": "tree z, y, x"}
ROW = re.compile(r"\s+(\d+)\s+(planar chain|chain z, y, x|tree z, y, x)\s+([\d.]+)\s+\d+\s+\d+\s+[\d.]+\s+[\d.]+")

with open(sys.argv[1], encoding="utf-8") as lines:
    peers = [json.loads(line) for line in lines]
ours = {name: [] for name in SHAPES.values()}
with open("docs/speed.md", encoding="utf-8") as lines:
    for match in filter(None, map(ROW.match, lines)):
        ours[match[2]].append((int(match[1]), float(match[3]) / 1e3))
figure, axes = plt.subplots(1, 3, figsize=(9, 3.2), sharey=True)
for axis, (shape, title) in zip(axes, SHAPES.items()):
    axis.loglog(*zip(*ours[title]), "o-", label="ours", color="#3b6ea5", ms=4)
    for tool, color, name in (("casadi", "#d2691e", "CasADi"), ("sympy", "#3a9a4a", "SymPy")):
        series = [(r["joints"], r["seconds"]) for r in peers if (r["tool"], r["shape"]) == (tool, shape) and "f" in r]
        axis.loglog(*zip(*series), "s-", label=name, color=color, ms=4)
    axis.set_title(title, fontsize=9)
    axis.set_xlabel("joints")
    axis.set_xticks([2, 4, 10, 30], ["2", "4", "10", "30"])
    axis.minorticks_off()
    axis.grid(alpha=0.3)
axes[0].set_ylabel("derive [s]")
axes[0].legend(fontsize=8)
plt.tight_layout()
plt.savefig("docs/growth.svg", metadata={"Date": None})
