"""Vibration, relaxation, creep and cyclic loading."""
from __future__ import annotations

import numpy as np

from oracles import drum, ring, viscoelasticity, wall_laws
from suite.case import Case, Comparison, Quantity
from suite.program import Program


def spectrum_peak(time: np.ndarray, signal: np.ndarray, near: float) -> float:
    """The frequency (hertz) within a tenth of `near` at which a Hann-windowed signal is strongest."""
    windowed = (signal - signal.mean()) * np.hanning(len(signal))

    def strength(frequency: float) -> float:
        return float(np.abs(np.sum(windowed * np.exp(-2j * np.pi * frequency * time))))

    grid = np.linspace(0.9 * near, 1.1 * near, 401)
    best = int(np.argmax([strength(frequency) for frequency in grid]))
    best = min(max(best, 1), len(grid) - 2)
    low, middle, high = (strength(grid[k]) for k in (best - 1, best, best + 1))
    return float(grid[best] + (grid[1] - grid[0]) * 0.5 * (low - high) / (low - 2 * middle + high))


def compare_drum(program: Program, triangles: int) -> Comparison:
    step = 0.1 * np.sqrt(600 / triangles)  # milliseconds, with the length of the edges
    surface = program.run("drum_frequencies", triangles=triangles, step=f"{step:.4f} ms").surface("drum")
    pull = drum.tension(50e3, 0.5e-3, 1.3)
    exact = drum.frequencies(50e-3, pull, 1060 * 0.5e-3 / 1.3**2)
    ringing = surface.time > 4e-3
    watched = surface.nearest([22e-3, 14e-3, 0])
    motion = surface.positions[ringing, watched, 2]
    model = [spectrum_peak(surface.time[ringing], motion, near) for near in exact]
    return Comparison([Quantity("frequency", "nodal diameters", "Hz", np.array([0.0, 1.0, 2.0]), np.array(model),
                                np.array(exact))],
                      [f"The vertex that is watched swings by up to {1e3 * np.max(np.abs(motion)):.2f} mm. The time step goes with the "
                       f"length of the edges, here {1e3 * step:.0f} us."])


def compare_ring(program: Program, triangles: int) -> Comparison:
    step = 0.5 * np.sqrt(400 / triangles)  # milliseconds, with the length of the edges
    side = program.run("ring_tones", triangles=triangles, step=f"{step:.4f} ms").point("ring", "side")
    waves = np.array([2.0, 4.0])
    exact = ring.frequencies(100e-3, 2e-3, 100e6, 1000, waves)
    ringing = side["time_s"] > 4e-3
    model = [spectrum_peak(side["time_s"][ringing], side["uz_m"][ringing], near) for near in exact]
    return Comparison([Quantity("frequency", "waves around", "Hz", waves, np.array(model), exact)],
                      [f"The time step goes with the length of the edges, here {1e3 * step:.0f} us."])


def compare_relaxation(program: Program, steps: int) -> Comparison:
    terms = [(0.3, 0.2), (0.2, 2.0)]
    body = program.run("relaxation", step=f"{200 / steps} ms").body("balloon")
    law = wall_laws.neo_hookean(40e3)
    filled = 20e-3  # seconds
    # The second Piola-Kirchhoff stress relaxes: S = (dW/dl) / l, pressure ~ S / l.
    time = np.linspace(0, filled, 201)
    growth = body["volume_m3"][-1] / body["volume_m3"][0] - 1
    stretch = np.cbrt(1 + growth * time / filled)
    stress = np.array([wall_laws.tension(law, each, each) / each for each in stretch])
    middles, rises = (time[1:] + time[:-1]) / 2, np.diff(stress)

    def relaxed(moment: float) -> float:
        return float(np.sum(viscoelasticity.relaxation(terms, moment - middles) * rises))

    after = np.flatnonzero(body["time_s"] > filled - 1e-9)
    model = body["pressure_Pa"][after] / body["pressure_Pa"][after[0]]
    exact = np.array([relaxed(moment) for moment in body["time_s"][after]])
    return Comparison([Quantity("pressure over that when filled", "time, s", "", body["time_s"][after], model,
                                exact / exact[0])])


# Metres, newton/metre per strain, newton/metre: so little that the law is linear to 5e-6.
STRIP, STIFFNESS, PULL = 40e-3, 60.0, 0.2e-3


def tip(program: Program, scenario: str, **settings) -> tuple[np.ndarray, np.ndarray]:
    """Time and strain."""
    end = program.run(scenario, **settings).point("strip", "end")
    return end["time_s"], end["ux_m"] / STRIP


def compare_creep(program: Program, steps: int) -> Comparison:
    time, strain = tip(program, "creep", step=f"{200 / steps} ms")
    ramp = 20e-3  # seconds
    later = time > ramp - 1e-9
    exact = PULL / STIFFNESS * viscoelasticity.creep_after_ramp(0.3, 0.2, ramp, time[later])
    return Comparison([Quantity("strain", "time, s", "", time[later], strain[later], exact)])


def response(time: np.ndarray, values: np.ndarray, decay: float) -> complex:
    """Amplitude at 1 Hz (of exp(i omega t)) beside a constant and a transient that decays."""
    omega = 2 * np.pi
    columns = np.stack([np.cos(omega * time), np.sin(omega * time), np.ones_like(time), np.exp(-time / decay)], axis=1)
    cosine, sine, _, _ = np.linalg.lstsq(columns, values, rcond=None)[0]
    return cosine - 1j * sine


def compare_cyclic(program: Program, steps: int) -> Comparison:
    fraction = 0.5
    turns = np.array([0.2, 0.5, 1.0, 2.0, 5.0])  # omega tau
    storage, loss, exact = [], [], []
    for turn in turns:
        relaxing = turn / (2 * np.pi)
        time, strain = tip(program, "cyclic_loading", time=f"{1e3 * relaxing:.6f} ms", step=f"{1e3 / steps} ms")
        last = (time > 2 - 1e-9) & (time < 4 - 1e-9)  # whole periods
        corners = np.arange(81) * 0.05
        load = np.interp(time[last], corners, np.round(np.sin(2 * np.pi * corners), 6)) * PULL / STIFFNESS
        modulus = response(time[last], load, relaxing) / response(time[last], strain[last], relaxing / (1 - fraction))
        storage.append(modulus.real)
        loss.append(modulus.imag)
        exact.append(viscoelasticity.storage_and_loss([(fraction, relaxing)], 1.0))
    fine = np.geomspace(0.15, 6, 60)
    curves = np.array([viscoelasticity.storage_and_loss([(fraction, turn / (2 * np.pi))], 1.0) for turn in fine])
    label = "frequency times relaxation time, rad"
    return Comparison([
        Quantity("storage modulus over that at once", label, "", turns, np.array(storage),
                 np.array([each[0] for each in exact]), curve=(fine, curves[:, 0])),
        Quantity("loss modulus over that at once", label, "", turns, np.array(loss),
                 np.array([each[1] for each in exact]), curve=(fine, curves[:, 1]))])


CASES = [
    Case("drum_frequencies", "Tones of a pretensioned drum", "zeros of Bessel functions", "first three frequencies", 0.01,
         (150, 600, 1350), compare_drum),
    Case("ring_tones", "Tones of a ring", "Hoppe 1871", "frequencies with two and four waves around", 0.01, (200, 600), compare_ring,
         quick=(200,), quick_bar=0.03),
    Case("relaxation", "Relaxation of a balloon", "Prony series, convolution", "pressure over four seconds", 0.005,
         (10, 20, 40), compare_relaxation, quick=(10,), size_name="steps in 0.2 s", size_dimension=1),
    Case("creep", "Creep of a strip", "Prony series, exact inverse", "strain over 1.5 s", 0.005, (10, 20, 40),
         compare_creep, quick=(20,), size_name="steps in 0.2 s", size_dimension=1),
    Case("cyclic_loading", "Cyclic loading at five frequencies", "storage and loss moduli of the Prony series",
         "both moduli", 0.005, (40, 80, 160), compare_cyclic, size_name="steps in a period", size_dimension=1),
]
