#pragma once

namespace thinwall {

/// Asks the system to let the calling thread run before all that are not in real time; whether it does.
bool ask_for_real_time();

/// Seconds of the clock that `sleep_until` uses; it never goes back.
double loop_clock();

/// Until that clock shows `time`, seconds.
void sleep_until(double time);

}  // namespace thinwall
