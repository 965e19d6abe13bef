#!/usr/bin/env python3
"""Times everything against its floor. Leaves benchmarks.json (in Google Benchmark's form) and table.md in the folder; each
row says how many times its floor it takes. --compare holds two builds against each other in interleaved runs."""

import argparse
import contextlib
import json
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAMS = {
    "floor_benchmarks": "engine",
    "engine_benchmarks": "engine",
    "sparse_factor_benchmarks": "engine",
    "cutting_benchmarks": "engine",
    "cut_body_benchmarks": "engine",
    "growth_benchmarks": "engine",
    "hand_path_benchmarks": "engine",
    "renderer_benchmarks": "renderer",
    "metric_benchmarks": "renderer",
}
# Pages as the program asks for where it runs scenes and draws, see studio/commands/main.cpp.
PAGES = {"GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"}
MEMORY = {"renderer_benchmarks": PAGES, "cut_body_benchmarks": PAGES}
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
# A step cannot take less than one evaluation and one factorisation of its size.
STEP_PARTS = {"PalpationStep": ("Evaluate", "Factorize")}
SCENE = "scenes/palpation_hemisphere.yaml"
INCISION = "tests/benchmarks/scenes/incision_gallbladder_5000.yaml"
HAPTIC = "scenes/haptic_hemisphere.yaml"
HAPTIC_CASES = [(64, "full"), (256, "full"), (1024, "full"), (2500, "full"), (2500, "local"), (10000, "local"), (20000, "local")]


def run_program(build, program, options, extra=()):
    path = Path(build) / "tests/benchmarks" / PROGRAMS[program] / program
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        arguments = [str(path), f"--benchmark_out={file.name}", "--benchmark_out_format=json", *extra]
        if options.filter:
            arguments.append(f"--benchmark_filter={options.filter}")
        if options.quick:
            arguments.append("--benchmark_min_time=0.05")
        done = subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              env={**os.environ, **MEMORY.get(program, {})})
        text = Path(file.name).read_text()
    if done.returncode != 0:
        sys.exit(f"scripts/bench: {program} failed: {done.stderr.strip()[-500:]}")
    if not text.strip():  # the filter leaves nothing of this program
        return {"context": {}, "benchmarks": []}
    return json.loads(text)


def seconds(row):
    return row["real_time"] * UNITS[row["time_unit"]]


def floors_of(rows):
    """Bytes and operations per second of this machine, and times by name."""
    found = {row["name"]: row for row in rows if not row.get("error_occurred")}
    rates = {}
    if "MemoryBandwidth" in found:
        rates["bytes"] = found["MemoryBandwidth"]["bytes"] / seconds(found["MemoryBandwidth"])
    if "PeakOperations" in found:
        rates["operations"] = found["PeakOperations"]["operations"] / seconds(found["PeakOperations"])
    return rates, {name: seconds(row) for name, row in found.items()}


def floor_of(row, rates, times):
    """Seconds that the machine would take at best, and why; nothing where no floor is known."""
    name = row["name"].split("/")[0]
    if name in ("MemoryBandwidth", "PeakOperations", "nothing"):
        return None
    for key, words in (("bytes", "memory bandwidth"), ("operations", "peak operations")):
        if key in row and key in rates:
            return row[key] / rates[key], words
    size = row["name"][len(name):]
    if name in STEP_PARTS and all(part + size in times for part in STEP_PARTS[name]):
        return sum(times[part + size] for part in STEP_PARTS[name]), " + ".join(STEP_PARTS[name])
    tier = [part for part in row["name"].split("/") if part.startswith("tier:")]
    empty = [time for other, time in times.items() if other.split("/")[0] == "nothing" and tier and tier[0] in other]
    if name == "organ" and empty:
        return min(empty), "empty frame"
    return None


def run_scene(build, scene, folder):
    """What the whole program reports of a scene; nothing where it fails."""
    done = subprocess.run([str(Path(build) / "bin/thinwall"), "run", str(ROOT / scene), "--out", str(folder), "--json"],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        print(f"the recording of {scene} is left out: {done.stderr.strip()[-300:]}", file=sys.stderr)
        return None
    return json.loads(done.stdout)


def incision(build, out):
    """The whole program, video included, on an incision of 5 000 triangles; its floor is its playing time."""
    report = run_scene(build, INCISION, out / "incision")
    if not report:
        return []
    return [{"name": f"Recording/{Path(INCISION).stem}", "real_time": report["wall_s"], "time_unit": "s",
             "floor_s": report["simulated_s"], "floor_is": "its playing time"}]


def start_of_program(build, turns=20):
    """What it takes to be told the version, the median."""
    taken = []
    for _ in range(turns):
        begin = time.monotonic()
        subprocess.run([str(Path(build) / "bin/thinwall"), "--version"], stdout=subprocess.DEVNULL, check=True)
        taken.append(time.monotonic() - begin)
    return [{"name": "Version", "real_time": median(taken), "time_unit": "s"}]


def recording(build, out):
    """The whole program on a scene, and ffmpeg alone on the same pictures."""
    folder = out / "recording"
    report = run_scene(build, SCENE, folder)
    if not report:
        return []
    wall = report["wall_s"]
    raw = out / "pictures.raw"
    video = folder / "video.mp4"
    size = subprocess.run(["ffprobe", "-v", "error", "-select_streams", "v", "-show_entries", "stream=width,height,r_frame_rate",
                           "-of", "csv=p=0", str(video)], stdout=subprocess.PIPE, text=True, check=True).stdout.strip().split(",")
    subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", str(video), "-f", "rawvideo", "-pix_fmt", "rgb24", str(raw)], check=True)
    begin = time.monotonic()
    subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}", "-r", size[2],
                    "-i", str(raw), "-pix_fmt", "yuv420p", "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", str(out / "alone.mp4")],
                   check=True)
    alone = time.monotonic() - begin
    raw.unlink()
    (out / "alone.mp4").unlink()
    return [{"name": f"Recording/{Path(SCENE).stem}", "real_time": wall, "time_unit": "s", "floor_s": alone, "floor_is": "ffmpeg alone"}]


@contextlib.contextmanager
def display():
    """The name of an X display without a screen, once it is ready."""
    told, tells = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(tells), "-screen", "0", "1280x720x24", "-nolisten", "tcp", "-noreset"],
                              pass_fds=[tells], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(tells)
    try:
        with os.fdopen(told) as number:
            yield ":" + number.readline().strip()
    finally:
        server.terminate()
        server.wait()


def peer_pictures():
    """Pictures of the same size and of as many triangles by VTK, which Debian has; it asks for a display."""
    has_vtk = subprocess.run([sys.executable, "-c", "import vtk"], stderr=subprocess.DEVNULL).returncode == 0
    if not has_vtk or not shutil.which("Xvfb"):
        print("pictures by VTK are left out: apt-get install python3-vtk9 xvfb", file=sys.stderr)
        return []
    print("VTK ...", file=sys.stderr)
    with display() as name:
        done = subprocess.run([sys.executable, str(ROOT / "tests/benchmarks/peers/vtk_frames.py")], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, env={**os.environ, "DISPLAY": name})
    if done.returncode != 0:
        print(f"pictures by VTK are left out: {done.stderr.strip()[-300:]}", file=sys.stderr)
        return []
    return json.loads(done.stdout)


def haptics(build, out):
    """Rows of the haptic loop: the percentiles are what counts, not the mean."""
    rows = []
    program = str(Path(build) / "bin/thinwall")
    for triangles, forces in HAPTIC_CASES:
        done = subprocess.run([program, "haptic", str(ROOT / HAPTIC), "--set", f"triangles={triangles}", "--forces", forces, "--json"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            print(f"haptic loop of {triangles} triangles, {forces}: {done.stderr.strip()[-200:]}", file=sys.stderr)
            continue
        report = json.loads(done.stdout)
        rows.append({"name": f"HapticLoop/{forces}/{report['triangles']}", "real_time": report["computation"]["p99_ms"],
                     "time_unit": "ms", "report": report})
    lines = ["| triangles | forces | computation p50, p99, p99.9, largest, ms | wake-up p99, ms | empty loop p99, ms | missed | "
             "model age p99, ms | force error largest, r.m.s. | largest jump, N |", "| --- " * 9 + "|"]
    for row in rows:
        report = row["report"]
        computation = report["computation"]
        figures = ", ".join(f"{computation[key]:.3f}" for key in ("p50_ms", "p99_ms", "p99.9_ms", "largest_ms"))
        error = report["force_error"]
        age = report.get("model_age", {}).get("p99_ms", 0)
        lines.append(f"| {report['triangles']} | {report['forces']} | {figures} | {report['wake_up']['p99_ms']:.3f} | "
                     f"{report['empty_loop_wake_up']['p99_ms']:.3f} | {report['missed_deadlines']} of {report['ticks']} | {age:.0f} | "
                     f"{100 * error['largest_part']:.1f} %, {100 * error['root_mean_square_part']:.1f} % | "
                     f"{report['largest_force_jump_N']:.4f} |")
    text = "\n".join(lines) + "\n"
    (out / "haptics.md").write_text(text)
    print(text)
    return rows


def table(rows, rates, times):
    lines = ["| benchmark | time | floor | times its floor | the floor is |", "| --- | ---: | ---: | ---: | --- |"]
    for row in rows:
        if row.get("error_occurred"):
            lines.append(f"| {row['name']} | {row['error_message']} | | | |")
            continue
        taken = seconds(row)
        floor = (row["floor_s"], row["floor_is"]) if "floor_s" in row else floor_of(row, rates, times)
        told = f"{1e3 * floor[0]:.4g} ms | {taken / floor[0]:.2f} | {floor[1]}" if floor else " | | "
        lines.append(f"| {row['name']} | {1e3 * taken:.4g} ms | {told} |")
    for key, words in (("bytes", "memory: {:.1f} GB/s"), ("operations", "peak: {:.1f} Gflop/s")):
        if key in rates:
            lines.append(f"\n{words.format(rates[key] / 1e9)} (one thread)")
    return "\n".join(lines) + "\n"


def growth_of(rows):
    """By which power of the triangles a step's time grows, least squares over the sizes; and the largest memory."""
    sizes = [(math.log(int(row["name"].split("/")[1])), math.log(seconds(row))) for row in rows
             if row["name"].startswith("GrowingPalpation/") and not row.get("error_occurred")]
    if len(sizes) < 2:
        return ""
    middle = [sum(values) / len(sizes) for values in zip(*sizes)]
    power = sum((x - middle[0]) * (y - middle[1]) for x, y in sizes) / sum((x - middle[0]) ** 2 for x, _ in sizes)
    peak = max(row["peak_MiB"] for row in rows if row["name"].startswith("GrowingPalpation/"))
    return f"\ngrowth of a step's time with the triangles: power {power:.2f}; largest memory {peak:.0f} MiB\n"


def measure(options):
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    whole = {"context": {}, "benchmarks": []}
    for program in PROGRAMS:
        print(f"{program} ...", file=sys.stderr)
        part = run_program(options.build, program, options)
        whole["context"] = whole["context"] or part["context"]
        whole["benchmarks"] += part["benchmarks"]
    if not options.filter:
        whole["benchmarks"] += start_of_program(options.build)
        whole["benchmarks"] += recording(options.build, out)
        whole["benchmarks"] += incision(options.build, out)
        whole["benchmarks"] += peer_pictures()
    rates, times = floors_of(whole["benchmarks"])
    text = table(whole["benchmarks"], rates, times) + growth_of(whole["benchmarks"])
    if options.real_time:
        whole["benchmarks"] += haptics(options.build, out)
    (out / "benchmarks.json").write_text(json.dumps(whole, indent=1) + "\n")
    (out / "table.md").write_text(text)
    print(text)


def interval_of_ratio(first, second, turns=2000):
    """Ratio of the medians, and the interval that holds 95 % of those of resampled runs (bootstrap)."""
    chance = random.Random(1)
    ratios = sorted(median(chance.choices(second, k=len(second))) / median(chance.choices(first, k=len(first))) for _ in range(turns))
    return median(second) / median(first), ratios[int(0.025 * turns)], ratios[int(0.975 * turns)]


def compare(options):
    builds = options.compare
    taken = [{}, {}]
    for number in range(options.rounds):
        # In turns, and with the one first that was second before, so that what else the machine does meets both.
        for side in ((0, 1) if number % 2 == 0 else (1, 0)):
            for program in options.programs or [name for name in PROGRAMS if name != "floor_benchmarks"]:
                for row in run_program(builds[side], program, options)["benchmarks"]:
                    if not row.get("error_occurred"):
                        taken[side].setdefault(row["name"], []).append(seconds(row))
        print(f"round {number + 1} of {options.rounds}", file=sys.stderr)
    lines = ["| benchmark | first | second | second / first | 95 % interval | verdict |", "| --- | ---: | ---: | ---: | --- | --- |"]
    for name in taken[0]:
        if name not in taken[1]:
            continue
        ratio, low, high = interval_of_ratio(taken[0][name], taken[1][name])
        verdict = "faster" if high < 1 else "slower" if low > 1 else "no difference shown"
        lines.append(f"| {name} | {1e3 * min(taken[0][name]):.4g} ms | {1e3 * min(taken[1][name]):.4g} ms | {ratio:.3f} | "
                     f"{low:.3f} to {high:.3f} | {verdict} |")
    text = "\n".join(lines) + "\n"
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    (out / "comparison.md").write_text(text)
    print(text)


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench", description=__doc__)
    parser.add_argument("--build", help="the build folder; scripts/bench gives its own")
    parser.add_argument("--out", default=str(ROOT / "out/bench"), help="where the results go (default out/bench)")
    parser.add_argument("--filter", default="", help="only benchmarks whose names match")
    parser.add_argument("--quick", action="store_true", help="short measurements")
    parser.add_argument("--real-time", action="store_true", help="also the haptic loop; wants a quiet machine")
    parser.add_argument("--compare", nargs=2, metavar="BUILD", help="hold two build folders against each other")
    parser.add_argument("--programs", nargs="+", choices=sorted(PROGRAMS), help="with --compare: only these")
    parser.add_argument("--rounds", type=int, default=10, help="with --compare: how often each runs (default 10)")
    parser.add_argument("--list", action="store_true", help="tell the programs")
    options = parser.parse_args()
    if options.list:
        print("\n".join(PROGRAMS))
    elif options.compare:
        if options.rounds < 3:
            parser.error("--rounds: an interval needs three at least")
        for build in options.compare:
            if not (Path(build) / "tests/benchmarks").is_dir():
                parser.error(f"--compare {build}: no build folder with benchmarks")
        compare(options)
    else:
        measure(options)


if __name__ == "__main__":
    main()
