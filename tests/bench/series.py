#!/usr/bin/python3
"""Keeps figures of speed from commit to commit, so that a small loss shows:
    tests/bench/series.py [BUILD]     measures with the programs of BUILD/bin, by default build/dev
It appends to series.csv, draws series.svg, and names each figure that is 5 % worse than before on such a CPU. Each
figure is a ratio of two times of one run, since machines differ and are noisy; lower is better.
"""
import csv
import datetime
import statistics
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SERIES = HERE / "series.csv"
SUN_AND_LAMP = str(HERE.parent / "stability" / "scenes" / "sun_and_lamp.xml")
FIELDS = ["date", "commit", "cpu", "figure", "value"]
ROUNDS = 3
LOSS = 0.05
KEPT = 5  # the last runs that a new one is compared with

# Name, program and arguments, the first words of the row, and the column of the figure counted from the end.
FIGURES = [
    ("paths / Embree, diffuse", ["trace_speed", "cornell-box"], "cornell-box avx2", -4),
    ("paths / Embree, textures", ["trace_speed", "textured-cornell-box"], "textured-cornell-box avx2", -4),
    ("baked frame / its rays", ["converged_speed", "cornell-bunny"], "cornell-bunny", -1),
    ("baked frame with penumbras / its rays", ["converged_speed", SUN_AND_LAMP], "sun_and_lamp", -1),
    ("64 sensors and their frame / frame", ["event_speed"], "accumulating kalman 0.20", -1),
    ("noise of a preset, % of a frame", ["noise_speed"], "preset davis346", -1),
]


def column(table, row, index):
    """The number in a row of a table that a program has printed."""
    for line in table.splitlines():
        words = line.split()
        if " ".join(words).startswith(row + " "):
            return float(words[index])
    raise ValueError(f"no row begins with '{row}' in:\n{table}")


def measure(build):
    """The median of some rounds, by figure."""
    values = {}
    for _ in range(ROUNDS):
        for name, command, row, index in FIGURES:
            print(f"{name} ...", file=sys.stderr)
            table = subprocess.run([f"{build}/bin/{command[0]}", *command[1:]], check=True, capture_output=True, text=True)
            values.setdefault(name, []).append(column(table.stdout, row, index))
    return {name: statistics.median(of) for name, of in values.items()}


def losses(rows, cpu, values):
    """Lines about the figures that are worse than the median of the last runs on this CPU."""
    for name, value in values.items():
        before = [float(r["value"]) for r in rows if r["cpu"] == cpu and r["figure"] == name][-KEPT:]
        if before and value > (1 + LOSS) * statistics.median(before):
            yield f"{name}: {value:.3f}, {100 * (value / statistics.median(before) - 1):.0f} % worse than before"


def picture(rows):
    """An SVG with a small chart for each figure: its values over those of the first run, run by run."""
    width, height, text = 560, 90, 'font-family="sans-serif" font-size="12"'
    names = list(dict.fromkeys(r["figure"] for r in rows))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height * len(names)}" {text}>',
             '<rect width="100%" height="100%" fill="white"/>']
    for i, name in enumerate(names):
        values = [float(r["value"]) for r in rows if r["figure"] == name]
        top, middle = i * height, i * height + 55
        scale = max(2 * LOSS, *(abs(v / values[0] - 1) for v in values))
        points = [(10 + (width - 20) * k / max(1, len(values) - 1), middle - 30 * (v / values[0] - 1) / scale)
                  for k, v in enumerate(values)]
        band = 30 * LOSS / scale
        parts += [f'<text x="10" y="{top + 16}">{name}: {values[-1]:.3f}</text>',
                  f'<rect x="10" y="{middle - band:.1f}" width="{width - 20}" height="{2 * band:.1f}" fill="#e8eef4"/>',
                  '<polyline fill="none" stroke="#1f5f99" stroke-width="1.5" points="'
                  + " ".join(f"{x:.1f},{y:.1f}" for x, y in points) + '"/>']
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="#1f5f99"/>' for x, y in points]
    return "\n".join([*parts, "</svg>", ""])


def cpu_name():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return "unknown"


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else HERE.parents[1] / "build/dev"
    rows = list(csv.DictReader(SERIES.open())) if SERIES.exists() else []
    values = measure(build)
    commit = subprocess.run(["git", "-C", HERE, "rev-parse", "--short", "HEAD"], check=True, capture_output=True, text=True)
    worse = list(losses(rows, cpu_name(), values))
    rows += [dict(zip(FIELDS, [datetime.date.today().isoformat(), commit.stdout.strip(), cpu_name(), name, f"{value:.4g}"]))
             for name, value in values.items()]
    with SERIES.open("w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    SERIES.with_suffix(".svg").write_text(picture(rows))
    print("\n".join(worse) or "no figure is 5 % worse than before")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
