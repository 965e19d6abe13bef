"""Incisions drawn at random into the mesh of an organ, through the whole program.

Each is a scenario that is a function of mesh, seed and number alone: a straight, curved or turning cut, a cross, a loop
around a piece or a cut over an edge of the organ, into a membrane of any law, filled or empty, in motion or at rest;
half a second follows. A run must end well within its time, lose no fluid, write no number that is not finite, and
close its books. What the program refuses with reasons (exit code 2), as a blade that would begin inside the organ, is
counted apart.
"""

import argparse
import csv
import math
import random
import resource
import signal
import subprocess
import sys
from pathlib import Path

REST = 0.5  # seconds after the last cut
MOST_GIVEN = 0.02  # by the integrator, as part of the largest energy; on coarse meshes half a per cent is exceeded
MOST_LOST = 1e-9  # of the fluid


def read_mesh(path):
    """Vertices and triangles of an OBJ or OFF file, in the file's unit."""
    words = [line.split() for line in path.read_text().splitlines()]
    words = [line for line in words if line and not line[0].startswith("#")]
    if path.suffix.lower() == ".obj":
        vertices = [tuple(map(float, line[1:4])) for line in words if line[0] == "v"]
        faces = [[int(corner.split("/")[0]) - 1 for corner in line[1:]] for line in words if line[0] == "f"]
    elif path.suffix.lower() == ".off":
        count, face_count = int(words[1][0]), int(words[1][1])
        vertices = [tuple(map(float, line[:3])) for line in words[2 : 2 + count]]
        faces = [list(map(int, line[1:4])) for line in words[2 + count : 2 + count + face_count]]
    else:
        sys.exit(f"{path}: only OBJ and OFF files can be drawn on here")
    return vertices, [face for face in faces if len(face) == 3]


def plus(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(sum(x * x for x in a))


def unit(a):
    size = length(a)
    return tuple(x / size for x in a)


class Organ:
    """What is drawn on: in metres."""

    def __init__(self, path, scale):
        self.path = path
        vertices, self.triangles = read_mesh(path)
        self.vertices = [tuple(scale * x for x in vertex) for vertex in vertices]
        low = [min(vertex[k] for vertex in self.vertices) for k in range(3)]
        high = [max(vertex[k] for vertex in self.vertices) for k in range(3)]
        self.low, self.high = low, high
        self.width = min(h - l for h, l in zip(high, low))
        sides = [
            length(plus(self.vertices[t[k]], self.vertices[t[k - 1]], -1)) for t in self.triangles for k in range(3)
        ]
        self.edge = sum(sides) / len(sides)

    def middle(self, triangle):
        corners = [self.vertices[v] for v in triangle]
        return tuple(sum(corner[k] for corner in corners) / 3 for k in range(3))

    def normal(self, triangle):
        a, b, c = (self.vertices[v] for v in triangle)
        return unit(cross(plus(b, a, -1), plus(c, a, -1)))


def millimetres(value):
    return f"{1e3 * value:.6g} mm"


def point(place):
    return "[" + ", ".join(millimetres(x) for x in place) + "]"


LAWS = {
    "neo_hookean": lambda draw, mu: f"shear_modulus: {mu:.5g} Pa",
    "mooney_rivlin": lambda draw, mu: f"c1: {0.4 * mu:.5g} Pa, c2: {0.1 * mu:.5g} Pa",
    "gent": lambda draw, mu: f"shear_modulus: {mu:.5g} Pa, limit: {draw.uniform(5, 40):.4g}",
    "ogden": lambda draw, mu: f"terms: [{{ modulus: {mu:.5g} Pa, exponent: {draw.uniform(1.5, 8):.4g} }}]",
    "st_venant_kirchhoff": lambda draw, mu: f"youngs_modulus: {3 * mu:.5g} Pa, poisson_ratio: 0.45",
}

KINDS = ["straight", "curved", "back", "cross", "loop", "over the edge"]


def strokes_of(kind, draw, organ, place, normal):
    """Points of the paths in space, beside the place."""
    along = unit(cross(normal, unit(tuple(draw.gauss(0, 1) for _ in range(3)))))
    aside = cross(normal, along)
    reach = draw.uniform(3, 12) * organ.edge
    if kind == "straight":
        return [[plus(place, along, -reach / 2), plus(place, along, reach / 2)]]
    if kind == "over the edge":
        return [[plus(place, along, -reach), plus(place, along, 2 * reach)]]
    if kind == "back":
        ahead = plus(place, along, reach)
        return [[place, ahead, plus(plus(place, aside, draw.uniform(0, 0.3) * reach), along, -0.3 * reach)]]
    if kind == "cross":
        angle = draw.uniform(0.4, 2.7)
        other = plus(tuple(math.cos(angle) * x for x in along), aside, math.sin(angle))
        return [[plus(place, way, -reach / 2), plus(place, way, reach / 2)] for way in (along, other)]
    turn = draw.uniform(1.9, 2.2) * math.pi if kind == "loop" else draw.uniform(0.5, 1.6) * math.pi
    radius, pieces = 0.35 * reach, math.ceil(turn / 0.4)
    angles = [turn * k / pieces for k in range(pieces + 1)]
    return [[plus(plus(place, along, radius * math.cos(a)), aside, radius * math.sin(a)) for a in angles]]


def scenario_of(organ, unit_text, seed, number):
    draw = random.Random(f"{seed} {number}")
    kind = draw.choice(KINDS)
    held = organ.low[2] + draw.uniform(0.1, 0.35) * (organ.high[2] - organ.low[2])
    free = [t for t in organ.triangles if organ.middle(t)[2] > held + 6 * organ.edge]
    triangle = draw.choice(free or organ.triangles)
    paths = strokes_of(kind, draw, organ, organ.middle(triangle), organ.normal(triangle))
    law = draw.choice(sorted(LAWS))
    modulus, thickness = 10 ** draw.uniform(3.7, 5), draw.uniform(0.01, 0.03) * organ.width
    pressure = draw.choice([0, draw.uniform(0.02, 0.25)]) * 2 * modulus * thickness / organ.width
    speed = draw.uniform(0.01, 0.06) / 0.005 * organ.edge
    is_dynamic = draw.random() < 0.6
    step = draw.uniform(0.3, 1.2) * organ.edge / speed
    depth = draw.uniform(0.5, 1.5) * organ.edge
    clips = "".join(
        f"  - incise: {{ tool: blade, body: organ, path: [{', '.join(map(point, path))}], "
        f"reach: {millimetres(organ.width)}, depth: {millimetres(depth)}, speed: {millimetres(speed)}/s, "
        f"standoff: {millimetres(2 * organ.edge)} }}\n"
        for path in paths
    )
    shell = ", model: shell" if draw.random() < 0.15 else ""
    viscous = ", viscosity: [ { fraction: 0.3, time: 100 ms } ]" if draw.random() < 0.2 else ""
    text = f"""thinwall: 1
title: A {kind} cut, {number} of seed {seed}
bodies:
  organ:
    surface: {{ mesh: {organ.path}, unit: {unit_text} }}
    wall: {{ thickness: {millimetres(thickness)}, material: {{ law: {law}, {LAWS[law](draw, modulus)} }}, toughness: {draw.uniform(5, 200):.4g} J/m^2{shell}{viscous} }}
    contents: {{ fluid: {draw.choice(["incompressible", "incompressible", "compressible, bulk_modulus: 200 kPa"])}, pressure: {pressure:.4g} Pa, leaks: {draw.choice(["true", "true", "false"])} }}
    fixed: [ {{ region: {{ below: {{ axis: z, at: {millimetres(held)} }} }} }} ]
tools:
  blade: {{ kind: scalpel, length: {millimetres(6 * organ.edge)}, width: {millimetres(2 * organ.edge)}, thickness: {millimetres(0.1 * organ.edge)} }}
timeline:
{clips}  - wait: {{ for: {REST} s }}
simulation: {{ analysis: {"dynamic" if is_dynamic else "quasi_static"}, time_step: {1e3 * step:.4g} ms }}
"""
    return kind, text


def faults_of(folder):
    """What is wrong with the records of a run that ended well."""
    rows = list(csv.DictReader((folder / "body.csv").open()))
    numbers = [{key: float(value) for key, value in row.items() if key != "body"} for row in rows]
    if not all(math.isfinite(value) for row in numbers for value in row.values()):
        return "a number is not finite"
    held = [row["fluid_volume_m3"] + row["leaked_m3"] for row in numbers]
    if held[0] > 0 and max(abs(value / held[0] - 1) for value in held) > MOST_LOST:
        return "fluid is lost"
    largest = given = 0.0
    for row in numbers:
        largest = max([largest, 1e-12] + [abs(row[key]) for key in row if key.endswith("_J")])
        given = max(given, -row["numerical_J"] / largest)
    if given > MOST_GIVEN:
        return f"the integrator gives {100 * given:.1f} %"
    return None


def spent():
    """Seconds of the processor that runs have taken so far: what else the machine does leaves them as they are."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def limit_to(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))


def run(arguments, organ, number):
    kind, text = scenario_of(organ, arguments.unit, arguments.seed, number)
    arguments.out.mkdir(parents=True, exist_ok=True)
    scenario = arguments.out / f"{arguments.seed}_{number}.yaml"
    scenario.write_text(text)
    folder = arguments.out / scenario.stem
    command = [arguments.program, "run", scenario, "--no-render", "--out", folder]
    before = spent()
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=lambda: limit_to(arguments.limit))
    seconds = spent() - before
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return kind, "stopped", f"not done after {seconds:.0f} s"
    last = (done.stderr.strip().splitlines() or [""])[-1]
    if done.returncode == 2:
        return kind, "refused", last
    if done.returncode != 0:
        return kind, "failed", f"exit code {done.returncode}: {last}"
    fault = faults_of(folder)
    return kind, "failed" if fault else "ok", fault or f"{seconds:.1f} s"


def main():
    parser = argparse.ArgumentParser(prog="scripts/random-incisions", description=__doc__.split("\n")[0])
    parser.add_argument("--mesh", type=Path, required=True, help="OBJ or OFF file of a closed surface")
    parser.add_argument("--unit", default="mm", help="length that 1 in the file stands for (default: mm)")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="the number of one case")
    parser.add_argument("--limit", type=int, default=240, help="seconds of the processor for a run (default: 240)")
    parser.add_argument("--out", type=Path, default=Path("out/random_incisions"))
    parser.add_argument("--program", type=Path, required=True, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    number, _, name = arguments.unit.rpartition(" ")
    lengths = {"m": 1, "cm": 1e-2, "mm": 1e-3}
    if name not in lengths:
        sys.exit(f"--unit {arguments.unit}: m, cm or mm is known, as in '30 mm'")
    organ = Organ(arguments.mesh.resolve(), float(number or 1) * lengths[name])
    numbers = range(arguments.count) if arguments.only is None else [arguments.only]
    tally = {}
    for number in numbers:
        kind, outcome, words = run(arguments, organ, number)
        tally[outcome] = tally.get(outcome, 0) + 1
        print(f"{outcome} --seed {arguments.seed} --only {number}, {kind}: {words}", flush=True)
    print(f"{sum(tally.values())} incisions: " + ", ".join(f"{count} {name}" for name, count in sorted(tally.items())))
    return 1 if tally.get("failed", 0) + tally.get("stopped", 0) > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
