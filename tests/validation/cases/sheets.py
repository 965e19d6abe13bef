"""Sheets of every law under given tensions: uniaxial, equibiaxial, pure shear."""
from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq

from oracles import wall_laws
from oracles.wall_laws import Law
from suite.case import Case, Comparison, Quantity
from suite.program import Program

SIDE, THICKNESS = 10e-3, 1e-3  # metres


@dataclass(frozen=True)
class Sheet:
    scenario: str
    title: str
    law: Law  # its first axis lies along the sheet
    stretches: tuple[float, float, float]  # along
    settings: dict[str, str] = field(default_factory=dict)


def free_across(law: Law, along: float) -> float:
    """The stretch across at which a sheet bears no tension across."""
    return brentq(lambda across: wall_laws.tensions(law, along, across)[1], 0.3, 1.2, xtol=1e-15, rtol=1e-15)


MODES = {
    "uniaxial": free_across,
    "equibiaxial": lambda law, along: along,
    "pure shear": lambda law, along: 1.0,
}


def pulled(sheet: Sheet, along: float, across: float, program: Program, triangles: int) -> tuple[float, float, float]:
    """Both stretches and the energy (joule per cubic metre) of the sheet under the tensions that belong to these."""
    along_pull, across_pull = (THICKNESS * pull for pull in wall_laws.tensions(sheet.law, along, across))
    if across_pull < 1e-12 * along_pull:
        across_pull = 0.0  # what rounding leaves of a free border
    records = program.run(sheet.scenario, triangles=triangles, tension_along=f"{along_pull:.17g} N/m",
                          tension_across=f"{across_pull:.17g} N/m", **sheet.settings)
    corner = records.point("sheet", "corner")
    energy = records.body("sheet")["elastic_J"][-1] / (SIDE**2 * THICKNESS)
    return 1 + corner["ux_m"][-1] / SIDE, 1 + corner["uy_m"][-1] / SIDE, energy


def compare(sheet: Sheet, program: Program, triangles: int) -> Comparison:
    quantities = []
    energies, exact_energies, places = [], [], []
    along = np.array(sheet.stretches)
    for mode, across_of in MODES.items():
        across = np.array([across_of(sheet.law, each) for each in along])
        found = np.array([pulled(sheet, *pair, program, triangles) for pair in zip(along, across)])
        fine = np.linspace(1, along[-1], 40)
        pull = [THICKNESS * wall_laws.tension(sheet.law, each, across_of(sheet.law, each)) for each in fine]
        tensions = np.array([THICKNESS * wall_laws.tension(sheet.law, *pair) for pair in zip(along, across)])
        quantities.append(Quantity(f"stretch along, {mode}", "tension along, N/m", "", tensions, found[:, 0], along,
                                   curve=(np.array(pull), fine)))
        quantities.append(Quantity(f"stretch across, {mode}", "tension along, N/m", "", tensions, found[:, 1], across,
                                   drawn=False))
        energies += list(found[:, 2])
        exact_energies += [float(np.real(sheet.law(*pair))) for pair in zip(along, across)]
        places += list(along)
    quantities.append(Quantity("energy per volume, all three", "stretch along", "Pa", np.array(places), np.array(energies),
                               np.array(exact_energies), drawn=False))
    return Comparison(quantities)


def fibres(angle: float) -> Sheet:
    return Sheet("sheet_holzapfel", f"Holzapfel, fibres at {angle:.0f}°",
                 wall_laws.holzapfel(10e3, 20e3, 1.0, 0.1, np.radians(angle)), (1.1, 1.2, 1.4), {"angle": f"{angle:.0f} deg"})


SHEETS = {
    "st_venant_kirchhoff": Sheet("sheet_st_venant_kirchhoff", "St. Venant–Kirchhoff",
                                 wall_laws.st_venant_kirchhoff(60e3, 0.4), (1.1, 1.2, 1.4)),
    "neo_hookean": Sheet("sheet_neo_hookean", "neo-Hookean", wall_laws.neo_hookean(20e3), (1.2, 1.5, 2.0)),
    "mooney_rivlin": Sheet("sheet_mooney_rivlin", "Mooney–Rivlin", wall_laws.mooney_rivlin(8e3, 2e3), (1.2, 1.5, 2.0)),
    "gent": Sheet("sheet_gent", "Gent", wall_laws.gent(20e3, 3.0), (1.2, 1.4, 1.6)),
    "ogden": Sheet("sheet_ogden", "Ogden", wall_laws.ogden([(30e3, 1.3), (60.0, 5.0), (-500.0, -2.0)]), (1.2, 1.5, 2.0)),
    "fung": Sheet("sheet_fung", "Fung", wall_laws.fung(2e3, 12.0, 8.0, 3.0), (1.1, 1.2, 1.3)),
    "holzapfel_30": fibres(30),
    "holzapfel_60": fibres(60),
}

CASES = [Case(f"sheet_{name}", f"Sheet under tensions, {sheet.title}", "closed form of the law",
              "stretches and energy, uniaxial, equibiaxial, pure shear", 1e-8, (6, 60),
              lambda program, triangles, sheet=sheet: compare(sheet, program, triangles),
              quick=(6,) if name in ("ogden", "holzapfel_30") else (), scenario=sheet.scenario)
         for name, sheet in SHEETS.items()]
