#include "studio/scenario/ResolvedTeaching.hpp"

#include <nlohmann/json.hpp>

namespace thinwall {
namespace {

using Json = nlohmann::json;

constexpr double kForEver = std::numeric_limits<double>::infinity();

ShownSpan to_span(const Json& shown) {
  return {.begin = shown.at("from"), .end = shown.value("until", kForEver)};
}

LabelSide to_side(const std::string& word) {
  if (word == "left") return LabelSide::kLeft;
  return word == "right" ? LabelSide::kRight : LabelSide::kNearest;
}

LabelDefinition to_label(const Json& label) {
  return {.text = label.at("text"),
          .body = label.at("body"),
          .at = label.at("at").get<Double3>(),
          .side = to_side(label.at("side")),
          .span = to_span(label)};
}

ArrowDefinition to_arrow(const Json& arrow) {
  return {.text = arrow.value("text", ""),
          .body = arrow.at("body"),
          .at = arrow.at("at").get<Double3>(),
          .direction = arrow.at("direction").get<Double3>(),
          .length = arrow.at("length"),
          .span = to_span(arrow)};
}

ForceArrowDefinition to_force_arrow(const Json& arrow) {
  return {.tool = arrow.at("tool"), .full = arrow.at("full"), .length = arrow.at("length"), .span = to_span(arrow)};
}

HighlightDefinition to_highlight(const Json& highlight) {
  const ShownSpan span = to_span(highlight);
  return {.body = highlight.at("body"),
          .center = highlight.at("at").get<Double3>(),
          .radius = highlight.at("radius"),
          .color = highlight.at("color").get<Double3>(),
          .begin = span.begin,
          .end = span.end};
}

std::optional<CardScenario> find_card(const Json& teaching, const char* key) {
  if (!teaching.contains(key)) return std::nullopt;
  const Json& card = teaching.at(key);
  return CardScenario{.title = card.at("title"), .text = card.value("text", ""), .duration = card.at("for")};
}

}  // namespace

void read_teaching(const std::string& resolved, Teaching& teaching, ViewDefinition& view) {
  teaching = {};
  view.highlights.clear();
  const Json scenario = Json::parse(resolved);
  if (!scenario.contains("teaching")) return;
  const Json& given = scenario.at("teaching");
  for (const Json& label : given.at("labels")) teaching.annotations.labels.push_back(to_label(label));
  for (const Json& arrow : given.at("arrows")) teaching.annotations.arrows.push_back(to_arrow(arrow));
  for (const Json& arrow : given.at("force_arrows")) {
    teaching.annotations.force_arrows.push_back(to_force_arrow(arrow));
  }
  for (const Json& highlight : given.at("highlights")) view.highlights.push_back(to_highlight(highlight));
  for (const Json& freeze : given.at("freezes")) {
    teaching.freezes.push_back({.at = freeze.at("at"), .duration = freeze.at("for")});
  }
  for (const Json& slow : given.at("slow_motion")) {
    teaching.slow_motions.push_back({.begin = slow.at("from"), .end = slow.at("until"), .speed = slow.at("speed")});
  }
  teaching.title_card = find_card(given, "title_card");
  teaching.end_card = find_card(given, "end_card");
}

}  // namespace thinwall
