#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "studio/record/Moment.hpp"
#include "studio/recorder/GroundTruthSeries.hpp"
#include "studio/recorder/Painter.hpp"
#include "studio/recorder/StageClock.hpp"
#include "studio/scenario/Scenario.hpp"
#include "studio/scenario/Teaching.hpp"
#include "studio/take/TakeWriter.hpp"

namespace thinwall {

/// What is to be left in a folder.
struct RecordingPlan {
  std::filesystem::path folder;
  TakeDescription description;
  OverlayChoice overlays;
  ViewDefinition view = {};  // its cameras and cuts
  Teaching teaching = {};
  ImageSize size;
  double frames_per_second = 30;
  bool records = true;            // take.h5, forces.csv, body.csv
  bool pictures = true;           // poster and contact sheet, and what of the next two is wanted
  bool video = true;              // video.mp4
  bool frames = false;            // frames/frame_000000.png, ...
  bool surfaces = false;          // surfaces/surfaces.pvd, ...
  bool ground_truth = false;      // ground_truth/..., of the pictures
  std::FILE* progress = nullptr;  // where the progress is shown; null: nowhere
};

struct RecordingTimes {
  StageTime simulate;  // making the moments
  StageTime write;     // take, CSV, surfaces
  StageTime render;    // pictures, with their overlays
  StageTime truth;     // ground truth
  StageTime encode;    // hashing, conversion, handing over to the encoder; its own processor time is of another process
  double total = 0;    // seconds of wall time
};

/// What a recording was.
struct RecordingReport {
  std::string failure;  // why the simulation could not go on; empty when it reached its end
  std::size_t steps = 0;
  double simulated = 0;                   // seconds
  double poster_time = 0;                 // seconds
  std::string driver;                     // of the pictures; empty without pictures
  std::string encoder;                    // what ffmpeg says of itself; empty without a video
  std::vector<std::string> frame_hashes;  // (frames) of the pictures before encoding
  std::vector<std::string> warnings;
  std::string state_digest;
  std::vector<TimedText> chapters;
  RecordingTimes times;
  std::vector<PassTime> passes = {};  // of the pictures, from a painter that times them, see Painter::pass_times
};

/// Records a source into the plan's folder. Simulation, rendering and encoding run at the same time in a thread each.
/// A file has its name only when it is whole. When the simulation fails, what it reached is recorded as a whole, and
/// the report says so. Throws PictureFailure, Interrupted, and what the source throws otherwise; then unfinished files
/// stay under their unfinished names.
RecordingReport record(MomentSource& source, const RecordingPlan& plan, const PainterFactory& painters);

}  // namespace thinwall
