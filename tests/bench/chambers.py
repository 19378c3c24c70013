#!/usr/bin/env python3
"""How long `analyze` takes on a cohort of closed chambers: seconds and peak memory.

chambers.py [--subjects 100] [--frames 8] PROGRAM FOLDER [OPTION ...]

Makes FOLDER, if it is not there: chambers of 938 corresponding vertices as OBJ files, ellipsoids of varying length, width
and bend that contract and turn in two ways, which are their labels. Then runs `analyze FOLDER --transfer mean` with
further options and prints what the summary says of the classification.
"""
import argparse
import json
import math
import pathlib
import random
import resource
import subprocess
import tempfile
import time

RINGS, AROUND = 26, 36


def faces():
    """Rows of an OBJ file: two caps and the quads between rings, split; the apex is vertex 1, the other pole the last."""
    vertex = lambda ring, step: 2 + ring * AROUND + step % AROUND
    last = 2 + RINGS * AROUND
    for step in range(AROUND):
        yield 1, vertex(0, step + 1), vertex(0, step)
        yield last, vertex(RINGS - 1, step), vertex(RINGS - 1, step + 1)
        for ring in range(RINGS - 1):
            a, b = vertex(ring, step), vertex(ring, step + 1)
            c, d = vertex(ring + 1, step), vertex(ring + 1, step + 1)
            yield a, b, d
            yield a, d, c


def sphere():
    yield 0.0, 0.0, -1.0
    for ring in range(1, RINGS + 1):
        polar = math.pi * ring / (RINGS + 1)
        for step in range(AROUND):
            angle = 2 * math.pi * step / AROUND
            yield math.sin(polar) * math.cos(angle), math.sin(polar) * math.sin(angle), -math.cos(polar)
    yield 0.0, 0.0, 1.0


def make(folder, subjects, frames):
    draw = random.Random(1)
    rows = "".join("f %d %d %d\n" % face for face in faces())
    partial = folder.with_name(folder.name + ".partial")
    entries = []
    for subject in range(subjects):
        id, ill = f"S{subject + 1:03}", subject % 2
        wide, long, bend = draw.uniform(20, 32), draw.uniform(35, 55), draw.uniform(-0.3, 0.3)
        most, twist = draw.uniform(0.2, 0.35) * (1 - 0.4 * ill), draw.uniform(0.1, 0.3)
        (partial / id).mkdir(parents=True)
        for frame in range(frames):
            share = math.sin(math.pi * frame / frames) ** 2
            with open(partial / id / f"cavity_{frame:03}.obj", "w") as file:
                for x, y, z in sphere():
                    across = 1 - most * share * (1 + 0.5 * ill * x)
                    turn = twist * share * z
                    x, y = across * x, across * y
                    x, y = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
                    file.write("v %.6f %.6f %.6f\n" % (wide * (x + bend * z * z), wide * y, long * (1 - 0.3 * most * share) * z))
                file.write(rows)
        label = ["even", "one side"][ill]
        entries.append(f'[[subject]]\nid = "{id}"\nlabel = "{label}"\ncavity = "{id}/cavity_*.obj"\n')
    (partial / "study.toml").write_text('name = "Chambers"\nunits = "mm"\n\n' + "\n".join(entries))
    partial.rename(folder)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--subjects", type=int, default=100)
    parser.add_argument("--frames", type=int, default=8)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("options", nargs=argparse.REMAINDER)
    asked = parser.parse_args()
    if not asked.folder.exists():
        make(asked.folder, asked.subjects, asked.frames)
    with tempfile.TemporaryDirectory() as out:
        begin = time.time()
        command = [asked.program, "analyze", asked.folder, "--transfer", "mean", "--figures", "off", *asked.options]
        subprocess.run([*command, "--out", f"{out}/results"], check=True, stdout=subprocess.DEVNULL)
        seconds = time.time() - begin
        summary = json.loads(pathlib.Path(f"{out}/results/summary.json").read_text())
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    processor = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{asked.subjects} subjects x {asked.frames} poses: {seconds:.1f} s, {processor.ru_utime:.0f} s of processor, {memory:.0f} MB")
    told = summary["classification"]
    for rule in ["nearest_neighbour", "linear_rule", "plane_rule", "tau"]:
        print(f"{rule}: {told[rule]['correct']} of {told[rule]['of']}")


main()
