#include "studio/scenario/CameraLint.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "renderer/camera/LensFold.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/scenario/CheckedReading.hpp"
#include "studio/scenario/Parallel.hpp"
#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Quantity.hpp"

namespace thinwall {
namespace {

/// Of a keyframe, or of its camera where the keyframe leaves it out.
const CheckedValue* find_own(const CheckedValue& keyframe, const CheckedValue& camera, std::string_view key) {
  const CheckedValue* own = keyframe.find(key);
  return own != nullptr ? own : camera.find(key);
}

void check_camera_up(const CheckedValue& camera, const std::string& path, Diagnostics& diagnostics) {
  const auto position = find_vector(camera, "position"), target = find_vector(camera, "target");
  const auto up = find_vector(camera, "up");
  if (!position || !target) return;
  if (*position == *target) {
    diagnostics.error(camera.at("target").location, path + ".target", "the camera stands where it looks");
  } else if (up && are_parallel(*up, *target - *position)) {
    diagnostics.error(camera.at("up").location, path + ".up", "the camera looks along `up`");
  }
}

void check_keyframe_ups(const CheckedValue& camera, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* keyframes = camera.find("keyframes");
  for (std::size_t i = 0; keyframes != nullptr && i < keyframes->items.size(); ++i) {
    const CheckedValue& keyframe = keyframes->items[i];
    const CheckedValue *position = find_own(keyframe, camera, "position"),
                       *target = find_own(keyframe, camera, "target");
    const CheckedValue* up = find_own(keyframe, camera, "up");
    if (position == nullptr || target == nullptr || up == nullptr) continue;
    const Eigen::Vector3d view = to_vector(*target) - to_vector(*position);
    if (view.isZero(0) || !are_parallel(to_vector(*up), view)) continue;
    const std::string inner = item_path(path + ".keyframes", i);
    if (keyframe.find("up") != nullptr) {
      diagnostics.error(up->location, inner + ".up", "the camera looks along `up`");
    } else {
      diagnostics.error(keyframe.location, inner, "the camera looks along its `up` here; give the keyframe one");
    }
  }
}

/// The widest shape that each camera fills of pictures of `size`, by its name. Those that are never shown are not
/// there.
class ShownShapes {
 public:
  ShownShapes(const CheckedValue& root, ImageSize size)
      : size_(size), is_compared_(root.find("comparison") != nullptr) {
    const CheckedValue* cuts = root.find("cuts");
    const auto first = cuts == nullptr || cuts->items.empty() ? std::nullopt : find_number(cuts->items[0], "at");
    if (!first || *first > kSameTime) show("main", is_compared_);
    for (std::size_t i = 0; cuts != nullptr && i < cuts->items.size(); ++i) add_cut(cuts->items[i]);
  }

  std::optional<ImageSize> find(const std::string& camera) const {
    const auto found = shapes_.find(camera);
    return found == shapes_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  void add_cut(const CheckedValue& cut) {
    const auto beside = find_text(cut, "beside"), inset = find_text(cut, "inset");
    const bool is_half = is_compared_ || beside;
    show(find_text(cut, "camera").value_or("main"), is_half);
    if (beside) show(*beside, true);
    if (inset) widen(*inset, inset_box(shot_of(is_half), size_).size);
  }

  static Shot shot_of(bool is_half) {
    Shot shot;
    if (is_half) shot.beside = CameraDefinition{};
    return shot;
  }

  void show(const std::string& camera, bool is_half) { widen(camera, main_box(shot_of(is_half), size_).size); }

  void widen(const std::string& camera, ImageSize shape) {
    const auto [known, is_new] = shapes_.insert({camera, shape});
    ImageSize& widest = known->second;
    if (!is_new && shape.width * widest.height > widest.width * shape.height) widest = shape;
  }

  ImageSize size_;
  bool is_compared_;
  std::map<std::string, ImageSize> shapes_;
};

LensDistortion distortion_of(const CheckedValue& lens) {
  const auto number = [&](const char* key) { return find_number(lens, key).value_or(0); };
  return {.k1 = number("k1"), .k2 = number("k2"), .p1 = number("p1"), .p2 = number("p2"), .k3 = number("k3")};
}

/// What is wrong with a lens at a field of view (radians), in words; empty where nothing is.
std::string fold_in_words(const CheckedValue& camera, double field_of_view, ImageSize shape) {
  const CameraKind kind = find_text(camera, "kind") == "endoscope" ? CameraKind::kEndoscope : CameraKind::kPinhole;
  const double widest = unfolded_field_of_view(kind, distortion_of(camera.at("lens")), field_of_view, shape);
  if (widest == field_of_view) return {};
  // Rounded down, so that what is told is good.
  const double tenth = std::numbers::pi / 1800;
  return "the lens folds the picture over before its border at a field of view of " +
         format_like(field_of_view, "30 deg") + "; take one of at most " +
         format_like(tenth * std::floor(widest / tenth), "30 deg") + ", or coefficients nearer to 0";
}

/// The camera's own field of view is seen but where each keyframe has another.
void check_lens(const CheckedValue& camera, const std::string& path, ImageSize shape, Diagnostics& diagnostics) {
  const CheckedValue* lens = camera.find("lens");
  if (lens == nullptr) return;
  const CheckedValue* keyframes = camera.find("keyframes");
  bool shows_own = keyframes == nullptr || keyframes->items.empty();
  for (std::size_t i = 0; keyframes != nullptr && i < keyframes->items.size(); ++i) {
    const CheckedValue* angle = keyframes->items[i].find("field_of_view");
    shows_own = shows_own || angle == nullptr;
    if (angle == nullptr) continue;
    const std::string mistake = fold_in_words(camera, angle->number, shape);
    if (mistake.empty()) continue;
    diagnostics.error(angle->location, item_path(path + ".keyframes", i) + ".field_of_view", mistake);
  }
  const auto own = find_number(camera, "field_of_view");
  if (!shows_own || !own) return;
  const std::string mistake = fold_in_words(camera, *own, shape);
  if (!mistake.empty()) diagnostics.error(lens->location, path + ".lens", mistake);
}

std::optional<ImageSize> picture_size(const CheckedValue& root) {
  const CheckedValue* record = root.find("record");
  const auto* size = record == nullptr ? nullptr : record->find("size");
  if (size == nullptr || size->items.size() != 2) return std::nullopt;
  return ImageSize{.width = static_cast<int>(size->items[0].number), .height = static_cast<int>(size->items[1].number)};
}

}  // namespace

void check_cameras(const CheckedValue& root, Diagnostics& diagnostics) {
  const std::optional<ImageSize> size = picture_size(root);
  std::optional<ShownShapes> shown;
  if (size) shown.emplace(root, *size);
  const auto check = [&](const CheckedValue& camera, const std::string& name, const std::string& path) {
    check_camera_up(camera, path, diagnostics);
    check_keyframe_ups(camera, path, diagnostics);
    const std::optional<ImageSize> shape = shown ? shown->find(name) : std::nullopt;
    if (shape) check_lens(camera, path, *shape, diagnostics);
  };
  if (const CheckedValue* camera = root.find("camera")) check(*camera, "main", "camera");
  const CheckedValue* cameras = root.find("cameras");
  if (cameras == nullptr) return;
  for (const CheckedMember& member : cameras->members) {
    check(member.value, member.key, member_path("cameras", member.key));
  }
}

}  // namespace thinwall
