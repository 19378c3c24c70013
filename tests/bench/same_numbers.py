#!/usr/bin/env python3
"""Whether two programs write the same numbers: `same_numbers.py OLD NEW STUDY...` (a STUDY `demo` is the built-in cohort).

Runs `analyze --figures off` and `measure` of both on every study and compares all tables cell by cell and `summary.json`
value by value. Columns and keys that only NEW has, and texts that differ, are listed; a number that differs, or a table
or column that is gone, makes the exit code 1.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def tables(old, new, problems, texts):
    rows = [list(csv.reader(open(path, newline=""))) for path in (old, new)]
    (head_old, *old_rows), (head_new, *new_rows) = rows
    if head_new[: len(head_old)] != head_old:
        problems.append(f"{old.name}: columns {head_old} became {head_new}")
    if head_new[len(head_old) :]:
        texts.add(f"{old.name}: new columns {head_new[len(head_old):]}")
    if len(old_rows) != len(new_rows):
        problems.append(f"{old.name}: {len(old_rows)} rows became {len(new_rows)}")
    for line, (a, b) in enumerate(zip(old_rows, new_rows), 2):
        for key, was, now in zip(head_old, a, b):
            if was != now:
                if number(was) is None and number(now) is None:
                    texts.add(f"{old.name}: {key}: {was!r} became {now!r}"[:300])
                else:
                    problems.append(f"{old.name}, line {line}, {key}: {was} became {now}")


def values(old, new, place, problems, texts):
    if isinstance(old, dict) and isinstance(new, dict):
        for key in old:
            if key not in new:
                problems.append(f"{place}/{key} is gone")
            else:
                values(old[key], new[key], f"{place}/{key}", problems, texts)
        texts.update(f"{place}/{key} is new" for key in new if key not in old)
    elif isinstance(old, list) and isinstance(new, list) and place != "/files":
        if len(old) != len(new):
            problems.append(f"{place}: {len(old)} entries became {len(new)}")
        for index, (a, b) in enumerate(zip(old, new)):
            values(a, b, f"{place}[{index}]", problems, texts)
    elif old != new:
        is_text = isinstance(old, (str, list)) and isinstance(new, (str, list))
        message = f"{place}: {old!r} became {new!r}"[:300]
        (texts.add if is_text else problems.append)(message)


def written(program, study, folder):
    if study == "demo":
        study = str(folder / "demo")
        subprocess.run([program, "demo", "--out", study], check=True, capture_output=True)
    for command in (["analyze", "--figures", "off"], ["measure"]):
        out = str(folder / command[0])
        subprocess.run([program, command[0], study, *command[1:], "--out", out], check=True, capture_output=True)


def main():
    old, new, *studies = sys.argv[1:]
    failed = False
    for study in studies:
        with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
            folders = [pathlib.Path(a), pathlib.Path(b)]
            for program, folder in zip((old, new), folders):
                written(program, study, folder)
            problems, texts, count = [], set(), 0
            for path in sorted(folders[0].glob("*/*.csv")):
                other = folders[1] / path.relative_to(folders[0])
                count += 1
                if not other.exists():
                    problems.append(f"{path.name} is gone")
                else:
                    tables(path, other, problems, texts)
            summaries = [json.load(open(folder / "analyze" / "summary.json")) for folder in folders]
            values(*summaries, "", problems, texts)
            name = pathlib.Path(study).name
            print(f"{name}: {count} tables and the summary, {len(problems)} differences of numbers, {len(texts)} of texts")
            for line in problems[:20] + sorted(texts)[:20]:
                print(f"  {line}")
            failed |= bool(problems)
    sys.exit(failed)


if __name__ == "__main__":
    main()
