"""The bench's models in CasADi, measured: as its users write them, and given the equations that this project derives.

usage: casadi_peer.py FOLDER [model ...]

FOLDER holds `<model>_export.py` for each model (`codegen::emit::casadi`); C and machine code go there too. One JSON line a
model: seconds of derivation, operations, seconds of gcc, nanoseconds a call (the least over many batches) of
x' and of [A, B], each for both ways, and the largest relative difference between the two at the measured point.
"""

import importlib.util
import json
import pathlib
import subprocess
import sys
import time

import casadi as ca
import numpy as np

AXES = {"x": 0, "y": 1, "z": 2}


def rotation(axis, angle):
    """R such that R a gives in the parent's axes what a is in the turned ones."""
    i = AXES[axis]
    j, k = (i + 1) % 3, (i + 2) % 3
    turn = ca.SX.eye(3)
    turn[j, j], turn[j, k], turn[k, j], turn[k, k] = ca.cos(angle), -ca.sin(angle), ca.sin(angle), ca.cos(angle)
    return turn


def unit(axis):
    """Unit vector."""
    e = ca.DM.zeros(3)
    e[AXES[axis]] = 1
    return e


class Model:
    """Kinetic and potential energy, generalized force, over symbols."""

    def __init__(self, coordinates, inputs, parameters):
        self.q = ca.SX.sym("q", coordinates)
        self.v = ca.SX.sym("v", coordinates)
        self.u = ca.SX.sym("u", inputs)
        self.p = ca.SX.sym("p", parameters)
        self.kinetic = self.potential = ca.SX(0)
        self.force = ca.SX.zeros(coordinates)

    def velocity(self, point):
        """Velocity of a point given in ground."""
        return ca.jacobian(point, self.q) @ self.v

    def weigh(self, mass, point, gravity):
        """Adds a point mass."""
        v = self.velocity(point)
        self.kinetic += mass * ca.dot(v, v) / 2
        self.potential += mass * gravity * point[2]

    def dynamics(self):
        """x' by Lagrange's equation; the mass matrix inverted where it is small, as users do."""
        momentum = ca.jacobian(self.kinetic, self.v)
        mass = ca.jacobian(momentum, self.v)
        bias = ca.jacobian(momentum, self.q) @ self.v - ca.jacobian(self.kinetic - self.potential, self.q).T
        right = self.force - bias
        acceleration = ca.inv(mass) @ right if self.q.numel() <= 3 else ca.solve(mass, right)
        return ca.vertcat(self.v, acceleration)


def heli3():
    """As rigs/heli3.rig."""
    m = Model(3, 2, 16)
    m_h, m_b, m_c, g, l_oc, l_ob, l_cd, l_oa, l_df, j_p, j_ay, j_az, j_hy, c_psi, c_eps, c_theta = ca.vertsplit(m.p)
    psi, eps, theta = ca.vertsplit(m.q)
    arm = rotation("z", psi) @ rotation("y", -eps)
    heli = arm @ rotation("x", theta)
    pivot = arm @ ca.vertcat(-l_oc, 0, 0)
    m.weigh(m_b, arm @ ca.vertcat(-l_oa, 0, 0), g)
    m.weigh(m_c, arm @ ca.vertcat(l_ob, 0, 0), g)
    m.weigh(m_h, pivot + heli @ ca.vertcat(0, 0, -l_cd), g)
    w_arm = rotation("y", -eps).T @ ca.vertcat(0, 0, m.v[0]) - unit("y") * m.v[1]
    w_heli = rotation("x", theta).T @ w_arm + unit("x") * m.v[2]
    m.kinetic += (j_ay * w_arm[1] ** 2 + j_az * w_arm[2] ** 2) / 2
    m.kinetic += (j_p * w_heli[0] ** 2 + j_hy * w_heli[1] ** 2 + j_hy * w_heli[2] ** 2) / 2
    m.force = -ca.vertcat(c_psi, c_eps, c_theta) * m.v
    for side, thrust in ((l_df, m.u[0]), (-l_df, m.u[1])):
        point = pivot + heli @ ca.vertcat(0, side, 0)
        m.force += ca.jacobian(point, m.q).T @ (heli @ ca.vertcat(0, 0, thrust))
    return m


def chain(axes, n):
    """As rigs/chain4.rig and rigs/spatial6.rig: parameters g, then m, l, I of each link."""
    m = Model(n, n, 1 + 3 * n)
    gravity = m.p[0]
    turn, origin, omega = ca.SX.eye(3), ca.SX.zeros(3), ca.SX.zeros(3)
    for i in range(n):
        mass, length, inertia = m.p[1 + 3 * i], m.p[2 + 3 * i], m.p[3 + 3 * i]
        axis = axes[i % len(axes)]
        step = rotation(axis, m.q[i])
        turn = turn @ step
        omega = step.T @ omega + unit(axis) * m.v[i]
        m.weigh(mass, origin + turn @ ca.vertcat(length / 2, 0, 0), gravity)
        m.kinetic += inertia * ca.dot(omega, omega) / 2
        origin = origin + turn @ ca.vertcat(length, 0, 0)
    m.force = m.u
    return m


MODELS = {"heli3": heli3, "chain4": lambda: chain("y", 4), "spatial6": lambda: chain("zyx", 6)}

HARNESS = r"""
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
typedef int evaluate(const double **, double **, long long *, double *, int);
typedef int sizes(long long *, long long *, long long *, long long *);
evaluate f, jacobians;
sizes f_work, jacobians_work;
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return t.tv_sec * 1e9 + t.tv_nsec; }
static double least(evaluate *call, sizes *work, const double **in, double *x, int results, double **out)
{
    long long arguments, values, integers, numbers;
    work(&arguments, &values, &integers, &numbers);
    const double **arg = calloc(arguments + 8, sizeof *arg);
    double **res = calloc(values + 8, sizeof *res);
    long long *iw = calloc(integers + 8, sizeof *iw);
    double *w = calloc(numbers + 8, sizeof *w), start = x[0], best = 1e300;
    for (int r = 0; r < 400; r++) {
        static int count = 1;
        double elapsed;
        if (r == 0) count = 1;
        do {
            if (r == 0) count *= 2;
            double begin = now();
            for (int i = 0; i < count; i++) {
                for (int k = 0; k < 4; k++) arg[k] = in[k];
                for (int k = 0; k < results; k++) res[k] = out[k];
                x[0] = start + i * 1e-9;
                call(arg, res, iw, w, 0);
            }
            elapsed = now() - begin;
        } while (r == 0 && elapsed < 5e5);
        if (elapsed / count < best) best = elapsed / count;
    }
    x[0] = start;
    for (int k = 0; k < 4; k++) arg[k] = in[k];
    for (int k = 0; k < results; k++) res[k] = out[k];
    call(arg, res, iw, w, 0);
    return best;
}
int main(int count, char **text)
{
    int timed = atoi(text[1]), nx = atoi(text[2]), nu = atoi(text[3]), np = atoi(text[4]), k = 5;
    double *t = calloc(1, 8), *x = calloc(nx, 8), *u = calloc(nu + 1, 8), *p = calloc(np + 1, 8);
    for (int i = 0; i < nx; i++) x[i] = atof(text[k++]);
    for (int i = 0; i < nu; i++) u[i] = atof(text[k++]);
    for (int i = 0; i < np; i++) p[i] = atof(text[k++]);
    const double *with_time[4] = {t, x, u, p}, *without[4] = {x, u, p, 0};
    const double **in = timed ? with_time : without;
    double *dx[2] = {calloc(nx * nx, 8), 0}, *ab[2] = {calloc(nx * nx, 8), calloc(nx * nu + 1, 8)};
    double first = least(f, f_work, in, x, 1, dx), second = least(jacobians, jacobians_work, in, x, 2, ab);
    printf("{\"f_ns\": %.1f, \"jacobians_ns\": %.1f, \"values\": [", first, second);
    for (int i = 0; i < nx; i++) printf("%.17g, ", dx[0][i]);
    for (int i = 0; i < nx * nx; i++) printf("%.17g, ", ab[0][i]);
    for (int i = 0; i < nx * nu; i++) printf("%.17g%s", ab[1][i], i + 1 < nx * nu ? ", " : "]}\n");
    return 0;
}
"""


def compiled(folder, name, f, jacobians, point, timed):
    """Generates C for both functions, compiles it as CasADi's users do, runs it at a point."""
    code = folder / f"{name}.c"
    generator = ca.CodeGenerator(code.name)
    for function, exported in ((f, "f"), (jacobians, "jacobians")):
        inputs = [ca.SX.sym(f"a{i}", *function.size_in(i)) for i in range(function.n_in())]
        # dense results, so that both ways write the same entries
        results = [ca.densify(r) for r in function.call(inputs)]
        generator.add(ca.Function(exported, inputs, results))
    generator.generate(f"{folder}/")
    begin = time.perf_counter()
    library = folder / f"{name}.so"
    subprocess.run(["gcc", "-O3", "-march=native", "-fPIC", "-shared", code, "-o", library, "-lm"], check=True)
    seconds = time.perf_counter() - begin
    program = folder / f"{name}_bench"
    (folder / "harness.c").write_text(HARNESS, encoding="utf-8")
    subprocess.run(["gcc", "-O2", folder / "harness.c", "-o", program, library, "-lm"], check=True)
    x, u, p = point
    numbers = [repr(float(a)) for a in (*x, *u, *p)]
    out = subprocess.run([program, str(int(timed)), str(len(x)), str(len(u)), str(len(p)), *numbers], check=True, capture_output=True, text=True)
    result = json.loads(out.stdout)
    result["gcc_s"] = round(seconds, 2)
    result["f_ops"], result["jacobians_ops"] = f.n_instructions(), jacobians.n_instructions()
    return result


def point_of(name, exported):
    """The point at which all are measured: that of the Rust side."""
    nx, nu = exported.forward_dynamics.numel_in(1), exported.forward_dynamics.numel_in(2)
    return [0.1 * (i + 1) for i in range(nx)], [1.5 - 0.1 * i for i in range(nu)], list(exported.PARAMETERS.values())


def measure(folder, name):
    """Both ways for one model."""
    begin = time.perf_counter()
    m = MODELS[name]()
    x = ca.vertcat(m.q, m.v)
    (dx,) = ca.cse([m.dynamics()])
    a, b = ca.cse([ca.jacobian(dx, x), ca.jacobian(dx, m.u)])
    seconds = time.perf_counter() - begin
    spec = importlib.util.spec_from_file_location(f"{name}_export", folder / f"{name}_export.py")
    exported = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(exported)
    point = point_of(name, exported)
    users = compiled(folder, f"{name}_users", ca.Function("f", [x, m.u, m.p], [dx]), ca.Function("jacobians", [x, m.u, m.p], [a, b]), point, False)
    ours = compiled(folder, f"{name}_ours", exported.forward_dynamics, exported.linearize, point, True)
    first, second = np.array(users.pop("values")), np.array(ours.pop("values"))
    difference = float(np.max(np.abs(first - second)) / np.max(np.abs(first)))
    return {"model": name, "casadi": ca.__version__, "derive_s": round(seconds, 3), "users": users, "ours": ours, "difference": difference}


if __name__ == "__main__":
    where = pathlib.Path(sys.argv[1])
    for wanted in sys.argv[2:] or MODELS:
        print(json.dumps(measure(where, wanted)), flush=True)
