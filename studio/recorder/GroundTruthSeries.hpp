#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/ground_truth/GroundTruth.hpp"
#include "studio/recorder/CocoAnnotations.hpp"
#include "studio/recorder/FrameComposer.hpp"
#include "studio/recorder/PoseTables.hpp"

namespace thinwall {

/// What ground truth depends on besides the frames.
struct GroundTruthPlan {
  std::filesystem::path folder;  // that will be made
  ImageSize size;
  std::map<std::string, std::string> organs = {};  // kinds of tissue by the names of bodies
  LookDefinition look = {};                        // as in the pictures
};

/// Ground truth of a recording: a folder for each layer with a file for each frame, and what tells of all frames
/// (README.md of the project, section "Ground truth"). Frames are written once the next one is known, which the forward
/// flow needs.
class GroundTruthSeries {
 public:
  /// Collects under the folder's unfinished name. Throws PictureFailure.
  explicit GroundTruthSeries(GroundTruthPlan plan);

  /// The next frame, in order of time. Throws PictureFailure, also when the snapshot holds no stress.
  void add(const Frame& frame);

  /// Gives the folder its name. Throws PictureFailure.
  void finish();

  /// Writes the layers of one frame alone, between its neighbours where there are any: the very bytes that a series has
  /// for it, under the number 0. Gives the folder its name.
  static void write_still(GroundTruthPlan plan, const std::optional<Frame>& before, const Frame& now,
                          const std::optional<Frame>& after);

 private:
  std::unique_ptr<SeenFrame> seen(const Frame& frame) const;
  void write(const SeenFrame* before, const SeenFrame& now, const SeenFrame* after);
  void write_layers(const GroundTruth& truth);
  void write_flow(const std::string& name, const SeenFrame& from, const SeenFrame* to);
  void write_file(const std::string& layer, const std::string& extension, const std::vector<std::uint8_t>& bytes);
  void write_tables();
  std::vector<std::uint16_t> materials_of(const GroundTruth& truth) const;

  GroundTruthPlan plan_;
  std::unique_ptr<SeenFrame> before_;
  std::unique_ptr<SeenFrame> now_;  // not yet written
  std::size_t frames_ = 0;
  std::vector<std::string> instances_;    // (instances) names of bodies, then of tools
  std::vector<std::uint16_t> materials_;  // (instances)
  CocoAnnotations annotations_;
  PoseTables poses_;
};

inline constexpr double kDepthStep = 1e-5;  // metres, of a level of the 16-bit depth

/// Within the folder of a recording.
inline constexpr const char* kGroundTruthFolder = "ground_truth";

/// Names of the layers' folders.
extern const std::array<const char*, 15> kGroundTruthLayers;

}  // namespace thinwall
