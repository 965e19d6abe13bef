"""Tools that rub on membranes."""
from __future__ import annotations

import numpy as np

from oracles import belt
from suite.case import Case, Comparison, Quantity
from suite.program import Program

COEFFICIENT = 0.3


def compare_drag(program: Program, triangles: int) -> Comparison:
    records = program.run("drag_of_a_sphere", triangles=triangles)
    ball, sheet = records.tool("ball"), records.body("sheet")
    place = 1e3 * ball["x_m"]
    ratio = -ball["fx_N"] / ball["fz_N"].clip(1e-12)
    turn = int(np.argmax(place))
    quantities = []
    # What sticks first gives way within some 0.7 mm at the beginning and twice that at the turn.
    for name, steps, sign in (("there", np.arange(len(place)) < turn, 1), ("back", np.arange(len(place)) > turn, -1)):
        sliding = np.flatnonzero(steps & (sign * place > -0.5))
        quantities.append(Quantity(f"drag over normal force, {name}", "place of the ball, mm", "", place[sliding],
                                   ratio[sliding], np.full(len(sliding), sign * COEFFICIENT)))
        way = 1e-3 * abs(place[sliding[-1]] - place[sliding[0]])
        spent = sheet["friction_J"][sliding[-1]] - sheet["friction_J"][sliding[0]]
        normal = float(np.mean(ball["fz_N"][sliding]))
        quantities.append(Quantity(f"energy spent, {name}", "way, mm", "uJ", np.array([1e3 * way]), np.array([1e6 * spent]),
                                   np.array([1e6 * COEFFICIENT * normal * way]), drawn=False))
    moving = np.flatnonzero(ball["fz_N"] > 0)
    quantities.append(Quantity("the whole way", "time, s", "", ball["time_s"][moving], ratio[moving],
                               np.where(moving <= turn, COEFFICIENT, -COEFFICIENT), judged=False))
    return Comparison(quantities)


ROD = 6e-3  # metres, radius
ENDS = (np.array([50e-3, 0.0]), np.array([-50e-3, 0.0]))  # metres, of the belt


def compare_belt(program: Program, triangles: int) -> Comparison:
    rod = program.run("belt_over_rod", triangles=triangles).tool("rod")
    # The belt sticks over the first two millimetres.
    sliding = np.flatnonzero(rod["y_m"] > 3e-3)
    sides = [belt.sides(np.array([rod["y_m"][k], rod["z_m"][k] + ROD]), ROD, ENDS, np.array([rod["fy_N"][k], rod["fz_N"][k]]))
             for k in sliding]
    return Comparison([Quantity(
        "tension behind the rod over the one ahead", "place of the rod, mm", "", 1e3 * rod["y_m"][sliding],
        np.array([each.second / each.first for each in sides]),
        np.array([belt.sliding_ratio(COEFFICIENT, each.wrap) for each in sides]))])


def compare_incline(program: Program, triangles: int) -> Comparison:
    slopes, fall = np.array([10.0, 15.0, 18.0, 25.0]), 9.81
    drags, gains, exact = [], [], []
    for slope in np.radians(slopes):
        records = program.run("sheet_on_incline", triangles=triangles, down=f"{fall * np.sin(slope):.9g} m/s^2",
                              into=f"{-fall * np.cos(slope):.9g} m/s^2")
        board, middle = records.tool("board"), records.point("sheet", "middle")
        drags.append(board["fx_N"][-1] / -board["fz_N"][-1])
        later = middle["time_s"] > 0.1  # when it has come to lie on the board
        gains.append(2 * np.polyfit(middle["time_s"][later], middle["ux_m"][later], 2)[0] / fall)
        exact.append(max(0.0, np.sin(slope) - COEFFICIENT * np.cos(slope)))
    return Comparison([
        Quantity("drag over normal force", "slope, degrees", "", slopes, np.array(drags),
                 np.minimum(COEFFICIENT, np.tan(np.radians(slopes)))),
        Quantity("gain of speed", "slope, degrees", "g", slopes, np.array(gains), np.array(exact), scale=1.0)],
        ["Errors of the gain are parts of g. The angle of friction is 16.7 degrees."])


CASES = [
    Case("drag_of_a_sphere", "A ball dragged over a stretched sheet", "Coulomb's law",
         "drag over normal force, energy spent, both ways", 0.01, (1024, 4096, 9216), compare_drag, quick=(4096,)),
    Case("belt_over_rod", "A belt over a rough rod", "Euler and Eytelwein", "ratio of the tensions beside the rod", 0.003,
         (400, 800, 1600), compare_belt, quick=(400,), quick_bar=0.01),
    Case("sheet_on_incline", "A sheet on an incline", "Coulomb's law", "drag and gain of speed at four slopes", 1e-6, (50, 200),
         compare_incline, quick=(50,), tells_order=False),
]
