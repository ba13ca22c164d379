"""Derives a declared rig by another road than Rigwright's own, and writes the numbers that its tests compare.

    python derive.py DECLARED.json RESULT.json

Reads the declared rig only (docs/declared-json.md): no equation, no derivative and no number of Rigwright's
derivation comes in here. Positions are products of full homogeneous transforms in the ground frame; velocities,
angular velocities, Lagrange's equation, virtual work and every Jacobian are CasADi's automatic differentiation.
"""

import json
import sys

import casadi as ca
import numpy as np
from scipy.linalg import solve_continuous_are

FORMAT = 1
STATES = 20


# ---------------------------------------------------------------- expressions


def saturate(x, lo, hi):
    return ca.if_else(x < lo, lo, ca.if_else(x > hi, hi, x))


def dead_zone(x, w):
    return ca.if_else(x > w, x - w, ca.if_else(x < -w, x + w, 0))


FUNCTIONS = {
    "sin": ca.sin, "cos": ca.cos, "tan": ca.tan, "asin": ca.asin, "acos": ca.acos, "atan": ca.atan, "atan2": ca.atan2,
    "sinh": ca.sinh, "cosh": ca.cosh, "tanh": ca.tanh, "exp": ca.exp, "ln": ca.log, "sqrt": ca.sqrt, "abs": ca.fabs,
    "sign": ca.sign, "saturate": saturate, "dead_zone": dead_zone,
    "min": lambda a, b: ca.if_else(a < b, a, b),
    "max": lambda a, b: ca.if_else(a > b, a, b),
    "neg": lambda a: -a,
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}


def power(a, b):
    """a^b; a whole number in the exponent is a product, so that a negative base is fine."""
    if isinstance(b, (int, float)) and float(b).is_integer():
        return ca.SX(1) if b == 0 else ca.SX(a) ** int(b)
    return ca.power(a, b)


def symbol_of(expr):
    """("param", "m_h") for a name, else None."""
    return next(iter(expr.items())) if isinstance(expr, dict) else None


class Names:
    """What the names of a rig stand for."""

    def __init__(self, rig):
        names = [c["name"] for c in rig["coordinates"]]
        moved = [c["name"] for c in rig["coordinates"] if c["prescribed"] and c["trajectory"] is None]
        self.t = ca.SX.sym("t")
        self.q = ca.SX.sym("q", len(names))
        self.v = ca.SX.sym("v", len(names))
        self.z = ca.SX.sym("z", sum(a["lag"] is not None for a in rig["actuators"]))
        self.u = ca.SX.sym("u", len(rig["inputs"]) + len(moved))
        self.p = ca.SX.sym("p", len(rig["parameters"]))
        self.coordinates = names
        fixed = {a["set"]: a["value"] for a in rig["assumptions"] if "set" in a}
        self.table = {}
        for k, p in enumerate(rig["parameters"]):
            self.table["param", p["name"]] = ca.SX(fixed[p["name"]]) if p["name"] in fixed else self.p[k]
        for k, name in enumerate(names):
            self.table["coord", name] = self.q[k]
            self.table["rate", name] = self.v[k]
        for k, i in enumerate(rig["inputs"]):
            self.table["input", i["name"]] = self.u[k]
        for d in rig["definitions"]:
            own = d["parameter"]
            self.table["definition", d["name"]] = self.table["param", own] if own else self.value(d["value"])
        for mix in rig["mixes"]:
            for name, row in zip(mix["names"], mix["rows"]):
                self.table["mix", name] = sum(k * self.table["input", i] for k, i in zip(row, mix["inputs"]))

        # prescribed motion: an acceleration from outside, or the second derivative of a trajectory
        self.moved = {}
        for k, c in enumerate(rig["coordinates"]):
            if c["trajectory"] is not None:
                s = self.value(c["trajectory"])
                self.moved[k] = ca.jacobian(ca.jacobian(s, self.t), self.t)
            elif c["prescribed"]:
                self.moved[k] = self.u[len(rig["inputs"]) + moved.index(c["name"])]
            if k in self.moved:
                self.table["accel", c["name"]] = self.moved[k]

        # actuators: map, dead zone, saturation, lag
        self.lag_rates = []
        for a in rig["actuators"]:
            out = self.value(a["map"])
            if a["dead_zone"] is not None:
                out = dead_zone(out, self.value(a["dead_zone"]))
            if a["saturation"] is not None:
                out = saturate(out, *(self.value(s) for s in a["saturation"]))
            if a["lag"] is not None:
                state = self.z[len(self.lag_rates)]
                self.lag_rates.append((out - state) / self.value(a["lag"]))
                out = state
            self.table["actuator", a["name"]] = out
        # what is written with a mixed input acts by what actuators deliver
        delivered = {i["name"]: self.table.get(("actuator", i["name"]), self.table["input", i["name"]]) for i in rig["inputs"]}
        for mix in rig["mixes"]:
            for name, row in zip(mix["names"], mix["rows"]):
                self.table["mix", name] = sum(k * delivered[i] for k, i in zip(row, mix["inputs"]))

    def value(self, expr):
        """A JSON tree as a CasADi expression."""
        if isinstance(expr, (int, float)):
            return ca.SX(expr)
        if expr == "t":
            return self.t
        if isinstance(expr, dict):
            return self.table[symbol_of(expr)]
        head, *args = expr
        if head == "^":
            exponent = args[1] if isinstance(args[1], (int, float)) else self.value(args[1])
            return power(self.value(args[0]), exponent)
        return FUNCTIONS[head](*(self.value(a) for a in args))

    def vector(self, exprs):
        return ca.vertcat(*(self.value(e) for e in exprs))

    def optional(self, expr, otherwise=0.0):
        return ca.SX(otherwise) if expr is None else self.value(expr)


# ---------------------------------------------------------------- geometry


def cross_matrix(a):
    return ca.vertcat(ca.horzcat(0, -a[2], a[1]), ca.horzcat(a[2], 0, -a[0]), ca.horzcat(-a[1], a[0], 0))


def rotation(axis, angle):
    """R(axis, angle) = cos I + sin [e]x + (1 - cos) e e^T for a unit vector e."""
    e = ca.SX(axis)
    return ca.cos(angle) * ca.SX.eye(3) + ca.sin(angle) * cross_matrix(e) + (1 - ca.cos(angle)) * ca.mtimes(e, e.T)


def transform(r, p):
    return ca.vertcat(ca.horzcat(r, p), ca.horzcat(ca.SX.zeros(1, 3), ca.SX(1)))


class World:
    """Frames as homogeneous transforms X_WF(q), and how points and axes of them move."""

    def __init__(self, rig, names):
        self.n = names
        self.frames = {"ground": ca.SX.eye(4)}
        for frame in rig["frames"]:
            x = self.frames[frame["parent"]]
            for step in frame["steps"]:
                if "rotate" in step:
                    x = ca.mtimes(x, transform(rotation(step["rotate"], names.value(step["angle"])), ca.SX.zeros(3)))
                else:
                    x = ca.mtimes(x, transform(ca.SX.eye(3), names.vector(step["translate"])))
            self.frames[frame["name"]] = x

    def axes(self, frame):
        return self.frames[frame][:3, :3]

    def point(self, frame, p):
        return ca.mtimes(self.frames[frame], ca.vertcat(p, 1))[:3]

    def angular_velocity(self, frame):
        """omega of R' R^T = [omega]x."""
        r = self.axes(frame)
        rate = ca.reshape(ca.jtimes(ca.vec(r), self.n.q, self.n.v), 3, 3)
        w = ca.mtimes(rate, r.T)
        return ca.vertcat(w[2, 1] - w[1, 2], w[0, 2] - w[2, 0], w[1, 0] - w[0, 1]) / 2

    def point_jacobian(self, frame, place):
        """d/dq of the point fixed to `frame` that is at `place` (ground axes) now."""
        fixed = ca.SX.sym("x", 3)
        j = ca.jacobian(self.point(frame, fixed), self.n.q)
        here = ca.mtimes(self.axes(frame).T, place - self.frames[frame][:3, 3])
        return ca.substitute(j, fixed, here)

    def turning_jacobian(self, frame):
        """d omega / d v."""
        return ca.jacobian(self.angular_velocity(frame), self.n.v)


# ---------------------------------------------------------------- Lagrange's equation and virtual work


def tensor(entries):
    xx, yy, zz, xy, xz, yz = ca.vertsplit(entries)
    return ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))


def lagrange(kinetic, n):
    """M and velocity products of a kinetic energy."""
    momentum = ca.gradient(kinetic, n.v)
    return ca.jacobian(momentum, n.v), ca.jtimes(momentum, n.q, n.v) - ca.gradient(kinetic, n.q)


class Terms:
    """Generalized quantities, one entry a statement, so that assumptions can drop statements and rows.

    Each entry is (name, vector); `name` is the statement's name or the body's.
    """

    def __init__(self, rig, n):
        self.rig, self.n = rig, n
        self.world = World(rig, n)
        self.count = len(n.coordinates)
        self.mass, self.coriolis, self.gravity = [], [], []
        self.springs, self.dissipation, self.force = [], [], []
        self.kinetic, self.potential = ca.SX(0), ca.SX(0)
        if rig["equations"]:
            self.written()
        else:
            self.bodies()
        self.stored()
        self.lost()
        self.applied()

    def zero(self):
        return ca.SX.zeros(self.count)

    def bodies(self):
        n, world = self.n, self.world
        fall = ca.SX.zeros(3) if self.rig["gravity"] is None else n.vector(self.rig["gravity"])
        for body in self.rig["bodies"]:
            m, c = n.value(body["mass"]), n.vector(body["center"])
            inertia = tensor(n.vector(body["inertia"]))
            if body["about"] == "frame_origin":
                inertia = inertia - m * (ca.dot(c, c) * ca.SX.eye(3) - ca.mtimes(c, c.T))
            r = world.axes(body["frame"])
            place = world.point(body["frame"], c)
            speed = ca.jtimes(place, n.q, n.v)
            omega = world.angular_velocity(body["frame"])
            spin = ca.mtimes([omega.T, r, inertia, r.T, omega])
            kinetic = (m * ca.dot(speed, speed) + spin) / 2
            potential = -m * ca.dot(fall, place)
            mass, products = lagrange(kinetic, n)
            self.mass.append((None, mass))
            self.coriolis.append((None, products))
            self.gravity.append((body["name"], ca.gradient(potential, n.q)))
            self.kinetic += kinetic
            self.potential += potential
        for f in self.rig["functions"]:
            if f["kind"] == "kinetic":
                kinetic = n.value(f["value"])
                mass, products = lagrange(kinetic, n)
                self.mass.append((f["name"], mass))
                self.coriolis.append((f["name"], products))
                self.kinetic += kinetic

    def written(self):
        """Equations written directly: additive terms with inputs are force, with rates dissipation, the rest bias."""
        n = self.n
        place = {name: k for k, name in enumerate(n.coordinates)}
        mass = ca.SX.zeros(self.count, self.count)
        bias, lost, force = self.zero(), self.zero(), self.zero()
        for k in n.moved:
            mass[k, k] = 1
        for e in self.rig["equations"]:
            row = place[e["coordinate"]]
            for entry in e["mass"]:
                mass[row, place[entry["coordinate"]]] += n.value(entry["coefficient"])
            for sign, term in self.additive(e["rhs"]):
                x = sign * n.value(term)
                if ca.depends_on(x, ca.vertcat(n.u, n.z)):
                    force[row] += x
                elif ca.depends_on(x, n.v):
                    lost[row] -= x
                else:
                    bias[row] -= x
        self.mass.append((None, mass))
        self.gravity.append((None, bias))
        self.dissipation.append((None, lost))
        self.force.append((None, force))

    def additive(self, expr, sign=1):
        """Terms of a sum, looking through names that stand for a sum."""
        if isinstance(expr, list) and expr[0] in ("+", "-"):
            yield from self.additive(expr[1], sign)
            yield from self.additive(expr[2], sign if expr[0] == "+" else -sign)
        elif isinstance(expr, list) and expr[0] == "neg":
            yield from self.additive(expr[1], -sign)
        else:
            behind = self.behind(expr)
            if behind is None:
                yield sign, expr
            else:
                yield from self.additive(behind, sign)

    def behind(self, expr):
        """The expression that a name stands for, where it stands for nothing else."""
        kind, name = symbol_of(expr) or (None, None)
        if kind == "definition":
            d = next(d for d in self.rig["definitions"] if d["name"] == name)
            return None if d["parameter"] else d["value"]
        if kind == "actuator":
            a = next(a for a in self.rig["actuators"] if a["name"] == name)
            return a["map"] if a["lag"] is None and a["dead_zone"] is None and a["saturation"] is None else None
        return None

    def length(self, along):
        n = self.n
        if "of" in along:
            return n.value(along["of"])
        ends = [self.world.point(along[k]["frame"], n.vector(along[k]["point"])) for k in ("from", "to")]
        return ca.norm_2(ends[1] - ends[0])

    def stored(self):
        n = self.n
        for s in self.rig["springs"]:
            x = self.length(s["along"]) - n.value(s["rest"])
            energy = n.value(s["stiffness"]) * x**2 / 2 + n.value(s["cubic"]) * x**4 / 4
            self.springs.append((s["name"], ca.gradient(energy, n.q)))
            self.potential += energy
        for f in self.rig["functions"]:
            if f["kind"] == "potential":
                energy = n.value(f["value"])
                self.springs.append((f["name"], ca.gradient(energy, n.q)))
                self.potential += energy

    def lost(self):
        n = self.n
        for f in self.rig["frictions"]:
            s = n.value(f["of"])
            speed = ca.jtimes(s, n.q, n.v)
            force = n.optional(f["viscous"]) * speed + n.optional(f["quadratic"]) * speed * ca.fabs(speed)
            level = n.optional(f["coulomb"])
            if f["stribeck"] is not None:
                excess, scale = (n.value(e) for e in f["stribeck"])
                level += excess * ca.exp(-((speed / scale) ** 2))
            if f["width"] is not None:
                force += level * ca.tanh(speed / n.value(f["width"]))
            if f["asymmetric"] is not None:
                slope, offset = (n.value(e) for e in f["asymmetric"])
                force += slope * ca.fabs(speed) + offset
            self.dissipation.append((f["name"], ca.jacobian(s, n.q).T * force))
        for d in self.rig["dampers"]:
            x = self.length(d["along"])
            force = n.value(d["viscous"]) * ca.jtimes(x, n.q, n.v)
            self.dissipation.append((d["name"], ca.gradient(x, n.q) * force))
        for f in self.rig["functions"]:
            if f["kind"] == "dissipation":
                self.dissipation.append((f["name"], ca.gradient(n.value(f["value"]), n.v)))

    def applied(self):
        n, world = self.n, self.world
        for f in self.rig["forces"]:
            if f["kind"] == "generalized":
                q = self.zero()
                q[n.coordinates.index(f["coordinate"])] = n.value(f["value"])
                self.force.append((f["name"], q))
                continue
            vector = ca.mtimes(world.axes(f["axes"]), n.vector(f["vector"]))
            sides = [(f["frame"], 1)] + ([(f["against"], -1)] if f["against"] is not None else [])
            q = self.zero()
            for frame, sign in sides:
                if f["kind"] == "force":
                    j = world.point_jacobian(frame, world.point(f["frame"], n.vector(f["point"])))
                else:
                    j = world.turning_jacobian(frame)
                q += sign * ca.mtimes(j.T, vector)
            self.force.append((f["name"], q))


class Equations:
    """M a + bias + dissipation = force after the rig's assumptions."""

    def __init__(self, rig, n):
        self.rig, self.n = rig, n
        terms = Terms(rig, n)
        self.kinetic, self.potential = terms.kinetic, terms.potential
        count = terms.count
        coriolis = self.kept(terms.coriolis, self.dropped("coriolis"))
        self.gravity = self.kept(terms.gravity, self.dropped("gravity"))
        self.springs = self.kept(terms.springs, lambda name, row: False)
        self.dissipation = self.kept(terms.dissipation, self.dropped("friction"))
        self.force = self.kept(terms.force, lambda name, row: False)
        self.bias = coriolis + self.gravity + self.springs
        self.mass = self.mass_matrix(terms, count)
        self.solve()

    def dropped(self, what):
        """Whether a general assumption drops (name, row) from the terms of a kind."""
        rows = []
        for a in self.rig["assumptions"]:
            if a.get("neglect") == what:
                bodies = a.get("bodies")
                rows.append((bodies, a["rows"]))

        def drops(name, row):
            return any((b is None or name in b) and (r is None or row in r) for b, r in rows)

        return drops

    def named(self, name, row):
        """Whether a named term is neglected in a row."""
        return name is not None and any(
            a.get("neglect") == "term" and a["name"] == name and (a["rows"] is None or row in a["rows"]) for a in self.rig["assumptions"]
        )

    def kept(self, entries, drops):
        total = ca.SX.zeros(len(self.n.coordinates))
        for name, vector in entries:
            for k, row in enumerate(self.n.coordinates):
                if not drops(name, row) and not self.named(name, row):
                    total[k] += vector[k]
        return total

    def mass_matrix(self, terms, count):
        names = self.n.coordinates
        m = ca.SX.zeros(count, count)
        for name, part in terms.mass:
            for i in range(count):
                for j in range(count):
                    if not self.named(name, names[i]) and not self.named(name, names[j]):
                        m[i, j] += part[i, j]
        for a in self.rig["assumptions"]:
            if a.get("neglect") == "inertia":
                i, j = (names.index(c) for c in a["entry"])
                m[i, j] = m[j, i] = 0
        for a in self.rig["assumptions"]:
            if "inertia_diagonal" in a:
                free = [k for k in range(count) if k not in self.n.moved]
                for i, entry in zip(free, a["inertia_diagonal"]):
                    for j in free:
                        m[i, j] = 0
                    m[i, i] = self.n.value(entry)
        return m

    def solve(self):
        n = self.n
        count = len(n.coordinates)
        moved = sorted(n.moved)
        free = [k for k in range(count) if k not in n.moved]
        a = ca.SX.zeros(count)
        for k in moved:
            a[k] = n.moved[k]
        if free:
            right = self.force - self.bias - self.dissipation - ca.mtimes(self.mass, a)
            a[free] = ca.solve(self.mass[free, free], right[free])
        self.acceleration = a
        x = ca.vertcat(n.q, n.v, n.z)
        self.rates = ca.vertcat(a, *n.lag_rates)
        outputs = []
        for o in self.rig["outputs"]:
            y = n.optional(o["scale"], 1.0) * n.value(o["value"]) + n.optional(o["bias"])
            if o["encoder"] is not None:
                y -= n.optional(o["encoder"]["zero"])
            outputs.append(y)
        y = ca.vertcat(ca.SX(0, 1), *outputs)
        self.quantities = {
            "M": self.mass, "bias": self.bias, "gravity": self.gravity, "dissipation": self.dissipation, "force": self.force,
            "rates": self.rates, "A": ca.jacobian(self.rates, x), "B": ca.jacobian(self.rates, n.u), "P": ca.jacobian(self.rates, n.p),
            "y": y, "C": ca.jacobian(y, x), "dydp": ca.jacobian(y, n.p),
            "kinetic": self.kinetic, "potential": self.potential,
        }
        if self.rig["equations"]:
            del self.quantities["kinetic"], self.quantities["potential"]
        self.function = ca.Function("f", [n.t, x, n.u, n.p], list(self.quantities.values()))

    def evaluate(self, t, x, u, p):
        values = self.function(t, x, u, p)
        out = {}
        for (name, expr), value in zip(self.quantities.items(), values):
            value = np.array(value.full())
            if name in ("kinetic", "potential"):
                out[name] = float(value[0, 0])
            elif name in ("M", "A", "B", "P", "C", "dydp"):
                out[name] = value.tolist()
            else:
                out[name] = value[:, 0].tolist() if value.size else []
        return out


# ---------------------------------------------------------------- states and operating points


class Random:
    """SplitMix64: the same numbers on every machine and with every library."""

    def __init__(self, seed):
        self.state = seed

    def unit(self):
        mask = (1 << 64) - 1
        self.state = (self.state + 0x9E3779B97F4A7C15) & mask
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return ((z ^ (z >> 31)) >> 11) / (1 << 53)

    def within(self, lo, hi):
        return lo + (hi - lo) * self.unit()


def random_state(rig, n, r):
    """Coordinates and inputs within their ranges (or within one unit), parameters within 5 % of their values."""
    inside = lambda limits: r.within(*(limits or (-1.0, 1.0)))
    q = [inside(c["range"]) for c in rig["coordinates"]]
    v = [r.within(-1.0, 1.0) for _ in q]
    z = [r.within(-1.0, 1.0) for _ in range(n.z.numel())]
    u = [inside(i["limits"]) for i in rig["inputs"]]
    u += [r.within(-1.0, 1.0) for _ in range(n.u.numel() - len(u))]
    p = [x["value"] * (1 + r.within(-0.05, 0.05)) if x["value"] else r.within(-0.01, 0.01) for x in rig["parameters"]]
    return {"t": r.within(0.0, 2.0), "x": q + v + z, "u": u, "p": p}


class Place:
    """Directions in [x | u] that names of a trim move."""

    def __init__(self, rig, n):
        self.rig, self.n = rig, n
        self.count = len(n.coordinates)
        self.states = 2 * self.count + n.z.numel()
        self.total = self.states + n.u.numel()
        self.inputs = [i["name"] for i in rig["inputs"]]

    def direction(self, symbol):
        d = np.zeros(self.total)
        kind, name = symbol_of(symbol)
        if kind == "coord":
            d[self.n.coordinates.index(name)] = 1
        elif kind == "rate":
            d[self.count + self.n.coordinates.index(name)] = 1
        elif kind == "input":
            d[self.states + self.inputs.index(name)] = 1
        else:
            # a mixed input: the inputs move so that the other mixed ones stay
            mix = next(m for m in self.rig["mixes"] if name in m["names"])
            inverse = np.linalg.inv(np.array(mix["rows"], dtype=float))
            for i, weight in zip(mix["inputs"], inverse[:, mix["names"].index(name)]):
                d[self.states + self.inputs.index(i)] = weight
        return d


def find_trim(rig, n, equations, trim, p):
    """Newton's method on our own equations, steps of minimum norm; lags follow their commands."""
    place = Place(rig, n)
    w = np.zeros(place.total)
    value = ca.Function("v", [n.p], [ca.vertcat(ca.SX(0, 1), *(n.value(f["value"]) for f in trim["fixed"]))])
    for f, x in zip(trim["fixed"], np.array(value(p)).ravel()):
        w += x * place.direction(f["of"])
    columns = [place.direction(s) for s in trim["solve"]]
    for k in range(n.z.numel()):
        unit = np.zeros(place.total)
        unit[2 * place.count + k] = 1
        columns.append(unit)
    columns = np.array(columns).T.reshape(place.total, -1)
    rows = [n.coordinates.index(c) for c in trim["zero"]] + [place.count + k for k in range(n.z.numel())]

    def at(w):
        e = equations.evaluate(0.0, w[: place.states], w[place.states :], p)
        rates = np.array(e["rates"])
        slope = np.hstack([np.array(e["A"]).reshape(len(rates), -1), np.array(e["B"]).reshape(len(rates), -1)])
        return rates[rows], slope[rows] @ columns, e

    residual, slope, e = at(w)
    for _ in range(100):
        if not columns.size or np.max(np.abs(residual), initial=0.0) == 0.0:
            break
        step = columns @ np.linalg.lstsq(slope, -residual, rcond=1e-10)[0]
        factor = 1.0
        while factor > 1e-9:
            trial = at(w + factor * step)
            if np.max(np.abs(trial[0])) < np.max(np.abs(residual)):
                break
            factor /= 2
        else:
            break
        w = w + factor * step
        residual, slope, e = trial
    rank = int(np.linalg.matrix_rank(slope, tol=1e-9 * max(np.linalg.norm(slope, 2), 1e-300))) if slope.size else 0
    return {
        "name": trim["name"], "x": w[: place.states].tolist(), "u": w[place.states :].tolist(),
        "residual": float(np.max(np.abs(residual), initial=0.0)), "rank": rank, "unknowns": columns.shape[1] if columns.size else 0,
        "rates": e["rates"], "A": e["A"], "B": e["B"], "K": regulator(place, e, len(rig["inputs"])),
    }


def regulator(place, e, inputs):
    """The gain of the regulator with identity weights by SciPy; None where the rig's inputs cannot stabilize it."""
    rows = len(e["rates"])
    a = np.zeros((place.states, place.states))
    a[: place.count, place.count : 2 * place.count] = np.eye(place.count)
    a[place.count :, :] = np.array(e["A"]).reshape(rows, -1)
    b = np.zeros((place.states, inputs))
    b[place.count :, :] = np.array(e["B"]).reshape(rows, -1)[:, :inputs]
    size = max(np.linalg.norm(a, 2), 1.0)
    for pole in np.linalg.eigvals(a):
        # a double pole at the origin is found to the root of rounding only
        if pole.real < -1e-6 * size:
            continue
        seen = np.hstack([a - pole * np.eye(len(a)), b])
        if np.linalg.svd(seen, compute_uv=False)[-1] < 1e-6 * size:
            return None
    x = solve_continuous_are(a, b, np.eye(len(a)), np.eye(inputs))
    return (b.T @ x).tolist()


# ---------------------------------------------------------------- results


def fnv1a(data):
    """Fingerprint of the declared text, as docs/declared-json.md says."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = ((value ^ byte) * 0x100000001B3) & ((1 << 64) - 1)
    return f"{value:016x}"


def text(value, indent=0):
    """JSON with one line a quantity, so that a change of a number is a change of a line."""
    pad = " " * indent
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad} {json.dumps(k)}: {text(v, indent + 1)}" for k, v in value.items())
        return "{\n" + inner + "\n" + pad + "}"
    if isinstance(value, list) and value and isinstance(value[0], dict):
        inner = ",\n".join(f"{pad} {text(v, indent + 1)}" for v in value)
        return "[\n" + inner + "\n" + pad + "]"
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def main():
    declared, result = sys.argv[1:3]
    data = open(declared, "rb").read()
    rig = json.loads(data)
    if rig["format"] != FORMAT:
        sys.exit(f"{declared}: format {rig['format']} is not known here, only {FORMAT}")
    n = Names(rig)
    equations = Equations(rig, n)
    random = Random(int.from_bytes(rig["rig"].encode(), "big") % (1 << 61))
    states = []
    for _ in range(STATES):
        state = random_state(rig, n, random)
        state |= equations.evaluate(state["t"], state["x"], state["u"], state["p"])
        states.append(state)
    nominal = [p["value"] for p in rig["parameters"]]
    trims = [find_trim(rig, n, equations, trim, nominal) for trim in rig["trims"]]
    out = {"rig": rig["rig"], "declared": fnv1a(data), "casadi": ca.__version__, "states": states, "trims": trims}
    open(result, "w").write(text(out) + "\n")


if __name__ == "__main__":
    main()
