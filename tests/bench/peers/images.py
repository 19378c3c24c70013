"""The work of the bench `images` by SciPy, scikit-image and pydicom, beside criterion's medians.

The enclosed volume of a surface and the mean way of points are printed, and are to equal those that the bench prints.
"""

import glob
import io
import json
import os
import sys
import tempfile
import zipfile

import numpy as np
import pydicom
from scipy.interpolate import RBFInterpolator
from scipy.ndimage import gaussian_filter
from skimage.measure import marching_cubes

from peers import icosphere, seconds

SIZE, GATES, SPACING_MM, THRESHOLD = (128, 128, 47), 8, 3.0, 60.0


def noise(seed, count):
    """The bench's linear congruential numbers: state n is aⁿ s + c (aⁿ⁻¹ + … + 1), modulo 2⁶⁴."""
    factor, step = np.uint64(6364136223846793005), np.uint64(1442695040888963407)
    powers = np.multiply.accumulate(np.full(count, factor))
    sums = np.add.accumulate(np.concatenate([[np.uint64(1)], powers[:-1]]))
    states = powers * np.uint64(seed) + step * sums
    return 30.0 * ((states >> np.uint64(40)).astype(float) / (1 << 24))


def gate(number):
    """The bench's volume, z first."""
    z, y, x = np.meshgrid(*(np.arange(n) for n in SIZE[::-1]), indexing="ij")
    x, y, z = x - 64.0, y - 60.0, z - 23.0
    away = np.sqrt(x * x + 1.21 * y * y + 0.49 * z * z) - (14.0 - np.sin(number * 0.785))
    wall = np.where(z > 14.0, 0.0, 100.0 * np.exp(-away * away / 8.0))
    liver = (x + 30.0) ** 2 + (y - 35.0) ** 2 + (z + 5.0) ** 2 < 18.0**2
    values = wall + np.where(liver, 80.0, 0.0) + noise(12345 + number, wall.size).reshape(wall.shape)
    return values.astype(np.float32)


def surface(values):
    blurred = gaussian_filter(values, 1.0, mode="reflect")
    return marching_cubes(blurred, THRESHOLD, spacing=(SPACING_MM,) * 3)[:2]


def enclosed_ml(vertices, faces):
    a, b, c = (vertices[faces[:, k]].astype(float) for k in range(3))
    return abs((a * np.cross(b, c)).sum() / 6e3)


def landmarks():
    number = np.arange(16)
    z = 1 - (2 * number + 1) / 16
    angle, around = number * np.pi * (3 - 5**0.5), np.sqrt(1 - z * z)
    return 40.0 * np.stack([around * np.cos(angle), around * np.sin(angle), z], 1)


def bent(p):
    return np.stack([p[:, 0] + 3 * np.sin(0.1 * p[:, 1]), p[:, 1], 1.1 * p[:, 2]], 1)


def opened(paths):
    """What a stack needs: numbers, place and time of every image, slices in order, one array."""
    images = {}
    for path in paths:
        file = pydicom.dcmread(path)
        normal = np.cross(file.ImageOrientationPatient[:3], file.ImageOrientationPatient[3:])
        along = round(float(np.dot(normal, file.ImagePositionPatient)), 3)
        images.setdefault(along, []).append((float(file.TriggerTime), file.pixel_array))
    stack = [[pixels for _, pixels in sorted(images[along], key=lambda image: image[0])] for along in sorted(images)]
    return np.asarray(stack, np.float32)


def main(criterion, begun_s, archives):
    def ours(name):
        path = os.path.join(criterion, name, "new", "estimates.json")
        if os.path.getmtime(path) < begun_s:
            sys.exit(f"{name} was not measured in this run")
        with open(path, encoding="utf-8") as file:
            return json.load(file)["median"]["point_estimate"] * 1e-9

    gates = [gate(number) for number in range(GATES)]
    print(f"scikit-image: isosurface of the first gate: {enclosed_ml(*surface(gates[0])):.2f} ml")
    rows = [
        ("blur of 8 gates of 128 × 128 × 47", ours("blur_8_gates"),
         seconds(lambda: [gaussian_filter(values, 1.0, mode="reflect") for values in gates], 5), "SciPy"),
        ("the same and isosurfaces", ours("blur_and_isosurface_8_gates"),
         seconds(lambda: [surface(values) for values in gates], 5), "SciPy, scikit-image"),
    ]
    points, marks = 40.0 * icosphere(6)[0], landmarks()

    def moved():
        # The thin plate in three dimensions: its kernel is r.
        return RBFInterpolator(marks, bent(marks), kernel="linear", degree=1)(points)

    print(f"SciPy: thin-plate spline: points are moved by {np.linalg.norm(moved() - points, axis=1).mean():.9f} mm on average")
    rows.append(("thin-plate spline, 16 landmarks, 40962 points", ours("thin_plate_spline_16_landmarks_40962_points"),
                 seconds(moved, 21), "SciPy"))
    with tempfile.TemporaryDirectory() as folder:
        for number, archive in enumerate(sorted(glob.glob(os.path.join(archives, "*.zip")))):
            with open(archive, "rb") as file:
                zipfile.ZipFile(io.BytesIO(file.read())).extractall(os.path.join(folder, str(number)))
        paths = glob.glob(os.path.join(folder, "**", "*.dcm"), recursive=True)
        if len(paths) == 150:
            print(f"pydicom: one array of {' × '.join(map(str, opened(paths).shape))}")
            rows.append(("opening 150 DICOM files", ours("open_150_dicom_files"), seconds(lambda: opened(paths), 5),
                         "pydicom"))
        else:
            print(f"skipped: {archives} does not hold 150 DICOM files")
    print(f"{'work':46} {'ours':>13} {'peer':>13} {'ours : peer':>12}  peer")
    for name, our, peer, who in rows:
        print(f"{name:46} {our * 1e3:10.3f} ms {peer * 1e3:10.3f} ms {'1 : %.1f' % (peer / our):>12}  {who}")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
