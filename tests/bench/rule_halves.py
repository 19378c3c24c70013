#!/usr/bin/env python3
"""Rules learnt on a random half of a study and applied to the other half: `rule_halves.py PROGRAM STUDY.toml [SPLITS] [SEED]`.

Halves are drawn within each label. For each split `learn` on one half writes a rule and `analyze --rule` applies it to the
other; printed are the AUC of "abnormal?", false positives and negatives, and the share of subjects whose most probable label
is their own, of those with a label that the study calls normal or abnormal; then mean and spread over all splits.
"""
import csv
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import tomllib


def half(study, folder, chosen):
    """A study file of the chosen subjects beside links to their folders."""
    folder.mkdir()
    source = study.parent.resolve()
    text = study.read_text()
    head, *subjects = text.split("[[subject]]")
    kept = [part for part in subjects if tomllib.loads(part)["id"] in chosen]
    for entry in source.iterdir():
        if entry.is_dir():
            (folder / entry.name).symlink_to(entry)
    (folder / "study.toml").write_text("[[subject]]".join([head, *kept]))
    return folder / "study.toml"


def auc(scores, positive):
    pairs = [(a, b) for a, p in zip(scores, positive) if p for b, q in zip(scores, positive) if not q]
    return sum((a > b) + 0.5 * (a == b) for a, b in pairs) / len(pairs)


def split(program, study, subjects, roles, seed):
    drawn = random.Random(seed)
    chosen = set()
    for label in sorted({subject["label"] for subject in subjects}):
        own = sorted(subject["id"] for subject in subjects if subject["label"] == label)
        chosen |= set(drawn.sample(own, len(own) // 2))
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        train = half(study, place / "train", chosen)
        test = half(study, place / "test", {subject["id"] for subject in subjects} - chosen)
        run = lambda *words: subprocess.run([program, *map(str, words)], check=True, capture_output=True)
        run("learn", train, "--out", place / "rule.json", "--follow-links")
        options = ["--figures", "off", "--distances", "none", "--follow-links", "--rule", place / "rule.json"]
        run("analyze", test, "--out", place / "out", *options)
        rows = list(csv.DictReader(open(place / "out" / "verdicts.csv", newline="")))
    rows = [row for row in rows if row["label"] in roles and row["probability"]]
    ill = [roles[row["label"]] for row in rows]
    called = [row["verdict"] == "abnormal" for row in rows]
    return {
        "AUC": auc([float(row["probability"]) for row in rows], ill),
        "false positives": sum(c and not i for c, i in zip(called, ill)),
        "false negatives": sum(i and not c for c, i in zip(called, ill)),
        "kind accuracy": sum(row["kind"] == row["label"] for row in rows) / len(rows),
    }


def main():
    program, study = sys.argv[1], pathlib.Path(sys.argv[2])
    splits, seed = [int(word) for word in sys.argv[3:5]] + [10, 1][len(sys.argv[3:5]) :]
    whole = tomllib.loads(study.read_text())
    roles = {label: False for label in whole["normal"]} | {label: True for label in whole["abnormal"]}
    found = []
    for number in range(splits):
        found.append(split(program, study, whole["subject"], roles, f"{seed} {number}"))
        print(number, *(f"{name} {value:.3f}" for name, value in found[-1].items()), sep="  ", flush=True)
    for name in found[0]:
        values = [one[name] for one in found]
        print(f"{name}: mean {statistics.mean(values):.3f}, SD {statistics.stdev(values):.3f}, least {min(values):.3f}, most {max(values):.3f}")


if __name__ == "__main__":
    main()
