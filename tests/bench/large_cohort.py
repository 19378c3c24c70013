#!/usr/bin/env python3
"""How the window opens a large cohort: seconds to its rows, to the first heart and to a heart that was clicked, and peak
memory, on a virtual screen with Mesa's software Vulkan.

large_cohort.py [--subjects 200] [--frames 25] [--vertices 5200] [--memory MIB] PROGRAM FOLDER

Makes FOLDER, if it is not there, from the built-in cohort with other random seeds: its eight frames, interpolated in time
to as many as are asked for, as OBJ files. Then opens it and clicks rows: one that is read while others are still read,
one that is not read yet, and ten while maps are computed.

Needs: apt-get install xvfb xdotool mesa-vulkan-drivers
"""
import argparse
import multiprocessing
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

from window_rate import QUIET, Window

BUILT_IN_SUBJECTS, BUILT_IN_FRAMES = 23, 8
SHEETS = ["endo", "epi"]


def frames_of(lines, count):
    """Vertices at `count` times of the cycle, from lists at equal times: periodic cubic interpolation."""
    known = len(lines)
    for frame in range(count):
        at = frame * known / count
        k, t = int(at), at - int(at)
        weights = (
            0.5 * (-t + 2 * t**2 - t**3),
            0.5 * (2 - 5 * t**2 + 3 * t**3),
            0.5 * (t + 4 * t**2 - 3 * t**3),
            0.5 * (-(t**2) + t**3),
        )
        four = [lines[(k + step) % known] for step in (-1, 0, 1, 2)]
        yield [sum(w * x for w, x in zip(weights, xs)) for xs in zip(*four)]


def write_subject(job):
    made, folder, frames = job
    folder.mkdir(parents=True)
    for sheet in SHEETS:
        known, faces = [], []
        for frame in range(BUILT_IN_FRAMES):
            text = (made / f"{sheet}_{frame:03}.obj").read_text()
            known.append([float(x) for line in text.splitlines() if line[0] == "v" for x in line[2:].split()])
            faces = [line for line in text.splitlines() if line[0] == "f"]
        for frame, numbers in enumerate(frames_of(known, frames)):
            vertices = ("v %.12f %.12f %.12f\n" * (len(numbers) // 3)) % tuple(numbers)
            (folder / f"{sheet}_{frame:03}.obj").write_text(vertices + "\n".join(faces) + "\n")


def make(program, folder, subjects, frames, vertices):
    """The cohort, under a temporary name until it is whole."""
    partial = folder.with_name(folder.name + ".partial")
    partial.mkdir(parents=True)
    jobs, entries = [], []
    with tempfile.TemporaryDirectory() as seeds:
        for seed in range(-(-subjects // BUILT_IN_SUBJECTS)):
            made = pathlib.Path(seeds) / str(seed)
            options = ["--seed", seed + 1, "--vertices", vertices, "--format", "obj"]
            subprocess.run([program, "demo", "--out", made, *map(str, options)], check=True, **QUIET)
            for entry in (made / "study.toml").read_text().split("[[subject]]")[1:]:
                name = re.search('id = "(.*)"', entry).group(1)
                id = f"S{len(jobs) + 1:03}"
                if len(jobs) < subjects:
                    jobs.append((made / name, partial / id, frames))
                    kept = [line for line in entry.splitlines() if re.match("label|surface|rr_ms|height|weight|orient", line)]
                    files = [f'{sheet} = "{id}/{sheet}_*.obj"' for sheet in SHEETS]
                    entries.append("\n".join(["[[subject]]", f'id = "{id}"', *files, *kept]))
        with multiprocessing.Pool() as pool:
            pool.map(write_subject, jobs, chunksize=1)
    head = 'name = "Large cohort"\nunits = "mm"\nnormal = ["normal"]\nabnormal = ["abnormal"]\n\n'
    (partial / "study.toml").write_text(head + "\n\n".join(entries) + "\n")
    partial.rename(folder)


class Timed(Window):
    """A window whose program prints its times."""

    def __init__(self, folder, command):
        with open(pathlib.Path(folder) / "times", "w") as times:
            super().__init__(folder, (1600, 1000), command, {"CARDIOMORPH_TIMES": "1"}, times)

    def said(self, pattern):
        return re.findall(pattern, (self.folder / "times").read_text())

    def wait(self, pattern, limit_s, count=1):
        begin = time.time()
        while time.time() - begin < limit_s:
            if len(said := self.said(pattern)) >= count:
                return said[count - 1]
            if self.program.poll() is not None:
                sys.exit(f"the program ended: {(self.folder / 'times').read_text()}")
            time.sleep(0.01)
        return None

    def first(self, what):
        """Seconds from the start until it was seen first."""
        return self.wait(what + r" after ([\d.]+) s", 300)

    def click_row(self, row):
        """Clicks the row of the table that is so many rows below the first in sight; its subject and the seconds to it."""
        before = len(self.said(FOLLOWED))
        self.do("mousemove", 120, 150 + 24 * row)
        time.sleep(0.1)
        self.do("click", 1)
        return self.wait(FOLLOWED, 30, before + 1)


FOLLOWED = r"(\S+) on screen ([\d.]+) s after"


def measure(window):
    for what in ["rows of the cohort", "first picture"]:
        print(f"{what:<36}{window.first(what)} s after the start", flush=True)
    print(f"{'a subject that is read':<36}{window.click_row(1)}, while others are read", flush=True)
    window.do("mousemove", 120, 400, *["click", 5] * 60)
    print(f"{'a subject that is not read yet':<36}{window.click_row(12)}", flush=True)
    print(f"{'all subjects':<36}{window.first('all subjects')} s after the start", flush=True)
    time.sleep(2)
    window.do("mousemove", 120, 400, *["click", 4] * 60)
    followed = []
    for row in range(2, 22, 2):
        followed.append(float((window.click_row(row) or (None, "inf"))[1]))
        time.sleep(0.5)
    mapped = bool(window.said("finished pose map"))
    when = "after maps were computed" if mapped else "while maps are computed"
    median, longest = statistics.median(followed), max(followed)
    print(f"{'ten clicks, ' + when:<36}{median:.3f} s (median), {longest:.3f} s (longest)", flush=True)
    print(f"{'peak memory':<36}{window.resident_mb('VmHWM'):.0f} MB", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--subjects", type=int, default=200)
    parser.add_argument("--frames", type=int, default=25)
    parser.add_argument("--vertices", type=int, default=5200, help="of both surfaces of a subject together")
    parser.add_argument("--memory", type=int, help="budget of the program, in MiB")
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    if not options.folder.exists():
        make(options.program, options.folder, options.subjects, options.frames, options.vertices)
    command = [options.program, str(options.folder)]
    if options.memory:
        command += ["--memory", str(options.memory)]
    with tempfile.TemporaryDirectory() as folder:
        window = Timed(folder, command)
        try:
            measure(window)
        finally:
            window.close()


if __name__ == "__main__":
    main()
