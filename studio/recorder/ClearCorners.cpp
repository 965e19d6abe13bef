#include "studio/recorder/ClearCorners.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "renderer/annotation/MaterialPoint.hpp"
#include "renderer/camera/Camera.hpp"
#include "renderer/camera/PictureLayout.hpp"
#include "renderer/camera/SceneExtent.hpp"
#include "renderer/camera/Shot.hpp"
#include "renderer/image/OverlayUnit.hpp"
#include "renderer/overlay/CaptionPlace.hpp"
#include "renderer/snapshot/ActingSurfaces.hpp"
#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {
namespace {

constexpr int kLooks = 9;       // at each cut's pictures, evenly in time
constexpr double kSlack = 0.3;  // seconds, by which work may be done earlier or later than planned
constexpr double kAround = 24;  // overlay units, what belongs to a place: the tip of a tool, lips, a label's dot
// In order of preference: lower corners are next to panels.
constexpr PictureCorner kCorners[] = {PictureCorner::kUpperRight, PictureCorner::kUpperLeft, PictureCorner::kLowerRight,
                                      PictureCorner::kLowerLeft};

/// What a picture is about for some time.
struct Subject {
  std::vector<Double3> places;  // metres
  double begin = 0;             // seconds
  double end = 0;
};

std::vector<Subject> subjects_of(const CornerQuestion& question) {
  std::vector<Subject> subjects;
  for (const PlannedWork& work : question.work) {
    subjects.push_back({places_of(work, question.first), work.begin - kSlack, work.end + kSlack});
  }
  const auto point_at = [&](const std::string& body, const Double3& at, double begin, double end) {
    const auto wall = std::ranges::find(question.first.surfaces, body, &SnapshotSurface::body);
    if (wall == question.first.surfaces.end()) return;
    const auto point = nearest_material_point(*wall->topology, at);
    if (!point) return;
    const Vector3 place = place_of(*point, *wall);
    subjects.push_back({{Double3{place.x, place.y, place.z}}, begin, end});
  };
  const auto& [labels, arrows, forces] = question.annotations;
  for (const LabelDefinition& label : labels) point_at(label.body, label.at, label.span.begin, label.span.end);
  for (const ArrowDefinition& arrow : arrows) point_at(arrow.body, arrow.at, arrow.span.begin, arrow.span.end);
  for (const HighlightDefinition& mark : question.view.highlights) {
    point_at(mark.body, mark.center, mark.begin, mark.end);
  }
  return subjects;
}

/// About where the tip of a tool is, metres: on the way of the clip that is nearest in time, as far along it as time
/// is.
Double3 planned_tip(const CornerQuestion& question, const std::string& tool, double time) {
  const PlannedWork* nearest = nullptr;
  const auto off = [&](const PlannedWork& work) { return std::max({0.0, work.begin - time, time - work.end}); };
  for (const PlannedWork& work : question.work) {
    if (work.tool == tool && (nearest == nullptr || off(work) < off(*nearest))) nearest = &work;
  }
  if (nearest == nullptr) {
    const auto found = std::ranges::find(question.first.tools, tool, &SnapshotTool::name);
    return found == question.first.tools.end() ? Double3{} : found->tip;
  }
  const std::vector<Double3> way = places_of(*nearest, question.first);
  const double span = std::max(kSameTime, nearest->end - nearest->begin);
  const double part = std::clamp((time - nearest->begin) / span, 0.0, 1.0);
  return way[static_cast<std::size_t>(std::lround(part * static_cast<double>(way.size() - 1)))];
}

using PixelPlace = std::array<double, 2>;  // from the upper left

/// What pictures show somewhere, and how much of it.
struct SeenPlace {
  PixelPlace at = {};
  double weight = 1;
};

/// The pictures from one cut to the next.
struct CutPictures {
  Shot shot = {};
  bool chooses_corner = false;
  double begin = 0;  // seconds
  double end = 0;
  std::vector<SeenPlace> work = {};    // and what is pointed at
  std::vector<SeenPlace> organs = {};  // their vertices
};

/// A part of a picture with its camera.
struct PicturePart {
  PictureBox box;
  Camera camera;
};

std::optional<PixelPlace> seen_at(const PicturePart& part, Vector3 place) {
  const auto at = part.camera.pixel(place, part.box.size);
  if (!at || !part.camera.shows(*at, part.box.size)) return std::nullopt;
  return PixelPlace{(*at)[0] + part.box.left, (*at)[1] + part.box.top};
}

class Looking {
 public:
  explicit Looking(const CornerQuestion& question)
      : question_(question), extent_(scene_extent(question.first)), subjects_(subjects_of(question)) {}

  std::vector<CutPictures> cuts() const {
    std::vector<double> begins = {0};
    for (const CameraCut& cut : question_.view.cuts) begins.push_back(cut.time);
    std::vector<CutPictures> cuts;
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const bool is_last = i + 1 == begins.size();
      const double end = is_last ? std::max(begins[i], question_.end) : begins[i + 1];
      if (!is_last && end < begins[i] + kSameTime) continue;
      CutPictures cut{.shot = shot_at(question_.view, begins[i]), .begin = begins[i], .end = end};
      cut.chooses_corner = cut.shot.inset && (i == 0 || !question_.view.cuts[i - 1].corner);
      look_at(cut);
      cuts.push_back(std::move(cut));
    }
    return cuts;
  }

 private:
  void look_at(CutPictures& cut) const {
    const double half = 0.5 * (cut.end - cut.begin) / (kLooks - 1);
    for (int i = 0; i < kLooks; ++i) {
      const double time = cut.begin + 2 * half * i;
      for (const PicturePart& part : parts_of(cut.shot, time)) {
        for (const Subject& subject : subjects_) {
          if (subject.begin > time + half || subject.end < time - half) continue;
          const double weight = 1.0 / static_cast<double>(subject.places.size());
          for (const Double3& place : subject.places) add(part, vector3(place), weight, cut.work);
        }
        for (const SnapshotSurface* surface : acting_surfaces(question_.first)) {
          for (const Float3& position : surface->positions) add(part, vector3(position), 1, cut.organs);
        }
      }
    }
  }

  static void add(const PicturePart& part, Vector3 place, double weight, std::vector<SeenPlace>& seen) {
    if (const auto at = seen_at(part, place)) seen.push_back({*at, weight});
  }

  std::vector<PicturePart> parts_of(const Shot& shot, double time) const {
    Shot both = shot;
    if (question_.view.comparison) both.beside = shot_at(question_.view.comparison->second, time).camera;
    std::vector<PicturePart> parts;
    const auto add_part = [&](const PictureBox& box, CameraDefinition camera) {
      if (camera.orbit_speed != 0) camera.orbit_end = question_.end;
      if (camera.follow) camera.followed_point = planned_tip(question_, camera.follow->tool, time);
      parts.push_back({box, resolve_camera(camera, extent_, box.size, time)});
    };
    add_part(main_box(both, question_.size), both.camera);
    if (both.beside) add_part(beside_box(question_.size), *both.beside);
    return parts;
  }

  const CornerQuestion& question_;
  SceneExtent extent_;
  std::vector<Subject> subjects_;
};

/// How much boxes cover, and how badly they stand: each counts where those before it are equal.
struct Cover {
  double work = 0;
  int jumps = 0;  // of a legend that gives way to the insets of some cuts alone
  double organs = 0;
  bool operator<(const Cover& other) const {
    return std::tie(work, jumps, organs) < std::tie(other.work, other.jumps, other.organs);
  }
};

double covered(const Box& box, double around, const std::vector<SeenPlace>& seen) {
  double weight = 0;
  for (const auto& [at, part] : seen) {
    const bool is_within = at[0] > box.x - around && at[0] < box.right() + around && at[1] > box.y - around &&
                           at[1] < box.bottom() + around;
    if (is_within) weight += part;
  }
  return weight;
}

Cover cover_of(const Box& box, const CutPictures& cut, ImageSize size) {
  return {.work = covered(box, kAround * overlay_unit(size), cut.work), .organs = covered(box, 0, cut.organs)};
}

/// `cover`: of a corner.
template <typename CoverOf>
PictureCorner clearest(bool is_upper_alone, const CoverOf& cover) {
  PictureCorner best = kCorners[0];
  Cover least = cover(best);
  if (least.work == 0 && least.jumps == 0) return best;
  for (const PictureCorner corner : kCorners) {
    if (is_upper_alone && !is_upper(corner)) continue;
    const Cover here = cover(corner);
    if (here < least) best = corner, least = here;
  }
  return best;
}

std::optional<Box> inset_of(const Shot& shot, ImageSize size) {
  if (!shot.inset) return std::nullopt;
  const PictureBox box = inset_box(shot, size);
  return Box{static_cast<double>(box.left), static_cast<double>(box.top), static_cast<double>(box.size.width),
             static_cast<double>(box.size.height)};
}

/// The legends in all cuts, whose insets have their places.
Cover cover_of_legends(const CornerQuestion& question, PictureCorner corner, const std::vector<CutPictures>& cuts) {
  OverlayContent content = question.legends;
  for (auto* legend : {&content.legend, &content.left_legend}) {
    if (*legend) (*legend)->corner = corner;
  }
  Cover sum;
  const auto places_in = [&](const CutPictures& cut) {
    return places_of_legends(content, question.size, inset_of(cut.shot, question.size));
  };
  for (const CutPictures& cut : cuts) {
    const std::vector<Box> places = places_in(cut);
    if (places != places_in(cuts.front())) ++sum.jumps;
    for (const Box& place : places) {
      const Cover cover = cover_of(place, cut, question.size);
      sum.work += cover.work;
      sum.organs += cover.organs;
    }
  }
  return sum;
}

/// The captions of two halves stand in the upper left of each.
PictureCorner legend_corner(const CornerQuestion& question, PictureCorner corner) {
  return question.view.comparison && corner == PictureCorner::kUpperLeft ? PictureCorner::kLowerLeft : corner;
}

std::optional<PictureCorner> wanted_for_legends(const ViewDefinition& view) {
  if (view.look.data && view.look.data->legend) return view.look.data->legend;
  if (view.comparison && view.comparison->second.look.data) return view.comparison->second.look.data->legend;
  return std::nullopt;
}

bool has_free_inset(const ViewDefinition& view) {
  return std::ranges::any_of(view.cuts, [](const CameraCut& cut) { return cut.inset && !cut.corner; });
}

}  // namespace

ClearCorners::ClearCorners(const CornerQuestion& question) {
  const std::optional<PictureCorner> wanted = wanted_for_legends(question.view);
  if (wanted) legend_ = legend_corner(question, *wanted);
  const bool is_legend_free = (question.legends.legend || question.legends.left_legend) && !wanted;
  if (!is_legend_free && !has_free_inset(question.view)) return;
  std::vector<CutPictures> cuts = Looking(question).cuts();
  for (CutPictures& cut : cuts) {
    Shown& shown = cuts_.emplace_back(Shown{.begin = cut.begin});
    if (!cut.chooses_corner) continue;
    cut.shot.corner = clearest(captions_stand_above_panels(question.size), [&](PictureCorner corner) {
      Shot placed = cut.shot;
      placed.corner = corner;
      return cover_of(*inset_of(placed, question.size), cut, question.size);
    });
    shown.corner = cut.shot.corner;
  }
  if (!is_legend_free) return;
  legend_ = legend_corner(question, clearest(false, [&](PictureCorner corner) {
                            return cover_of_legends(question, legend_corner(question, corner), cuts);
                          }));
}

std::optional<PictureCorner> ClearCorners::inset(double time) const {
  std::optional<PictureCorner> corner;
  for (const Shown& shown : cuts_) {
    if (shown.begin <= time + kSameTime) corner = shown.corner;
  }
  return corner;
}

}  // namespace thinwall
