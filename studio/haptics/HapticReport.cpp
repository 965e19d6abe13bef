#include "studio/haptics/HapticReport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace thinwall {
namespace {

double percentile(const std::vector<double>& sorted, double part) {
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(sorted.size())));
  return sorted[std::min(sorted.size() - 1, rank == 0 ? 0 : rank - 1)];
}

template <typename Value>
Percentiles of_ticks(const HapticRecord& record, const Value& value) {
  std::vector<double> values;
  for (const HapticTick& tick : record.ticks) values.push_back(value(tick));
  return percentiles_of(std::move(values));
}

Percentiles latency(const HapticRecord& record) {
  return of_ticks(record, [](const HapticTick& tick) { return tick.latency(); });
}
Percentiles wake_up(const HapticRecord& record) {
  return of_ticks(record, [](const HapticTick& tick) { return tick.woken; });
}
Percentiles computation(const HapticRecord& record) {
  return of_ticks(record, [](const HapticTick& tick) { return tick.computed; });
}
Percentiles age(const HapticRecord& record) {
  return of_ticks(record, [](const HapticTick& tick) { return tick.age; });
}

long missed(const HapticRecord& record) {
  return std::ranges::count_if(record.ticks, &HapticTick::missed) + record.skipped;
}

std::string row(const char* name, const Percentiles& times) {
  return fmt::format("{:<24}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}\n", name, 1e3 * times.p50, 1e3 * times.p99,
                     1e3 * times.p999, 1e3 * times.largest);
}

nlohmann::ordered_json json_of(const Percentiles& times) {
  return {{"p50_ms", 1e3 * times.p50},
          {"p99_ms", 1e3 * times.p99},
          {"p99.9_ms", 1e3 * times.p999},
          {"largest_ms", 1e3 * times.largest}};
}

double rate(const HapticReport& report, const RefreshFigures& figures) {
  return report.duration > 0 ? static_cast<double>(figures.solutions) / report.duration : 0;
}

std::string solutions(const HapticReport& report, const std::string& name, const RefreshFigures& figures) {
  if (figures.solutions == 0) return {};
  return fmt::format("{}: {} ({:.1f} per second; mean {:.2f} ms, longest {:.2f} ms)\n", name, figures.solutions,
                     rate(report, figures), 1e3 * figures.total / static_cast<double>(figures.solutions),
                     1e3 * figures.longest);
}

nlohmann::ordered_json json_of(const HapticReport& report, const RefreshFigures& figures) {
  const auto divisor =
      static_cast<double>(std::max(1L, figures.solutions));  // a short session may end before the first
  return {{"count", figures.solutions},
          {"per_second", rate(report, figures)},
          {"mean_ms", 1e3 * figures.total / divisor},
          {"longest_ms", 1e3 * figures.longest}};
}

}  // namespace

Percentiles percentiles_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {percentile(values, 0.5), percentile(values, 0.99), percentile(values, 0.999), values.back()};
}

ForceError force_error(const std::vector<HapticTick>& ticks, const std::vector<TimedForce>& full) {
  ForceError error;
  double squares = 0;
  for (const TimedForce& right : full) {
    // Times of both sides are multiples of what need not be the same to the last bit.
    const auto after = std::ranges::upper_bound(ticks, right.time + 1e-9, {}, &HapticTick::time);
    if (after == ticks.begin() || (after == ticks.end() && right.time > ticks.back().time + 1e-9)) continue;
    const double off = ((after - 1)->force - right.force).norm();
    error.largest_force = std::max(error.largest_force, right.force.norm());
    if (off > error.largest) error.at = right.time;
    error.largest = std::max(error.largest, off);
    squares += off * off;
    ++error.samples;
  }
  if (error.samples > 0) error.root_mean_square = std::sqrt(squares / static_cast<double>(error.samples));
  return error;
}

double largest_jump(const std::vector<HapticTick>& ticks) {
  double largest = 0;
  for (std::size_t k = 1; k < ticks.size(); ++k) {
    largest = std::max(largest, (ticks[k].force - ticks[k - 1].force).norm());
  }
  return largest;
}

double largest_change(const std::vector<TimedForce>& full, double period) {
  double largest = 0;
  for (std::size_t k = 1; k < full.size(); ++k) {
    const double step = full[k].time - full[k - 1].time;
    largest = std::max(largest, (full[k].force - full[k - 1].force).norm() * std::min(1.0, period / step));
  }
  return largest;
}

namespace {

std::string driver_text(const PeerFigures& driver) {
  std::string text =
      fmt::format("driver: {} poses, longest silence {:.1f} ms", driver.poses, 1e3 * driver.longest_silence);
  if (driver.passed_over > 0) text += fmt::format("; {} datagrams were passed over", driver.passed_over);
  if (driver.undelivered > 0) text += fmt::format("; {} forces could not be delivered", driver.undelivered);
  if (driver.lost >= 0) text += fmt::format("; it was gone from {:.3f} s on and did not come back", driver.lost);
  return text + "\n";
}

nlohmann::ordered_json json_of(const PeerFigures& driver) {
  nlohmann::ordered_json json = {{"poses", driver.poses},
                                 {"passed_over", driver.passed_over},
                                 {"undelivered_forces", driver.undelivered},
                                 {"longest_silence_ms", 1e3 * driver.longest_silence}};
  if (driver.lost >= 0) json["lost_at_s"] = driver.lost;
  return json;
}

const char* real_time_text(const HapticReport& report) {
  if (report.record.was_real_time) return "yes";
  if (!report.asked_for_real_time) return "not asked for; wake-ups depend on what else runs";
  return "not permitted (needs root, CAP_SYS_NICE or a limit `rtprio`), so that wake-ups depend on what else runs";
}

}  // namespace

std::string to_text(const HapticReport& report) {
  std::string text = fmt::format("{}: {} triangles, tool `{}`, {:.2f} s at {:.0f} Hz, {} forces\n", report.scenario,
                                 report.triangles, report.tool, report.duration, 1 / report.period, report.forces);
  text += fmt::format("real-time scheduling: {}\n", real_time_text(report));
  text += fmt::format("{:<24}{:>10}{:>10}{:>10}{:>10}\n", "milliseconds", "p50", "p99", "p99.9", "largest");
  text += row("latency", latency(report.record));
  text += row("  wake-up jitter", wake_up(report.record));
  text += row("  computation", computation(report.record));
  text += row("empty loop, wake-up", wake_up(report.empty));
  if (report.refresh.solutions > 0) text += row("age of the model", age(report.record));
  text += fmt::format("missed deadlines: {} of {}\n", missed(report.record),
                      static_cast<long>(report.record.ticks.size()) + report.record.skipped);
  if (report.driver) text += driver_text(*report.driver);
  const bool is_led = report.coarse_triangles > 0;
  text += solutions(
      report, is_led ? fmt::format("solutions of a body of {} triangles", report.coarse_triangles) : "full solutions",
      report.refresh);
  text += solutions(report, "full solutions that correct it", report.corrections);
  text += fmt::format(
      "force error: largest {:.4g} N at {:.3f} s, {:.2f} % of the largest force of {:.4g} N; root mean square {:.2f} "
      "%, "
      "{} moments of the full solution\n",
      report.error.largest, report.error.at, 100 * report.error.largest_part(), report.error.largest_force,
      100 * report.error.mean_part(), report.error.samples);
  text += fmt::format("largest force jump: {:.4g} N from a tick to the next (the full solution itself: {:.4g} N)\n",
                      largest_jump(report.record.ticks), report.full_change);
  text += fmt::format("passivity guard: braked in {} ticks, {:.3g} mJ; gave less than the force in {} ticks\n",
                      report.record.braked, 1e3 * report.record.damped, report.record.yielded);
  return text;
}

std::string to_json(const HapticReport& report, int exit_code) {
  nlohmann::ordered_json json = {{"result", report.failure.empty() ? "good" : "failed"},
                                 {"exit_code", exit_code},
                                 {"scenario", report.scenario},
                                 {"tool", report.tool},
                                 {"forces", report.forces},
                                 {"triangles", report.triangles},
                                 {"rate_hz", 1 / report.period},
                                 {"duration_s", report.duration},
                                 {"ticks", report.record.ticks.size()},
                                 {"missed_deadlines", missed(report.record)},
                                 {"real_time", report.record.was_real_time},
                                 {"latency", json_of(latency(report.record))},
                                 {"wake_up", json_of(wake_up(report.record))},
                                 {"computation", json_of(computation(report.record))},
                                 {"empty_loop_wake_up", json_of(wake_up(report.empty))}};
  if (report.driver) json["driver"] = json_of(*report.driver);
  if (report.refresh.solutions > 0) {
    json["model_age"] = json_of(age(report.record));
    json[report.coarse_triangles > 0 ? "coarse_solutions" : "full_solutions"] = json_of(report, report.refresh);
  }
  if (report.coarse_triangles > 0) {
    json["coarse_triangles"] = report.coarse_triangles;
    json["full_solutions"] = json_of(report, report.corrections);
  }
  json["force_error"] = {{"largest_N", report.error.largest},
                         {"root_mean_square_N", report.error.root_mean_square},
                         {"largest_force_N", report.error.largest_force},
                         {"largest_part", report.error.largest_part()},
                         {"root_mean_square_part", report.error.mean_part()},
                         {"at_s", report.error.at},
                         {"samples", report.error.samples}};
  json["largest_force_jump_N"] = largest_jump(report.record.ticks);
  json["full_solution_largest_change_N"] = report.full_change;
  json["passivity_guard"] = {{"braked_ticks", report.record.braked},
                             {"damped_J", report.record.damped},
                             {"yielded_ticks", report.record.yielded}};
  if (!report.failure.empty()) json["failure"] = report.failure;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string tick_table(const HapticRecord& record) {
  std::string table = "time_s,x_m,y_m,z_m,fx_N,fy_N,fz_N,wake_up_s,computation_s,model_age_s\n";
  for (const HapticTick& tick : record.ticks) {
    const Eigen::Vector3d& tip = tick.pose.tip;
    table += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.3g},{:.3g},{:.3g}\n", tick.time, tip.x(),
                         tip.y(), tip.z(), tick.force.x(), tick.force.y(), tick.force.z(), tick.woken, tick.computed,
                         tick.age);
  }
  return table;
}

}  // namespace thinwall
