#include "studio/commands/CompareArguments.hpp"

#include "studio/commands/ExitCode.hpp"
#include "studio/recorder/Interruption.hpp"

namespace thinwall {
namespace {

WantedFigures wanted_figures(const std::string& metric) {
  if (metric == "pixels") return {};
  if (metric == "ssim") return {.structure = true, .flip = false};
  if (metric == "flip") return {.structure = false, .flip = true};
  if (metric == "all") return {.structure = true, .flip = true};
  throw UsageError("--metric " + metric + ": write pixels, ssim, flip or all");
}

LayerKind layer_kind(const std::string& word) {
  for (const LayerKind kind : {LayerKind::kDepth, LayerKind::kNormal, LayerKind::kIds, LayerKind::kFlow}) {
    if (word == layer_name(kind)) return kind;
  }
  throw UsageError("--layer " + word + ": write depth, normals, ids or flow");
}

}  // namespace

CompareOptions compare_options(const CompareArguments& arguments) {
  CompareOptions options = arguments.options;
  options.comparison.wanted = wanted_figures(arguments.metric);
  options.comparison.between_frames = throw_if_interrupted;
  if (!arguments.mask.empty()) options.comparison.mask = arguments.mask;
  if (!arguments.difference.empty()) {
    options.difference = arguments.difference;
    options.comparison.wants_picture = true;
  }
  PictureLimits& limits = options.comparison.limits;
  // Excuses for pixels mean that no other may fail.
  if (!limits.failing && (limits.tolerance.level > 0 || limits.tolerance.shift > 0)) limits.failing = 0;
  if (arguments.layer.empty()) {
    if (arguments.tolerance || arguments.edge_band) {
      throw UsageError("--tolerance and --edge-band are for layers: say which with --layer");
    }
    return options;
  }
  if (limits.largest || limits.mean || limits.drift || limits.structure || limits.flip || limits.flip_99 ||
      limits.tolerance.level > 0 || limits.tolerance.shift > 0 || options.comparison.wanted.structure ||
      options.comparison.wanted.flip) {
    throw UsageError(
        "--layer: a layer has the limits --tolerance, --edge-band and --failing, and neither limits nor metrics of "
        "pictures");
  }
  if (!arguments.difference.empty()) throw UsageError("--diff: there is no picture of what differs in a layer");
  LayerChoice layer{.kind = layer_kind(arguments.layer)};
  if (arguments.tolerance) layer.tolerance.difference = *arguments.tolerance;
  if (arguments.edge_band) layer.tolerance.edge_band = *arguments.edge_band;
  layer.failing = limits.failing.value_or(0);
  options.comparison.layer = layer;
  return options;
}

}  // namespace thinwall
