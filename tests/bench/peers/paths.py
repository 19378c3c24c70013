"""The cheapest path of the bench `path` by SciPy's L-BFGS-B on gradients by JAX, beside criterion's medians.

The energy is that of the program's default settings, and so is the straight line's, which is printed beside the share
of it that is left. The peer runs until its energy is as low as the program's, and then until it converges.
"""

import json
import os
import sys
import time

os.environ.setdefault("JAX_PLATFORMS", "cpu")
import jax
import jax.numpy as jnp
import numpy as np
from scipy.optimize import minimize

from peers import LAMBDA, MU, RINGS, icosphere

jax.config.update("jax_enable_x64", True)


def energy_of(f, count):
    sides = np.stack([f, np.roll(f, -1, 1)], 2).reshape(-1, 2)
    ends, index = np.unique(np.sort(sides, 1), axis=0, return_inverse=True)
    face_edges = jnp.array(index.reshape(-1, 3))
    p, q = jnp.array(ends[:, 0]), jnp.array(ends[:, 1])
    beside = 1 + np.bincount(ends.ravel(), minlength=count).max()
    corners = jnp.array(f)

    def gathered(x):
        for _ in range(RINGS):
            x = x / beside
            x = x + jnp.zeros(count).at[p].add(x[q]).at[q].add(x[p])
        return x

    def measured(v):
        a, b, c = (v[corners[:, k]] for k in range(3))
        doubled = jnp.linalg.norm(jnp.cross(b - a, c - a), axis=1)
        areas = 0.5 * doubled
        total = areas.sum()
        of_vertices = jnp.zeros(count)
        deficit = jnp.full(count, 2 * jnp.pi)
        for k, (o, x, y) in enumerate([(a, b, c), (b, c, a), (c, a, b)]):
            of_vertices = of_vertices.at[corners[:, k]].add(areas / 3)
            angle = jnp.arctan2(doubled, ((x - o) * (y - o)).sum(1))
            deficit = deficit.at[corners[:, k]].add(-angle)
        curvature = gathered(deficit) / gathered(of_vertices) * total / (4 * jnp.pi)
        return areas / total, of_vertices / total, total, curvature

    def norm2(v, x, shares, change):
        of_faces, of_vertices, total, _ = shares
        side = v[p] - v[q]
        s = (((x[p] - x[q]) * side).sum(1) / (side**2).sum(1))[face_edges]
        t = s - jnp.roll(s, 1, axis=1)
        angle = (of_faces * (t**2).sum(1)).sum()
        bend = (of_vertices * change**2).sum()
        moved = (of_vertices * (x**2).sum(1)).sum()
        return angle + MU * bend + LAMBDA * 4 * jnp.pi / total * moved

    def energy(path):
        shares = jax.vmap(measured)(path)
        steps = path[1:] - path[:-1]
        change = shares[3][1:] - shares[3][:-1]
        before = [part[:-1] for part in shares]
        after = [part[1:] for part in shares]
        here = jax.vmap(norm2)(path[:-1], steps, before, change)
        there = jax.vmap(norm2)(path[1:], steps, after, change)
        return (here + there).sum()

    return energy


def compared(level, in_betweens, criterion):
    v, f = icosphere(level)
    end = v * (1 + 0.6 * np.maximum(v[:, 2:], 0) ** 2)
    energy = energy_of(f, len(v))
    t = np.linspace(0, 1, in_betweens + 2)[1:-1, None, None]
    straight = (1 - t) * v + t * end

    def of_inner(x):
        inner = x.reshape(in_betweens, len(v), 3)
        return energy(jnp.concatenate([v[None], inner, end[None]]))

    both = jax.jit(jax.value_and_grad(of_inner))
    linear = float(both(straight.ravel())[0])
    ours = os.path.join(criterion, f"geodesic_{in_betweens}_in_betweens_{len(v)}", "new", "estimates.json")
    with open(ours, encoding="utf-8") as file:
        seconds = json.load(file)["median"]["point_estimate"] * 1e-9
    print(f"{len(v)} vertices, {in_betweens} in-betweens: straight line {linear:.9f}, ours {1e3 * seconds:.1f} ms")
    for name, tolerance in [("ftol 1e-6", 1e-6), ("ftol 1e-9", 1e-9)]:
        begun = time.perf_counter()
        found = minimize(lambda x: tuple(np.asarray(y, float) for y in both(x)), straight.ravel(), jac=True,
                         method="L-BFGS-B", options=dict(maxiter=4000, maxfun=8000, maxcor=10, ftol=tolerance, gtol=0))
        took = time.perf_counter() - begun
        print(f"  SciPy + JAX, {name}: {took:.2f} s, {found.nit} iterations, {found.fun / linear:.9f} of the straight "
              f"line's energy; {took / seconds:.0f} times ours")


if __name__ == "__main__":
    compared(3, 3, sys.argv[1])
    compared(4, 3, sys.argv[1])
