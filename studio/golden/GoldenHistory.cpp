#include "studio/golden/GoldenHistory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "renderer/snapshot/SameTime.hpp"
#include "studio/golden/GoldenApproval.hpp"

namespace thinwall {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A finite number, or a whole one that is not negative.
template <typename Number>
Number number_of(std::string_view text, const std::string& file) {
  Number value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = result.ec == std::errc() && result.ptr == text.data() + text.size();
  if (!good || !std::isfinite(static_cast<double>(value))) {
    throw GoldenError(fmt::format("{}: \"{}\" is no number", file, text));
  }
  return value;
}

double spent(const BodyRecord& body) {
  return body.viscous + body.friction + body.fracture + body.leak + body.jump;
}

constexpr std::string_view kSecondTake = "second_take.";

/// "probe.force_N" -> "force of probe", "N"; "second_take.probe.force_N" -> "force of probe in the second take", "N"
std::pair<std::string, std::string> spoken(const std::string& column) {
  const std::size_t dot = column.rfind('.');
  const std::size_t unit = column.rfind('_');
  std::string quantity = column.substr(dot + 1, unit - dot - 1);
  std::replace(quantity.begin(), quantity.end(), '_', ' ');
  std::string owner = column.substr(0, dot);
  if (owner.starts_with(kSecondTake)) owner = owner.substr(kSecondTake.size()) + " in the second take";
  return {quantity + " of " + owner, column.substr(unit + 1)};
}

/// How far two numbers are apart on the scale of their column; not at all where that is 0.
double relative(double before, double after, double scale) {
  return scale > 0 ? std::abs(after - before) / scale : 0;
}

std::string_view unit_of(std::string_view column) {
  return column.substr(column.rfind('_') + 1);
}

/// Parts of the largest number with the same unit below which a column holds what rounding leaves of sums that cancel.
constexpr double kRounding = 1e-9;

/// A column whose numbers stay below this is at rest, unstrained or untouched, whatever the body's size: 1 pN through
/// 1 mm is 1 fJ, 1 pm is less than an atom, and 1 pm on 1 mm and 1 um cubed are less than any contact and any organ.
double still_of(std::string_view unit) {
  if (unit == "N") return 1e-12;
  if (unit == "J") return 1e-15;
  if (unit == "Pa") return 1e-6;
  if (unit == "m") return 1e-12;
  if (unit == "m2") return 1e-15;
  if (unit == "m3") return 1e-18;
  return 0;
}

/// The largest number of each column in both; 0 for a column that holds nothing but rounding.
std::vector<double> scales(const GoldenHistory& golden, const GoldenHistory& today) {
  std::vector<double> scale(golden.columns.size(), 0);
  std::map<std::string_view, double> largest;  // (units)
  for (std::size_t c = 0; c < scale.size(); ++c) {
    for (const GoldenHistory* history : {&golden, &today}) {
      for (const GoldenHistory::Row& row : history->rows) scale[c] = std::max(scale[c], std::abs(row.values[c]));
    }
    double& of_unit = largest[unit_of(golden.columns[c])];
    of_unit = std::max(of_unit, scale[c]);
  }
  for (std::size_t c = 0; c < scale.size(); ++c) {
    const std::string_view unit = unit_of(golden.columns[c]);
    if (scale[c] <= std::max(still_of(unit), kRounding * largest[unit])) scale[c] = 0;
  }
  return scale;
}

/// The column of a step that differs most.
struct LargestChange {
  std::size_t column = 0;
  double relative = 0;
  double time = 0;  // seconds
  double before = 0;
  double after = 0;
};

LargestChange largest_change(const GoldenHistory::Row& before, const GoldenHistory::Row& after,
                             const std::vector<double>& scale) {
  LargestChange largest{.time = before.time};
  for (std::size_t c = 0; c < scale.size(); ++c) {
    const double change = relative(before.values[c], after.values[c], scale[c]);
    if (change > largest.relative) largest = {c, change, before.time, before.values[c], after.values[c]};
  }
  return largest;
}

/// As the scenario's time steps may differ, rows belong together by their times, of nine digits in a text.
double rounding_of_time(double time) {
  return kSameTime + 1e-8 * time;
}

/// " (+3.1 %)"; nothing of what was too small beside today's to be more than rounding.
std::string percent_text(double before, double after) {
  if (std::abs(before) <= kRounding * std::abs(after)) return "";
  const double percent = 100 * (after - before) / std::abs(before);
  return std::abs(percent) < 99.5 ? fmt::format(" ({:+.2g} %)", percent) : fmt::format(" ({:+.0f} %)", percent);
}

void tell(HistoryChange& change, double time) {
  const auto [name, unit] = spoken(change.quantity);
  const bool are_alike = fmt::format("{:.4g}", change.after) == fmt::format("{:.4g}", change.before);
  const int digits = are_alike ? 9 : 4;  // of nine a history is written in
  change.sentence = fmt::format(
      "from step {} on ({:.4g} s), first in the {}; at {:.4g} s the {} is {:.{}g} {} instead of {:.{}g} {}{}",
      change.step, change.time, spoken(change.first).first, time, name, change.after, digits, unit, change.before,
      digits, unit, percent_text(change.before, change.after));
}

/// Calls add(owner, quantity, value) for each value of a step.
template <typename Add>
void visit_quantities(const StepRecord& record, const Add& add) {
  for (const ToolRecord& tool : record.tools) {
    add(tool.tool, "force_N", tool.force.norm());
    add(tool.tool, "depth_m", tool.depth);
    add(tool.tool, "contact_area_m2", tool.contact_area);
  }
  for (const BodyRecord& body : record.bodies) {
    add(body.body, "volume_m3", body.volume);
    add(body.body, "pressure_Pa", body.pressure);
    add(body.body, "elastic_energy_J", body.elastic + body.bending);
    add(body.body, "spent_energy_J", spent(body));
    add(body.body, "cut_length_m", body.cut_length);
    add(body.body, "open_area_m2", body.open_area);
  }
}

}  // namespace

void add_step(GoldenHistory& history, std::size_t step, const Moment& moment) {
  GoldenHistory::Row row{.step = step, .time = moment.record.time, .values = {}};
  const bool first = history.rows.empty();
  std::string_view take;
  const auto add = [&](const std::string& owner, const char* quantity, double value) {
    if (first) history.columns.push_back(fmt::format("{}{}.{}", take, owner, quantity));
    row.values.push_back(value);
  };
  visit_quantities(moment.record, add);
  take = kSecondTake;
  if (moment.second) visit_quantities(moment.second->record, add);
  if (!first && row.values.size() != history.columns.size()) row.values.resize(history.columns.size(), 0);
  history.rows.push_back(std::move(row));
}

std::string history_text(const GoldenHistory& history) {
  std::string text = "step,time_s";
  for (const std::string& column : history.columns) text += "," + column;
  text += "\n";
  const std::size_t stride = (history.rows.size() + kHistoryRows - 1) / kHistoryRows;
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    if (i % stride != 0 && i + 1 != history.rows.size()) continue;
    const GoldenHistory::Row& row = history.rows[i];
    text += fmt::format("{},{:.9g}", row.step, row.time);
    for (const double value : row.values) text += fmt::format(",{:.9g}", value);
    text += "\n";
  }
  return text;
}

GoldenHistory parse_history(const std::string& text, const std::string& file) {
  GoldenHistory history;
  std::vector<std::string_view> lines = split(text, '\n');
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  if (lines.empty() || !lines.front().starts_with("step,time_s"))
    throw GoldenError(file + ": is no history of a golden");
  if (!text.ends_with('\n')) throw GoldenError(file + ": is cut short");
  const std::vector<std::string_view> head = split(lines.front(), ',');
  history.columns.assign(head.begin() + 2, head.end());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string_view> cells = split(lines[i], ',');
    if (cells.size() != head.size()) throw GoldenError(fmt::format("{}:{}: has {} cells", file, i + 1, cells.size()));
    GoldenHistory::Row row{
        .step = number_of<std::size_t>(cells[0], file), .time = number_of<double>(cells[1], file), .values = {}};
    for (std::size_t c = 2; c < cells.size(); ++c) row.values.push_back(number_of<double>(cells[c], file));
    history.rows.push_back(std::move(row));
  }
  return history;
}

HistoryChange compare_histories(const GoldenHistory& golden, const GoldenHistory& today) {
  HistoryChange change;
  if (golden.rows.empty() || today.rows.empty() || golden.columns != today.columns) return change;
  change.comparable = true;
  const std::vector<double> scale = scales(golden, today);
  LargestChange end;
  LargestChange peak;
  auto now = today.rows.begin();
  for (const GoldenHistory::Row& before : golden.rows) {
    const double rounding = rounding_of_time(before.time);
    while (now != today.rows.end() && now->time < before.time - rounding) ++now;
    if (now == today.rows.end()) break;
    if (now->time > before.time + rounding) continue;
    end = largest_change(before, *now, scale);
    if (end.relative > peak.relative) peak = end;
    if (change.changed || end.relative <= kSameHistory) continue;
    change.changed = true;
    change.step = before.step;
    change.time = before.time;
    change.first = golden.columns[end.column];
  }
  if (!change.changed) return change;
  // What is as before at the end is told of where it was furthest from that.
  const LargestChange& told = end.relative > kSameHistory ? end : peak;
  change.quantity = golden.columns[told.column];
  change.before = told.before;
  change.after = told.after;
  tell(change, told.time);
  return change;
}

}  // namespace thinwall
