"""The same work in NumPy and scikit-learn, beside the medians that criterion stored.

The distance is that of the program's default settings: its value is printed, and is to equal the one
that the bench prints.
"""

import json
import os
import sys
import time
import warnings

import numpy as np

warnings.filterwarnings("ignore")
from scipy import sparse  # noqa: E402
from sklearn.datasets import make_swiss_roll  # noqa: E402
from sklearn.manifold import Isomap, LocallyLinearEmbedding, smacof  # noqa: E402


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


MU, RINGS, LAMBDA = 1e-3, 4, 3.0


def dots(a, b):
    return (a * b).sum(-1)


def corners(f):
    return [(f[:, i], f[:, (i + 1) % 3], f[:, (i + 2) % 3]) for i in range(3)]


def neighbours(f, count):
    """I + adjacency, so that its RINGS-th power gathers over the neighbourhood of each vertex."""
    i = np.concatenate([f[:, 0], f[:, 1], f[:, 2]])
    j = np.concatenate([f[:, 1], f[:, 2], f[:, 0]])
    both = sparse.coo_matrix((np.ones(len(i)), (i, j)), (count, count))
    return (both + sparse.identity(count)).tocsr()


def areas(v, f):
    """Areas of faces, and a third of them around each vertex."""
    a, b, c = (v[f[:, i]] for i in range(3))
    face = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return face, np.bincount(f.ravel(), np.repeat(face / 3, 3), len(v))


def curvature(v, f, near, face, around):
    """Angle deficits of a closed mesh over area, both averaged over rings; 1 on a sphere."""
    k = np.full(len(v), 2 * np.pi)
    for p, q, r in corners(f):
        u, w = v[q] - v[p], v[r] - v[p]
        angle = np.arctan2(np.linalg.norm(np.cross(u, w), axis=1), dots(u, w))
        k -= np.bincount(p, angle, len(v))
    for _ in range(RINGS):
        k, around = near @ k, near @ around
    return k / around * face.sum() / (4 * np.pi)


class Pose:
    """What does not depend on the other pose; fields are rows of x, y and z."""

    def __init__(self, v, f, near):
        face, around = areas(v, f)
        self.v, self.f, self.centre = v, f, v.mean(0)
        self.sides = [v[f[:, i]] - v[f[:, (i + 1) % 3]] for i in range(3)]
        self.inverse = [1 / dots(s, s) for s in self.sides]
        self.face, self.share = face / face.sum(), around / face.sum()
        self.curvature = curvature(v, f, near, face, around)
        self.regulariser = LAMBDA * 4 * np.pi / face.sum()


def distance(a, b, rotation=np.eye(3), shift=np.zeros(3)):
    """Additive quasi-conformal distance of a pose and another one moved."""
    x = b.v @ rotation.T + shift - a.v
    x2, change = dots(x, x), (b.curvature - a.curvature) ** 2
    w = [t @ rotation.T - s for s, t in zip(a.sides, b.sides)]
    moved = [t @ rotation.T for t in b.sides]
    total = 0.0
    for pose, sides in ((a, a.sides), (b, moved)):
        s = [dots(d, e) * i for d, e, i in zip(w, sides, pose.inverse)]
        angle = (s[0] - s[2]) ** 2 + (s[1] - s[0]) ** 2 + (s[2] - s[1]) ** 2
        total += pose.face @ angle + pose.share @ (MU * change + pose.regulariser * x2)
    return np.sqrt(total / 2)


def aligned_distance(a, b):
    """The other pose is first laid onto this one by the rigid motion of least squares."""
    u, _, vt = np.linalg.svd((a.v - a.centre).T @ (b.v - b.centre))
    rotation = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ vt))]) @ vt
    return distance(a, b, rotation, a.centre - rotation @ b.centre)


def beating(v, subjects=23, frames=8):
    """The beats of the bench's cohort."""
    for subject in range(subjects):
        for frame in range(frames):
            yield bent(v, (0.5 + 0.03 * subject) * (1 - np.cos(2 * np.pi * frame / frames)))


def box(v):
    return (v.max(0) - v.min(0)).max()


def all_pairs(v, f, near):
    """Distances of every pose to every other, sizes normalised at each subject's first frame."""
    shapes = list(beating(v))
    poses = [Pose(p / box(shapes[i - i % 8]), f, near) for i, p in enumerate(shapes)]
    for i, a in enumerate(poses):
        for b in poses[i + 1:]:
            aligned_distance(a, b)


def seconds(work, repeats, warm_up=True):
    if warm_up:
        work()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def main(folder, begun_s):
    def ours(name):
        path = os.path.join(folder, name, "new", "estimates.json")
        if os.path.getmtime(path) < begun_s:
            sys.exit(f"{name} was not measured in this run")
        with open(path, encoding="utf-8") as file:
            return json.load(file)["median"]["point_estimate"] * 1e-9

    rows = []
    for vertices, level, repeats in ((2562, 4, 21), (40962, 6, 5)):
        v, f = icosphere(level)
        near = neighbours(f, len(v))
        before, after = bent(v, 0.0), bent(v, 1.0)
        a, b = Pose(before, f, near), Pose(after, f, near)
        print(f"NumPy: distance at {vertices} vertices: {distance(a, b):.12f}")
        rows.append((f"pair, {vertices} vertices, prepared", ours(f"quasi_conformal_pair_{vertices}"),
                     seconds(lambda: distance(a, b), repeats), "NumPy"))
        rows.append((f"pair, {vertices} vertices, aligned", ours(f"aligned_pair_{vertices}"),
                     seconds(lambda: aligned_distance(a, b), repeats), "NumPy"))
        rows.append((f"pair, {vertices} vertices, from points", ours(f"unprepared_pair_{vertices}"),
                     seconds(lambda: distance(Pose(before, f, near), Pose(after, f, near)), repeats),
                     "NumPy, SciPy"))
        if level == 4:
            rows.append(("all 16836 pairs of 184 poses", ours("all_pairs_184_poses"),
                         seconds(lambda: all_pairs(v, f, near), 1, warm_up=False), "NumPy, SciPy"))
    for items, repeats in ((184, 5), (2000, 2)):
        points = np.random.default_rng(1).uniform(-1, 1, (items, 5)) * [1, 0.8, 0.6, 0.4, 0.2]
        d = np.sqrt(((points[:, None] - points[None]) ** 2).sum(-1))

        def peer():
            return smacof(d, n_components=2, init=points[:, :2], n_init=1, max_iter=100, eps=0.0,
                          normalized_stress=False, return_n_iter=True)

        steps = peer()[2]
        if steps != 100:
            sys.exit(f"the peer did {steps} steps of SMACOF, not 100")
        rows.append((f"SMACOF, {items} items, 100 steps", ours(f"smacof_100_steps_{items}"),
                     seconds(peer, repeats, warm_up=False), "scikit-learn"))
    roll = make_swiss_roll(2000, random_state=1)[0]
    local = LocallyLinearEmbedding(n_neighbors=12, n_components=2, eigen_solver="arpack", random_state=0)
    rows.append(("LLE, 2000 points, 12 neighbours", ours("lle_2000"),
                 seconds(lambda: local.fit_transform(roll), 5), "scikit-learn"))
    rows.append(("Isomap, 2000 points, 8 neighbours", ours("isomap_2000"),
                 seconds(lambda: Isomap(n_neighbors=8, n_components=2).fit_transform(roll), 3),
                 "scikit-learn"))
    print(f"{'work':36} {'ours':>13} {'peer':>13} {'ours : peer':>12}  peer")
    for name, our, peer, who in rows:
        print(f"{name:36} {our * 1e3:10.3f} ms {peer * 1e3:10.3f} ms {'1 : %.1f' % (peer / our):>12}  {who}")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
