"""The same work in NumPy and scikit-learn, beside the medians that criterion stored."""

import json
import os
import sys
import time
import warnings

import numpy as np

warnings.filterwarnings("ignore")
from sklearn.manifold import smacof  # noqa: E402


def icosphere(level):
    g = (1 + 5**0.5) / 2
    v = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
         (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    f = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
         (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
         (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    v = [np.array(p) / np.linalg.norm(p) for p in v]
    for _ in range(level):
        middle, finer = {}, []

        def mid(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                p = v[i] + v[j]
                v.append(p / np.linalg.norm(p))
                middle[key] = len(v) - 1
            return middle[key]

        for a, b, c in f:
            ab, bc, ca = mid(a, b), mid(b, c), mid(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        f = finer
    return np.array(v), np.array(f)


def bent(v, amount):
    narrow = 1 - 0.3 * amount * (1 - v[:, 2] ** 2)
    return np.stack([narrow * v[:, 0] + 0.1 * amount * np.sin(2 * v[:, 2]),
                     narrow * v[:, 1], 1.6 * v[:, 2]], 1)


def dots(a, b):
    return (a * b).sum(-1)


def corners(f):
    return [(f[:, i], f[:, (i + 1) % 3], f[:, (i + 2) % 3]) for i in range(3)]


def curvature(v, f):
    """Angle deficits of a closed mesh."""
    k = np.full(len(v), 2 * np.pi)
    for p, q, r in corners(f):
        u, w = v[q] - v[p], v[r] - v[p]
        np.subtract.at(k, p, np.arctan2(np.linalg.norm(np.cross(u, w), axis=1), dots(u, w)))
    return k


def corner_terms(v, f, x):
    """Scale-free terms of eq. 3.3, faces by corners."""
    out = []
    for p, q, r in corners(f):
        d, e = v[p] - v[q], v[p] - v[r]
        out.append(dots(d, x[p] - x[q]) / dots(d, d) - dots(e, x[p] - x[r]) / dots(e, e))
    return np.stack(out, 1)


def norm2(v, f, x, change):
    """Additive quasi-conformal norm, by area."""
    a, b, c = (v[f[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    share = np.zeros(len(v))
    np.add.at(share, f.ravel(), np.repeat(area / 3, 3))
    angle = (area[:, None] * corner_terms(v, f, x) ** 2).sum()
    return (angle + dots(share, change**2) + 1e-4 * dots(share, dots(x, x))) / area.sum()


def distance(a, b, f):
    x, change = b - a, curvature(b, f) - curvature(a, f)
    return np.sqrt((norm2(a, f, x, change) + norm2(b, f, x, change)) / 2)


def prepared(v, f):
    """What does not depend on the other pose."""
    p, q, r = corners(f)[0]
    a, b, c = v[p], v[q], v[r]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    share = np.zeros(len(v))
    np.add.at(share, f.ravel(), np.repeat(area / 3, 3))
    sides = [a - b, b - c, c - a]
    return v, sides, [1 / dots(s, s) for s in sides], area / area.sum(), share / area.sum(), curvature(v, f)


def prepared_distance(a, b):
    total = 0.0
    x, change = dots(b[0] - a[0], b[0] - a[0]), (b[5] - a[5]) ** 2
    w = [t - s for s, t in zip(a[1], b[1])]
    for pose in (a, b):
        s = [dots(d, e) * i for d, e, i in zip(w, pose[1], pose[2])]
        t2 = (s[0] - s[2]) ** 2 + (s[1] - s[0]) ** 2 + (s[2] - s[1]) ** 2
        total += dots(pose[3], t2) + dots(pose[4], change) + 1e-4 * dots(pose[4], x)
    return np.sqrt(total / 2)


def seconds(work, repeats):
    work()
    best = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        best.append(time.perf_counter() - start)
    return float(np.median(best))


def main(folder):
    def ours(name):
        path = os.path.join(folder, name, "new", "estimates.json")
        with open(path, encoding="utf-8") as file:
            return json.load(file)["median"]["point_estimate"] * 1e-9

    rows = []
    for vertices, level, repeats in ((2562, 4, 21), (40962, 6, 5)):
        v, f = icosphere(level)
        a, b = bent(v, 0.0), bent(v, 1.0)
        before, after = prepared(a, f), prepared(b, f)
        rows.append((f"pair, {vertices} vertices, prepared", ours(f"quasi_conformal_pair_{vertices}"),
                     seconds(lambda: prepared_distance(before, after), repeats), "NumPy, prepared"))
        rows.append((f"pair, {vertices} vertices, from points", ours(f"unprepared_pair_{vertices}"),
                     seconds(lambda: distance(a, b, f), repeats), "NumPy"))
    for items, repeats in ((184, 5), (2000, 1)):
        points = np.random.default_rng(1).uniform(-1, 1, (items, 5)) * [1, 0.8, 0.6, 0.4, 0.2]
        d = np.sqrt(((points[:, None] - points[None]) ** 2).sum(-1))

        def peer():
            return smacof(d, n_components=2, init=points[:, :2], n_init=1, max_iter=100, eps=0.0,
                          normalized_stress=False)

        rows.append((f"SMACOF, {items} items, 100 steps", ours(f"smacof_100_steps_{items}"),
                     seconds(peer, repeats), "scikit-learn"))
    print(f"{'work':40} {'ours':>12} {'peer':>12} {'ratio':>8}  peer")
    for name, our, peer, who in rows:
        print(f"{name:40} {our * 1e3:9.3f} ms {peer * 1e3:9.3f} ms {peer / our:7.1f}x  {who}")


if __name__ == "__main__":
    main(sys.argv[1])
