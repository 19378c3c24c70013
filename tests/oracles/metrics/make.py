"""Products of two fields in every metric, by NumPy: writes products.json, which tests/it/oracles.rs reads.

A new metric is a function in METRICS, under the name that `--metric` has for it. Then:
    python3 tests/oracles/metrics/make.py
A function takes (points, triangles, x, y, relative): n × 3 points of M, k × 3 vertex numbers, two n × 3 fields, and
whether terms are relative to lengths (`Corners::ScaleFree`) or as printed (`Corners::Raw`). It returns <<X, Y>> at M in the
bilinear form, without weights of area and without regulariser, as plainly as the formula is written: it is the peer of
the fast code, so copy nothing from there. Before writing, numbers that libigl and finite differences confirmed
(cases.json) are computed again; the program stops if one differs.
"""
import json
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
MESHES = ["ico42", "torus200", "bowl"]


def edges(triangles):
    """Every undirected edge once."""
    sides = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return np.unique(np.sort(sides, axis=1), axis=0)


def dot(a, b):
    return np.sum(a * b, axis=-1)


def isometric(points, triangles, x, y, relative):
    """Sum over edges of <X_p - X_q, p - q> <Y_p - Y_q, p - q> (2.3.6)."""
    p, q = edges(triangles).T
    side = points[p] - points[q]
    rate_x, rate_y = dot(x[p] - x[q], side), dot(y[p] - y[q], side)
    return np.sum(rate_x * rate_y / (dot(side, side) ** 2 if relative else 1.0))


def rigid(points, triangles, x, y, relative):
    """Displacement that no motion k1 + k2 × p explains, by least squares (2.3.7)."""
    columns = [np.tile(axis, (len(points), 1)) for axis in np.eye(3)]
    columns += [np.cross(axis, points) for axis in np.eye(3)]
    basis = np.stack([column.ravel() for column in columns], axis=1)

    def rest(field):
        fitted = np.linalg.lstsq(basis, field.ravel(), rcond=None)[0]
        return field.ravel() - basis @ fitted

    return rest(x) @ rest(y)


def corner_terms(points, triangles, field, relative):
    """T_p = <X_p - X_q, p - q> |p - r|^2 - <X_p - X_r, p - r> |p - q|^2 at the corners of every triangle p, q, r (3.2)."""
    terms = []
    for turn in range(3):
        p, q, r = np.roll(triangles, -turn, axis=1).T
        pq, pr = points[p] - points[q], points[p] - points[r]
        length_pq, length_pr = dot(pq, pq), dot(pr, pr)
        term = dot(field[p] - field[q], pq) * length_pr - dot(field[p] - field[r], pr) * length_pq
        terms.append(term / (length_pq * length_pr if relative else 1.0))
    return np.stack(terms, axis=1)


def angle_preserving(points, triangles, x, y, relative):
    """Sum over corners of T(X) T(Y) (3.3 without absolute values)."""
    return np.sum(corner_terms(points, triangles, x, relative) * corner_terms(points, triangles, y, relative))


def angle_deficits(points, triangles):
    """2 pi less the angles at an inner vertex, pi less those at one of the boundary."""
    sums = np.zeros(len(points))
    for turn in range(3):
        p, q, r = np.roll(triangles, -turn, axis=1).T
        pq, pr = points[q] - points[p], points[r] - points[p]
        np.add.at(sums, p, np.arctan2(np.linalg.norm(np.cross(pq, pr), axis=1), dot(pq, pr)))
    sides = np.sort(np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    once = np.unique(sides, axis=0, return_counts=True)
    flat = np.full(len(points), 2.0 * np.pi)
    flat[once[0][once[1] == 1].ravel()] = np.pi
    return flat - sums


def quasi_conformal(points, triangles, x, y, relative):
    """Sum over corners of dK_p(X) T(X) dK_p(Y) T(Y), with dK = K(M + X) - K(M) (3.5)."""
    before = angle_deficits(points, triangles)

    def terms(field):
        change = angle_deficits(points + field, triangles) - before
        return change[triangles] * corner_terms(points, triangles, field, relative)

    return np.sum(terms(x) * terms(y))


METRICS = {
    "quasi-conformal": quasi_conformal,
    "angle-preserving": angle_preserving,
    "isometric": isometric,
    "displacement": rigid,
}

CONFIRMED = {
    "iso_XX": (isometric, False, "XX"),
    "iso_norm_XY": (isometric, True, "XY"),
    "rigid_XY": (rigid, False, "XY"),
    "ap_bilinear_XY": (angle_preserving, False, "XY"),
    "ap_bilinear_norm_YY": (angle_preserving, True, "YY"),
    "qc_bilinear_XX": (quasi_conformal, False, "XX"),
    "qc_bilinear_norm_YY": (quasi_conformal, True, "YY"),
}


def read(name):
    points, triangles = [], []
    for line in (HERE / f"{name}.in_mesh.obj").read_text().splitlines():
        kind, *fields = line.split() or [""]
        if kind == "v":
            points.append([float(field) for field in fields])
        elif kind == "f":
            triangles.append([int(field) - 1 for field in fields])
    fields = {key: np.loadtxt(HERE / f"{name}.in_{key}.csv", delimiter=",") for key in "XY"}
    return np.array(points), np.array(triangles), fields


def main():
    cases = {case["name"]: case["expected"] for case in json.loads((HERE / "cases.json").read_text())["cases"]}
    products = {}
    for name in MESHES:
        points, triangles, fields = read(name)

        def product(metric, relative, pair):
            return float(metric(points, triangles, fields[pair[0]], fields[pair[1]], relative))

        for key, of in CONFIRMED.items():
            found, expected = product(*of), cases[name][key]
            if abs(found - expected) > 1e-8 * abs(expected):
                raise SystemExit(f"{name} {key}: {found}, confirmed is {expected}")
        products[name] = {
            metric: {
                corners: {pair: product(function, relative, pair) for pair in ("XX", "XY", "YY")}
                for corners, relative in (("raw", False), ("scale-free", True))
            }
            for metric, function in METRICS.items()
        }
    (HERE / "products.json").write_text(json.dumps(products, indent=1) + "\n")


if __name__ == "__main__":
    main()
