#!/usr/bin/env python3
"""Pictures a second, processor time a picture and memory of the window on Mesa's software Vulkan, on a virtual screen.

window_rate.py [--size 1600x1000] [--settle 20] [--soak MINUTES] PROGRAM [FILES...]

Prints a line each for: the pointer over the table, turning, playing, playing all frames side by side. With --soak it
plays, turns and clicks for so many minutes, prints resident memory every half minute, and exits with 1 if it ends more
than a tenth above what it was after 5 minutes (or after a sixth of the time, if that is shorter).

Needs: apt-get install xvfb xdotool mesa-vulkan-drivers (whose overlay layer counts the pictures that are presented).
"""
import argparse
import contextlib
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
SPAN_S = 8


class Window:
    """The program on a screen of its own."""

    def __init__(self, folder, size, command, env, log=subprocess.DEVNULL):
        self.folder = pathlib.Path(folder)
        self.width, self.height = size
        display = f":{random.randint(300, 900)}"
        self.env = dict(os.environ, DISPLAY=display, XDG_RUNTIME_DIR=folder, HOME=folder, **env)
        self.env.pop("WAYLAND_DISPLAY", None)
        screen = f"{self.width}x{self.height}x24"
        self.screen = subprocess.Popen(["Xvfb", display, "-screen", "0", screen, "-nolisten", "tcp"], **QUIET)
        time.sleep(1)
        self.program = subprocess.Popen(command, env=self.env, stdout=subprocess.DEVNULL, stderr=log)
        found = self.do("search", "--sync", "--onlyvisible", "--pid", self.program.pid)
        found = found or self.do("search", "--sync", "--onlyvisible", "--name", ".")
        window = found[-1]
        self.do("windowmove", window, 0, 0, "windowsize", window, self.width, self.height, "windowfocus", window)

    def close(self):
        self.program.kill()
        self.screen.kill()

    def do(self, *words):
        command = ["xdotool", *map(str, words)]
        return subprocess.run(command, env=self.env, capture_output=True, text=True).stdout.split()

    def processor_s(self):
        fields = pathlib.Path(f"/proc/{self.program.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def resident_mb(self, field="VmRSS"):
        lines = pathlib.Path(f"/proc/{self.program.pid}/status").read_text().splitlines()
        return int(next(line for line in lines if line.startswith(field)).split()[1]) / 1024

    def pictures(self):
        try:
            lines = (self.folder / "fps").read_text().splitlines()[1:]
            return sum(int(line.split(",")[3]) for line in lines if line.count(",") >= 4)
        except (OSError, ValueError):
            return 0

    def span(self, name, act):
        pictures, processor, begin, step = self.pictures(), self.processor_s(), time.time(), 0
        while time.time() - begin < SPAN_S:
            act(step)
            step += 1
            time.sleep(0.02)
        time.sleep(0.3)
        pictures = self.pictures() - pictures
        processor, wall = self.processor_s() - processor, time.time() - begin
        each = 1000 * processor / max(pictures, 1)
        print(f"{name:<28}{pictures / wall:6.1f} pictures/s {each:7.0f} ms of processor a picture", flush=True)

    # What a user does.

    def over_table(self, step):
        self.do("mousemove", 120, 150 + (step * 24) % (self.height * 2 // 5))

    def turn(self, step):
        self.do("mousemove", self.width * 45 // 100 + (step * 7) % 200, self.height // 2 + (step * 3) % 60)

    def press_in_scene(self):
        self.do("mousemove", self.width * 45 // 100, self.height // 2, "mousedown", 1)

    def command(self, name):
        """By the palette, whose first entry it is."""
        self.do("key", "ctrl+k")
        time.sleep(1)
        self.do("type", name)
        time.sleep(1)
        self.do("key", "Return")
        time.sleep(1)


def rates(window):
    window.span("pointer over the table", window.over_table)
    window.press_in_scene()
    window.span("turning", window.turn)
    window.do("mouseup", 1)
    window.do("key", "space")
    time.sleep(2)
    before = window.resident_mb()
    window.span("playing", lambda step: None)
    window.command("All frames")
    window.span("playing, all frames", lambda step: None)
    print(f"resident memory              {before:.0f} MB before, {window.resident_mb():.0f} MB after", flush=True)


def soak(window, minutes):
    begin, reference, step = time.time(), None, 0
    reference_s = min(300, minutes * 10)
    next_s = 0
    window.do("mousemove", 120, 200, "click", 1, "key", "space")
    while (elapsed := time.time() - begin) < minutes * 60:
        if reference is None and elapsed >= reference_s:
            reference = window.resident_mb()
        if elapsed >= next_s:
            print(f"{elapsed / 60:5.1f} min {window.resident_mb():6.0f} MB", flush=True)
            next_s += 30
        if step % 40 == 0:
            window.do("mousemove", 120, 150 + (step * 24) % (window.height * 2 // 5), "click", 1)
        elif step % 40 == 20:
            window.press_in_scene()
        elif step % 40 == 39:
            window.do("mouseup", 1)
        elif step % 40 > 20:
            window.turn(step)
        step += 1
        time.sleep(0.1)
    last = window.resident_mb()
    print(f"at the end {last:.0f} MB, {last / reference:.2f} times that after {reference_s / 60:.1f} minutes")
    return last <= 1.1 * reference


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", default="1600x1000")
    parser.add_argument("--settle", type=float, default=20, help="seconds until analyses are done")
    parser.add_argument("--soak", type=float, help="minutes")
    parser.add_argument("program")
    parser.add_argument("files", nargs="*")
    options = parser.parse_args()
    size = tuple(map(int, options.size.split("x")))
    with tempfile.TemporaryDirectory() as folder:
        layer = f"no_display,fps,frame,output_file={folder}/fps,fps_sampling_period=250"
        env = {"VK_INSTANCE_LAYERS": "VK_LAYER_MESA_overlay", "VK_LAYER_MESA_OVERLAY_CONFIG": layer}
        window = Window(folder, size, [options.program, *options.files], env)
        with contextlib.closing(window):
            time.sleep(options.settle)
            if options.soak:
                sys.exit(0 if soak(window, options.soak) else 1)
            rates(window)


if __name__ == "__main__":
    main()
