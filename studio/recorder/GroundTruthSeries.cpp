#include "studio/recorder/GroundTruthSeries.hpp"

#include <fmt/format.h>

#include <oneapi/tbb/parallel_invoke.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/image/ExrFile.hpp"
#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "renderer/shape/WoundBed.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint16_t kSteel = 1;
constexpr const char* kForward = "forward";
constexpr const char* kBackward = "backward";

/// KITTI's flow: 64 steps to a pixel around the middle of 16 bits (Menze and Geiger 2015).
constexpr double kKittiSteps = 64;
constexpr double kKittiMiddle = 32768;

/// Numbers of materials mean the same in all recordings: steel, then the kinds of tissue in the order of their table.
std::uint16_t material_of_organ(const std::string& organ) {
  const auto looks = organ_looks();
  const auto found = std::ranges::find(looks, organ, &OrganLook::organ);
  const auto index = found == looks.end() ? 0 : found - looks.begin();
  return static_cast<std::uint16_t>(kSteel + 1 + index);
}

std::vector<CocoCategory> categories() {
  std::vector<CocoCategory> result = {{.id = kSteel, .name = "steel", .supercategory = "tool"}};
  for (const OrganLook& look : organ_looks()) {
    const std::string organ(look.organ);
    result.push_back({.id = material_of_organ(organ), .name = organ, .supercategory = "tissue"});
  }
  return result;
}

FloatLayer gray(ImageSize size, const std::vector<float>& values) {
  return {.size = size, .channels = 1, .values = values};
}

WordLayer gray(ImageSize size, const std::vector<std::uint16_t>& values) {
  return {.size = size, .channels = 1, .values = values};
}

template <typename Word>
ByteLayer words(ImageSize size, const std::vector<Word>& values) {
  ByteLayer layer{.size = size, .channels = 1, .values = {}};
  for (const Word value : values) layer.values.push_back(static_cast<std::uint8_t>(value));
  return layer;
}

FloatLayer vectors(ImageSize size, const std::vector<std::array<float, 3>>& values) {
  FloatLayer layer{.size = size, .channels = 3, .values = {}};
  for (const auto& value : values) layer.values.insert(layer.values.end(), value.begin(), value.end());
  return layer;
}

WordLayer depth_levels(ImageSize size, const std::vector<float>& depth) {
  WordLayer layer{.size = size, .channels = 1, .values = {}};
  for (const float value : depth) {
    layer.values.push_back(static_cast<std::uint16_t>(std::min(65535L, std::lround(value / kDepthStep))));
  }
  return layer;
}

FloatLayer flow_vectors(ImageSize size, const OpticalFlow& flow) {
  FloatLayer layer{.size = size, .channels = 3, .values = {}};
  for (std::size_t pixel = 0; pixel < flow.flow.size(); ++pixel) {
    const float known = flow.is_known[pixel] ? 1.0F : 0.0F;
    layer.values.insert(layer.values.end(), {flow.flow[pixel][0], flow.flow[pixel][1], known});
  }
  return layer;
}

/// What is too long for the format counts as unknown.
WordLayer kitti_flow(ImageSize size, const OpticalFlow& flow) {
  WordLayer layer{.size = size, .channels = 3, .values = {}};
  for (std::size_t pixel = 0; pixel < flow.flow.size(); ++pixel) {
    const double u = std::round(kKittiSteps * flow.flow[pixel][0] + kKittiMiddle);
    const double v = std::round(kKittiSteps * flow.flow[pixel][1] + kKittiMiddle);
    const bool fits = flow.is_known[pixel] && u >= 0 && u <= 65535 && v >= 0 && v <= 65535;
    layer.values.insert(layer.values.end(),
                        {static_cast<std::uint16_t>(fits ? u : 0), static_cast<std::uint16_t>(fits ? v : 0),
                         static_cast<std::uint16_t>(fits ? 1 : 0)});
  }
  return layer;
}

/// Whether a card covers the whole picture: nothing of the scene lands in it or beside it.
bool is_card(const SeenFrame& frame) {
  const PicturePart& part = frame.part();
  return part.covered && part.covered->size == part.picture;
}

Json layer_part() {
  const Json state = {{"0", "nothing seen, or no such frame, or a card there"},
                      {"1", "seen in the other frame"},
                      {"2", "hidden in the other frame"},
                      {"3", "outside the other frame"},
                      {"4", "not there in the other frame"}};
  const auto flow = [](const char* other) {
    return Json{{"unit", "px"},
                {"content", std::string("R, G: to where it is in the ") + other +
                                " frame, x to the right, y down; B: 1 where known"}};
  };
  const Json kitti = {{"content", "KITTI: (R - 32768) / 64, (G - 32768) / 64 px where B is 1"}};
  return {{"depth", {{"unit", "m"}, {"content", "along the line of sight"}}},
          {"depth_16", {{"unit", "m"}, {"step", kDepthStep}, {"content", "65535: that or farther"}}},
          {"normals", {{"content", "R, G, B: x to the right, y down, z away from the camera"}}},
          {"instances", {{"content", "numbers, see instances"}}},
          {"parts", {{"content", "numbers, see parts"}}},
          {"materials", {{"content", "numbers, see materials"}}},
          {"forward_flow", flow("next")},
          {"forward_flow_kitti", kitti},
          {"forward_state", state},
          {"backward_flow", flow("previous")},
          {"backward_flow_kitti", kitti},
          {"backward_state", state},
          {"stress", {{"unit", "Pa"}, {"content", "von Mises"}}},
          {"contact_pressure", {{"unit", "Pa"}}},
          {"wound",
           {{"0", "none"},
            {"1", "face of a cut"},
            {"2", "inside, seen through an opening"},
            {"3", "nothing of the scene, seen through an opening"}}}};
}

}  // namespace

const std::array<const char*, 15> kGroundTruthLayers = {"depth",
                                                        "depth_16",
                                                        "normals",
                                                        "instances",
                                                        "parts",
                                                        "materials",
                                                        "forward_flow",
                                                        "forward_flow_kitti",
                                                        "forward_state",
                                                        "backward_flow",
                                                        "backward_flow_kitti",
                                                        "backward_state",
                                                        "stress",
                                                        "contact_pressure",
                                                        "wound"};

GroundTruthSeries::GroundTruthSeries(GroundTruthPlan plan) : plan_(std::move(plan)), annotations_(categories()) {
  for (const char* layer : kGroundTruthLayers) make_folder(unfinished_name(plan_.folder) / layer);
}

std::unique_ptr<SeenFrame> GroundTruthSeries::seen(const Frame& frame) const {
  return std::make_unique<SeenFrame>(laid_on_beds(frame.snapshot, plan_.look), frame.shot, plan_.size,
                                     drawn_edges(plan_.look), frame.card.has_value());
}

void GroundTruthSeries::add(const Frame& frame) {
  auto next = seen(frame);
  if (now_) write(before_.get(), *now_, next.get());
  before_ = std::move(now_);
  now_ = std::move(next);
}

void GroundTruthSeries::finish() {
  if (now_) write(before_.get(), *now_, nullptr);
  write_tables();
  rename_folder(unfinished_name(plan_.folder), plan_.folder);
}

void GroundTruthSeries::write_still(GroundTruthPlan plan, const std::optional<Frame>& before, const Frame& now,
                                    const std::optional<Frame>& after) {
  GroundTruthSeries series(std::move(plan));
  const auto earlier = before ? series.seen(*before) : nullptr, later = after ? series.seen(*after) : nullptr;
  series.write(earlier.get(), *series.seen(now), later.get());
  series.write_tables();
  rename_folder(unfinished_name(series.plan_.folder), series.plan_.folder);
}

void GroundTruthSeries::write(const SeenFrame* before, const SeenFrame& now, const SeenFrame* after) {
  const Snapshot& snapshot = now.snapshot();
  if (frames_ == 0) {
    for (const SnapshotSurface& surface : snapshot.surfaces) {
      instances_.push_back(surface.body);
      const auto organ = plan_.organs.find(surface.body);
      materials_.push_back(material_of_organ(organ == plan_.organs.end() ? "" : organ->second));
    }
    for (const SnapshotTool& tool : snapshot.tools) {
      instances_.push_back(tool.name);
      materials_.push_back(kSteel);
    }
  }
  const GroundTruth truth = ground_truth(now);
  // Compressing takes the most time; no file knows of another.
  tbb::parallel_invoke([&] { write_flow(kForward, now, after); }, [&] { write_flow(kBackward, now, before); },
                       [&] { write_layers(truth); });
  annotations_.add(frames_, truth.size, truth.instances, materials_);
  poses_.add(frames_, snapshot.time, now.camera(), now.part(), snapshot.tools);
  ++frames_;
}

void GroundTruthSeries::write_layers(const GroundTruth& truth) {
  if (truth.von_mises.empty() || truth.contact_pressure.empty()) {
    throw PictureFailure("ground truth needs the stress of the walls, which the snapshot does not hold");
  }
  tbb::parallel_invoke(
      [&] { write_file("depth", "exr", encode_exr(gray(truth.size, truth.depth))); },
      [&] { write_file("depth_16", "png", encode_layer_png(depth_levels(truth.size, truth.depth))); },
      [&] { write_file("normals", "exr", encode_exr(vectors(truth.size, truth.normals), ExrNumbers::kHalf)); },
      [&] { write_file("instances", "png", encode_layer_png(gray(truth.size, truth.instances))); },
      [&] { write_file("parts", "png", encode_layer_png(gray(truth.size, truth.parts))); },
      [&] { write_file("materials", "png", encode_layer_png(gray(truth.size, materials_of(truth)))); },
      [&] { write_file("stress", "exr", encode_exr(gray(truth.size, truth.von_mises))); },
      [&] { write_file("contact_pressure", "exr", encode_exr(gray(truth.size, truth.contact_pressure))); },
      [&] { write_file("wound", "png", encode_layer_png(words(truth.size, truth.wound))); });
}

void GroundTruthSeries::write_flow(const std::string& name, const SeenFrame& from, const SeenFrame* to) {
  const ImageSize size = from.seen().size;
  OpticalFlow flow(from.seen().places.size());
  if (to != nullptr && !is_card(*to)) flow = optical_flow(from.moment(), to->moment());
  tbb::parallel_invoke([&] { write_file(name + "_flow", "exr", encode_exr(flow_vectors(size, flow))); },
                       [&] { write_file(name + "_flow_kitti", "png", encode_layer_png(kitti_flow(size, flow))); },
                       [&] { write_file(name + "_state", "png", encode_layer_png(words(size, flow.state))); });
}

void GroundTruthSeries::write_file(const std::string& layer, const std::string& extension,
                                   const std::vector<std::uint8_t>& bytes) {
  write_whole_file(unfinished_name(plan_.folder) / layer / fmt::format("frame_{:06}.{}", frames_, extension),
                   std::span(bytes));
}

std::vector<std::uint16_t> GroundTruthSeries::materials_of(const GroundTruth& truth) const {
  std::vector<std::uint16_t> materials;
  for (const std::uint16_t instance : truth.instances) {
    materials.push_back(instance == 0 ? std::uint16_t{0} : materials_[instance - 1U]);
  }
  return materials;
}

void GroundTruthSeries::write_tables() {
  constexpr std::array kKinds = {"outside", "cap", "rim", "lining", "tool"};
  Json instances = Json::object(), parts = Json::object(), materials = Json::object();
  for (std::size_t k = 0; k < instances_.size(); ++k) {
    instances[std::to_string(k + 1)] = {{"name", instances_[k]}, {"material", materials_[k]}};
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
      if ((materials_[k] == kSteel) != (kind + 1 == kKinds.size())) continue;
      parts[std::to_string(kPartKinds * k + 1 + kind)] = {{"instance", k + 1}, {"kind", kKinds[kind]}};
    }
  }
  for (const CocoCategory& category : categories()) materials[std::to_string(category.id)] = category.name;
  const Json description = {{"format", "thinwall ground truth"},
                            {"format_version", 1},
                            {"frames", frames_},
                            {"size", {plan_.size.width, plan_.size.height}},
                            {"layers", layer_part()},
                            {"left_out", {"fluid", "run-off", "drops", "blood", "bed", "right half", "inset", "card"}},
                            {"instances", std::move(instances)},
                            {"parts", std::move(parts)},
                            {"materials", std::move(materials)}};
  const std::filesystem::path folder = unfinished_name(plan_.folder);
  write_whole_file(folder / "ground_truth.json",
                   description.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  write_whole_file(folder / "annotations.json", annotations_.json());
  write_whole_file(folder / "cameras.csv", poses_.cameras());
  write_whole_file(folder / "tools.csv", poses_.tools());
  write_whole_file(folder / "intrinsics.yml", poses_.intrinsics());
}

}  // namespace thinwall
