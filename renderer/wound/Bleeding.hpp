#pragma once

namespace thinwall {

/// How a cut wall bleeds, as pictures show it: oozing that slackens as vessels close.
/// Volume (metres) of blood that has come out of a square metre of cut wall `age` seconds after the cut:
/// q T (1 - exp(-age / T)) with q = 0.15 mm/s and T = 4 s. 0 before the cut.
double blood_shed(double age);

/// Part from 0 to 1 to which blood is dry and dark `age` seconds after the cut: 1 - exp(-age / 60 s).
double dryness(double age);

/// Metres that a run of `volume` (metres^3) covers, `width` wide and `depth` deep, `age` seconds after it began: no
/// more than its volume allows, and no faster than `speed` (metres/second).
double run_length(double volume, double width, double depth, double age, double speed);

}  // namespace thinwall
