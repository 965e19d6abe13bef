"""Runs scenarios with the program and reads what they leave."""
from __future__ import annotations

import csv
import json
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
SCENES = ROOT / "scenes" / "validation"


# A run that takes longer is given up and reported, so that one case cannot hold up the rest.
LONGEST_RUN = 400  # seconds


class RunFailed(Exception):
    """The program did not run a scenario to its end."""


@dataclass(frozen=True)
class Records:
    """What a run left in its folder."""

    folder: Path

    def _rows(self, file: str, key: str, name: str) -> list[dict[str, str]]:
        with open(self.folder / file, newline="", encoding="utf-8") as stream:
            rows = [row for row in csv.DictReader(stream) if row[key] == name]
        if not rows:
            raise RunFailed(f"{file} has no row of {name}")
        return rows

    def body(self, name: str) -> dict[str, np.ndarray]:
        """Columns of body.csv: (steps) each."""
        rows = self._rows("body.csv", "body", name)
        return {column: np.array([float(row[column]) for row in rows]) for column in rows[0] if column != "body"}

    def tool(self, name: str) -> dict[str, np.ndarray]:
        """Columns of forces.csv: (steps) each; `phase` as texts."""
        rows = self._rows("forces.csv", "tool", name)
        return {column: np.array([row[column] if column == "phase" else float(row[column]) for row in rows])
                for column in rows[0] if column != "tool"}

    def point(self, body: str, name: str) -> dict[str, np.ndarray]:
        """Columns of points.csv of a recorded point of a body: (steps) each."""
        with open(self.folder / "points.csv", newline="", encoding="utf-8") as stream:
            rows = [row for row in csv.DictReader(stream) if row["body"] == body and row["point"] == name]
        if not rows:
            raise RunFailed(f"points.csv has no row of {body}.{name}")
        return {column: np.array([float(row[column]) for row in rows])
                for column in rows[0] if column not in ("body", "point")}

    def surface(self, body: str, after_cuts: bool = False) -> "Surface":
        """A body's wall as it was before the first cut, or from the last cut on."""
        with h5py.File(self.folder / "take.h5") as take:
            epochs = take["surfaces"][body]
            epoch = epochs[f"epoch_{len(epochs) - 1 if after_cuts else 0}"]
            first, positions = int(epoch.attrs["first_step"]), epoch["positions"][:].astype(float)
            return Surface(time=take["time"][first:first + len(positions)],
                           rest=epoch["rest_positions"][:].astype(float), triangles=epoch["triangles"][:].astype(int),
                           positions=positions)


@dataclass(frozen=True)
class Surface:
    time: np.ndarray  # (steps), seconds
    rest: np.ndarray  # (vertices x 3), metres
    triangles: np.ndarray  # (triangles x 3)
    positions: np.ndarray  # (steps x vertices x 3), metres

    def nearest(self, point) -> int:
        """The vertex whose stress-free position is nearest to a point (metres)."""
        return int(np.argmin(np.linalg.norm(self.rest - np.asarray(point), axis=1)))


class Program:
    """Runs `thinwall run --no-render`, each scenario with the same settings once."""

    def __init__(self, executable: Path, out: Path, go_on: bool = False):
        """`go_on`: runs that `out` holds already are taken when they are younger than the program and all scenes."""
        self.executable = executable
        self.out = out
        self._young_enough = float("inf")
        if go_on:
            sources = [executable, *(file for file in SCENES.rglob("*") if file.is_file())]
            self._young_enough = max(file.stat().st_mtime for file in sources)
        self.seconds = 0.0  # wall time of all runs
        self._done: dict[tuple, Records] = {}

    def version(self) -> str:
        told = subprocess.run([str(self.executable), "--version"], capture_output=True, text=True, check=True)
        return told.stdout.splitlines()[0]

    def run(self, scenario: str, **settings) -> Records:
        key = (scenario, tuple(sorted((name, str(value)) for name, value in settings.items())))
        if key not in self._done:
            self._done[key] = self._run(scenario, settings)
        return self._done[key]

    def _run(self, scenario: str, settings: dict) -> Records:
        folder = self.out / "runs" / "-".join([scenario, *(f"{name}={value}" for name, value in settings.items())])
        manifest = folder / "manifest.json"
        if manifest.is_file() and manifest.stat().st_mtime > self._young_enough:
            if json.loads(manifest.read_text(encoding="utf-8"))["complete"]:
                return Records(folder)
        command = [str(self.executable), "run", str(SCENES / f"{scenario}.yaml"), "--no-render", "--out", str(folder)]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        begin = time.monotonic()
        try:
            outcome = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LONGEST_RUN)
        except subprocess.TimeoutExpired as expired:
            raise RunFailed(f"did not end within {LONGEST_RUN} s") from expired
        finally:
            self.seconds += time.monotonic() - begin
        if outcome.returncode != 0:
            lines = [line for line in outcome.stderr.splitlines() if line.strip()]
            raise RunFailed(f"exit code {outcome.returncode}: " + " ".join(lines[-3:]))
        return Records(folder)
