#!/usr/bin/env python3
"""Small inputs that ask for much: each is made here, given to the program, and timed.

usage: attacks.py [--keep DIR] [--only TEXT] [--first N] [--cohort] BINARY

Prints a line for each input: processor time, time on the clock, greatest resident memory, exit code, and the first
line of what the program said of it. `--cohort` adds 300 subjects of 8 frames (`analyze`, minutes), `--keep` leaves the
inputs in DIR. Exits with 1 if one took more than 2 s of processor time or 1 GB, or ended by a signal.
"""
import argparse
import base64
import os
import re
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib

MOST_SECONDS, MOST_MB, LIMIT_MB = 2.0, 1000, 6000
MILLION = 1_000_000


def write(path, content):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb" if isinstance(content, bytes) else "w") as file:
        file.write(content)


def circle(count):
    """OBJ points around a vertex, the first."""
    yield "v 0 0 10\n"
    for k in range(count - 1):
        yield f"v {40 + k % 7} {k / count:.6f} {k % 11}\n"


def fan(folder):
    faces = (f"f 1 {k} {k + 1}\n" for k in range(2, MILLION + 2))
    write(f"{folder}/endo_0.obj", "".join(circle(MILLION + 2)) + "".join(faces))


def strip(folder):
    head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n"
    points = "".join(f"{k % 2} {k * 1e-4:.4f} {k % 3}\n" for k in range(MILLION))
    corners = " ".join(map(str, range(MILLION)))
    write(f"{folder}/endo_0.vtk", f"{head}POINTS {MILLION} float\n{points}TRIANGLE_STRIPS 1 {MILLION + 1}\n{MILLION} {corners}\n")


def polygon(folder):
    corners = " ".join(map(str, range(1, MILLION + 1)))
    write(f"{folder}/endo_0.obj", "".join(circle(MILLION)) + f"f {corners}\n")


def polygon_ply(folder):
    head = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {MILLION}\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list int int vertex_index\nend_header\n"
    )
    points = b"".join(struct.pack("<3f", k % 7, k % 11, k % 13) for k in range(MILLION))
    write(f"{folder}/endo_0.ply", head.encode() + points + struct.pack(f"<{MILLION + 1}i", MILLION, *range(MILLION)))


def small_obj():
    return "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"


def manifest(folder, subjects, one):
    write(f"{folder}/endo_0.obj", small_obj())
    write(f"{folder}/study.toml", "name = \"many\"\n" + "".join(one(k) for k in range(subjects)))


def subjects_100_000(folder):
    manifest(folder, 100_000, lambda k: f"[[subject]]\nid = \"p{k}\"\nendo = \"endo_0.obj\"\n")


def subjects_20_000(folder):
    manifest(folder, 20_000, lambda k: f"[[subject]]\nid = \"p{k}\"\nendo = \"endo_0.obj\"\n")


def subjects_of_one_id(folder):
    manifest(folder, 20_000, lambda k: "[[subject]]\nid = \"p\"\nlabel = \"L%d\"\nendo = \"endo_0.obj\"\n" % k)


def patterns(folder):
    wide = "".join(f"[[subject]]\nid = \"p{k}\"\nendo = \"/**/nothing_{k}.obj\"\n" for k in range(50))
    write(f"{folder}/study.toml", wide)


def stars(folder):
    for k in range(2_000):
        write(f"{folder}/{'a' * 200}{k}.obj", "")
    write(f"{folder}/study.toml", "".join(
        f"[[subject]]\nid = \"p{k}\"\nendo = \"{'*a' * 90}*{k}b.obj\"\n" for k in range(200)))


def link_to_root(folder):
    write(f"{folder}/a/endo_0.obj", small_obj())
    os.symlink("/", f"{folder}/everything")


def pipes(folder):
    write(f"{folder}/a/endo_0.obj", small_obj())
    os.mkfifo(f"{folder}/a/endo_1.obj")
    os.mkfifo(f"{folder}/study.toml")


def attributes(folder):
    many = " ".join(f'a{k}=""' for k in range(60_000))
    write(f"{folder}/heart.pvd", f"<VTKFile type=\"Collection\"><Collection><DataSet {many}/></Collection></VTKFile>")
    write(f"{folder}/endo_0.vtp", f"<VTKFile type=\"PolyData\" {many}><PolyData/></VTKFile>")


def packed_vtp(points, size):
    """A VTP of zeros whose packed bytes are padded to a size with points that do not pack."""
    block = 32768
    raw = bytes(24 * points)
    blocks = [raw[k:k + block] for k in range(0, len(raw), block)]
    packed = [zlib.compress(part, 9) for part in blocks]
    head = struct.pack(f"<{3 + len(blocks)}I", len(blocks), block, len(raw) % block, *map(len, packed))
    xml = (
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
        f"compressor=\"vtkZLibDataCompressor\"><PolyData><Piece NumberOfPoints=\"{points}\" NumberOfPolys=\"0\">"
        "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points>"
        "</Piece></PolyData><AppendedData encoding=\"raw\">_"
    )
    body = head + b"".join(packed)
    return xml.encode() + body + bytes(max(0, size - len(body))) + b"</AppendedData></VTKFile>"


def bombs(folder):
    content = packed_vtp(5_000_000, 80_000)
    for k in range(40):
        write(f"{folder}/p{k}/endo_0.vtp", content)


def bombs_within_the_factor(folder):
    """What one file may unpack to, in many files."""
    content = packed_vtp(1_000_000, 800_000)
    for k in range(200):
        write(f"{folder}/p{k}/endo_0.vtp", content)


def gltf(nodes, buffers, positions, triangles=0):
    faces = ",\"indices\":1" if triangles else ""
    indices = f",{{\"bufferView\":1,\"componentType\":5125,\"count\":{3 * triangles},\"type\":\"SCALAR\"}}" if triangles else ""
    view = f",{{\"buffer\":0,\"byteOffset\":{12 * positions},\"byteLength\":{12 * triangles}}}" if triangles else ""
    return (
        f"{{\"asset\":{{\"version\":\"2.0\"}},\"nodes\":[{nodes}],\"buffers\":[{buffers}],"
        f"\"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}{faces}}}]}}],"
        f"\"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{positions},\"type\":\"VEC3\"}}{indices}],"
        f"\"bufferViews\":[{{\"buffer\":0,\"byteLength\":{12 * positions}}}{view}]}}"
    )


def three_points():
    return struct.pack("<9f", 0, 0, 0, 9, 0, 0, 0, 9, 0)


def instances_300_000(folder):
    data = base64.b64encode(three_points()).decode()
    buffer = f"{{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,{data}\"}}"
    write(f"{folder}/wall.gltf", gltf(",".join(["{\"mesh\":0}"] * 300_000), buffer, 3))


def instances_1_000(folder, triangles=5_300, points=2_652):
    data = b"".join(struct.pack("<3f", k % 7, k * 0.01, k % 3) for k in range(points))
    corners = [(k % points, (k + 1) % points, (k + 2 + k // points) % points) for k in range(triangles)]
    data += b"".join(struct.pack("<3I", *three) for three in corners)
    write(f"{folder}/wall.bin", data)
    buffer = f"{{\"byteLength\":{len(data)},\"uri\":\"wall.bin\"}}"
    write(f"{folder}/wall.gltf", gltf(",".join(["{\"mesh\":0}"] * 1_000), buffer, points, triangles))


def instances_of_all_faces(folder):
    instances_1_000(folder, 9_900, 4_950)


def one_file_1_000_times(folder):
    write(f"{folder}/wall.bin", three_points() + bytes(1_500_000))
    buffer = "{\"byteLength\":1500036,\"uri\":\"wall.bin\"}"
    write(f"{folder}/wall.gltf", gltf("{\"mesh\":0}", ",".join([buffer] * 1_000), 3))


def deep_folders(folder):
    place = folder
    for k in range(100):
        place = f"{place}/d{k}"
    write(f"{place}/endo_0.obj", small_obj())


def endless_line(folder):
    write(f"{folder}/endo_0.obj", "v 0 0 0 " + "1" * 30_000_000 + "\n")
    write(f"{folder}/epi_0.stl", "solid " + "x" * 30_000_000)


def two_part_vertices(folder):
    """A million triangles that share no vertex, all in one place."""
    write(f"{folder}/endo_0.stl", b"\0" * 80 + struct.pack("<I", MILLION)
          + struct.pack("<12fH", 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 9, 0, 0) * MILLION)


def scattered_triangles(folder):
    """A million triangles that share no vertex, in a million places: a million parts."""
    triangles = b"".join(
        struct.pack("<12fH", 0, 0, 0, k, 0, 0, k + 0.5, 0, 0, k, 0.5, 0, 0) for k in range(MILLION))
    write(f"{folder}/endo_0.stl", b"\0" * 80 + struct.pack("<I", MILLION) + triangles)


def table_of_numbers(folder):
    write(f"{folder}/endo_0.csv", "v,0,0,0\n" * 2_000_000)


def toml_nested(folder):
    write(f"{folder}/study.toml", "a = " + "[" * 200_000)


def json_nested(folder):
    write(f"{folder}/wall.gltf", "{\"asset\":" + "[" * 1_000_000)


def files_100_000(folder):
    for k in range(100_000):
        write(f"{folder}/endo_{k}.obj", "")


def names_that_nearly_agree(folder):
    for k in range(5_000):
        write(f"{folder}/endo_{k}.obj", small_obj())
        write(f"{folder}/endo_{k} (1).obj", small_obj())


ATTACKS = [
    ("fan of 10⁶ triangles around a vertex", fan),
    ("strip of 10⁶ corners", strip),
    ("polygon of 10⁶ corners, OBJ", polygon),
    ("polygon of 10⁶ corners, PLY", polygon_ply),
    ("study.toml of 100,000 subjects", subjects_100_000),
    ("study.toml of 20,000 subjects of one file", subjects_20_000),
    ("study.toml of 20,000 subjects of one id", subjects_of_one_id),
    ("50 patterns /**", patterns),
    ("200 patterns of 90 stars, 2,000 long names", stars),
    ("link to /", link_to_root),
    ("link to /, --follow-links", link_to_root, "--follow-links"),
    ("pipes as a mesh and as study.toml", pipes),
    ("60,000 XML attributes", attributes),
    ("40 VTP of 80 KB that unpack to 4.8 GB", bombs),
    ("200 VTP of 0.8 MB that unpack to 4.8 GB", bombs_within_the_factor),
    ("glTF that names one file 1,000 times", one_file_1_000_times),
    ("glTF of 300,000 instances", instances_300_000),
    ("glTF of 1,000 instances of 15,900 corners", instances_1_000),
    ("glTF of 1,000 instances of 29,700 corners", instances_of_all_faces),
    ("100 folders in each other", deep_folders),
    ("lines of 30 MB", endless_line),
    ("10⁶ triangles in one place", two_part_vertices),
    ("10⁶ triangles apart", scattered_triangles),
    ("CSV of 2·10⁶ points", table_of_numbers),
    ("TOML of 200,000 brackets", toml_nested),
    ("JSON of 10⁶ brackets", json_nested),
    ("100,000 empty frames", files_100_000),
    ("5,000 frames and their copies", names_that_nearly_agree),
]


def run(command, limit=120):
    """Seconds of processor and of the clock, MB, exit code and the output of a command."""
    out = tempfile.TemporaryFile()
    start = time.monotonic()
    # A program that takes all memory would end others, too.
    bound = lambda: resource.setrlimit(resource.RLIMIT_AS, (LIMIT_MB << 20, LIMIT_MB << 20))
    child = subprocess.Popen(
        command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, preexec_fn=bound)
    deadline = start + limit
    while True:
        pid, status, used = os.wait4(child.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() > deadline:
            child.kill()
            pid, status, used = os.wait4(child.pid, 0)
            break
        time.sleep(0.01)
    child.returncode = os.waitstatus_to_exitcode(status)
    clock = time.monotonic() - start
    out.seek(0)
    text = out.read().decode("utf-8", "replace")
    return used.ru_utime + used.ru_stime, clock, used.ru_maxrss / 1024, child.returncode, text


def first_line(text, folder):
    """What was said of the input: the first error or warning, else the last line."""
    lines = [line.strip().replace(folder, "") for line in text.splitlines() if line.strip()]
    telling = [line for line in lines if re.search(r"cardiomorph: |error|warning|limit|left out|not followed", line)]
    line = (telling or lines[-1:] or [""])[0]
    return line if len(line) <= 150 else line[:147] + "…"


def cohort(binary, folder, keep):
    """300 subjects of 8 frames: the built-in cohort thirteen times, each a little larger than the last."""
    subprocess.run([binary, "demo", "--out", f"{folder}/one"], check=True, capture_output=True)
    blocks = open(f"{folder}/one/study.toml").read().split("[[subject]]")
    head, subjects = blocks[0], blocks[1:]
    text = head
    for k in range(300):
        block = subjects[k % len(subjects)]
        name = re.search(r'id = "([^"]+)"', block).group(1)
        block = block.replace(f'"{name}', f'"{name}_{k}')
        for entry in sorted(os.listdir(f"{folder}/one/{name}")):
            scale_ply(f"{folder}/one/{name}/{entry}", f"{folder}/many/{name}_{k}/{entry}", 1 + 1e-4 * k)
        text += "[[subject]]" + block
    write(f"{folder}/many/study.toml", text)
    return [binary, "analyze", f"{folder}/many", "--out", f"{folder}/out", "--figures", "off"]


def scale_ply(source, target, factor):
    bytes_ = open(source, "rb").read()
    end = bytes_.index(b"end_header\n") + len(b"end_header\n")
    head = bytes_[:end].decode()
    count = int(re.search(r"element vertex (\d+)", head).group(1))
    kind = "d" if "double x" in head else "f"
    size = struct.calcsize(kind) * 3 * count
    points = struct.unpack(f"<{3 * count}{kind}", bytes_[end:end + size])
    write(target, bytes_[:end] + struct.pack(f"<{3 * count}{kind}", *(x * factor for x in points)) + bytes_[end + size:])


def main():
    parser = argparse.ArgumentParser(usage=__doc__.splitlines()[2].removeprefix("usage: "))
    parser.add_argument("--keep")
    parser.add_argument("--only", default="")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--cohort", action="store_true")
    parser.add_argument("binary")
    options = parser.parse_args()
    root = options.keep or tempfile.mkdtemp()
    print("| input | command | processor | clock | memory | exit | what was said |\n|---|---|---|---|---|---|---|")
    bad = False
    try:
        for number, (name, make, *arguments) in enumerate(ATTACKS):
            if options.only not in name or number < options.first:
                continue
            folder = f"{root}/{number:02}"
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder)
            make(folder)
            bad |= not report(name, "info", [options.binary, "info", folder, *arguments], folder)
            if not options.keep:
                shutil.rmtree(folder)
        if options.cohort:
            command = cohort(options.binary, root, options.keep)
            report("300 subjects of 8 frames", "analyze", command, root)
    finally:
        if not options.keep:
            shutil.rmtree(root, ignore_errors=True)
    sys.exit(1 if bad else 0)


def report(name, verb, command, folder):
    processor, clock, memory, code, text = run(command)
    kept = processor <= MOST_SECONDS and memory <= MOST_MB and code >= 0
    mark = "" if kept or verb == "analyze" else " (!)"
    print(f"| {name} | {verb} | {processor:.2f} s{mark} | {clock:.2f} s | {memory:.0f} MB | {code} | {first_line(text, folder)} |", flush=True)
    return kept


if __name__ == "__main__":
    main()
