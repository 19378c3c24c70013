"""Laplace thickness of the bench `medial`'s shell of 64³ voxels by PyEzzi, beside criterion's median.

The peer runs as it does by default (32 bits, tolerance 1e-6) and as exactly as the program does (64 bits, until its
mean no longer changes); mean thickness and voxels are printed, and are to equal those that the bench prints.
"""

import json
import os
import sys

import numpy as np
from pyezzi import Domain, ThicknessSolver

from peers import seconds

VOXELS, INNER, OUTER = 64, 14.0, 25.0


def shell():
    axis = np.arange(VOXELS) - 0.5 * (VOXELS - 1)
    away = np.sqrt(axis[:, None, None] ** 2 + axis[:, None] ** 2 + axis**2)
    return away < INNER, away < OUTER


def measured(endo, epi, precision, tolerance):
    solver = ThicknessSolver(Domain(endo, epi, [1.0, 1.0, 1.0]), precision=precision)
    solver.solve_laplacian(tolerance, 20000)
    solver.solve_thickness(tolerance, 20000)
    return solver.result


def main(folder, begun_s):
    path = os.path.join(folder, "laplace_shell_64", "new", "estimates.json")
    if os.path.getmtime(path) < begun_s:
        sys.exit("laplace_shell_64 was not measured in this run")
    with open(path, encoding="utf-8") as file:
        ours = json.load(file)["median"]["point_estimate"] * 1e-9
    endo, epi = shell()
    wall = epi & ~endo
    print(f"Laplace thickness on {wall.sum()} voxels of a shell in {VOXELS}³: ours {1e3 * ours:.1f} ms")
    for name, precision, tolerance in (("by default", 32, 1e-6), ("as exact", 64, 1e-10)):
        mean = float(np.nanmean(measured(endo, epi, precision, tolerance)[wall]))
        took = seconds(lambda: measured(endo, epi, precision, tolerance), 5, warm_up=False)
        print(f"  PyEzzi {name} ({precision} bits, tolerance {tolerance:g}): {1e3 * took:.1f} ms, mean thickness {mean:.6f}; "
              f"{took / ours:.1f} times ours")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
