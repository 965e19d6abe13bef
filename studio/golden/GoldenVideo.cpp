#include "studio/golden/GoldenVideo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/image/ImageDifference.hpp"
#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/metric/Drift.hpp"
#include "renderer/video/FrameReader.hpp"
#include "renderer/video/MediaProbe.hpp"
#include "renderer/video/VideoSurvey.hpp"
#include "studio/golden/NamedFiles.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/recorder/Recorder.hpp"

namespace thinwall {
namespace {

// Containers keep times in ticks of a thousandth of a second.
constexpr double kSameFrameTime = 1.1e-3;
constexpr std::size_t kColumns = 4;
constexpr std::size_t kRows = 3;

/// A hash of hashes, in order.
class HashChain {
 public:
  void add(const std::string& hash) {
    const Image link{.size = {.width = 1, .height = 1}, .pixels = {last_.begin(), last_.end()}};
    Image joined = link;
    joined.pixels.insert(joined.pixels.end(), hash.begin(), hash.end());
    last_ = image_hash(joined);
  }
  const std::string& value() const { return last_; }

 private:
  std::string last_;
};

/// Hashes what is painted, before anything is written over it.
class HashingPainter final : public Painter {
 public:
  HashingPainter(std::unique_ptr<Painter> painter, HashChain& chain) : painter_(std::move(painter)), chain_(chain) {}
  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    Image image = painter_->paint(snapshot, shot);
    chain_.add(image_hash(image));
    return image;
  }
  std::string driver() const override { return painter_->driver(); }

 private:
  std::unique_ptr<Painter> painter_;
  HashChain& chain_;
};

/// Lets a history see every moment that passes.
class HistorySource final : public MomentSource {
 public:
  explicit HistorySource(std::unique_ptr<MomentSource> source) : source_(std::move(source)) {}
  std::optional<Moment> next() override {
    std::optional<Moment> moment = source_->next();
    if (moment) add_step(history_, step_++, *moment);
    return moment;
  }
  std::vector<std::string> warnings() const override { return source_->warnings(); }
  std::string state_digest() const override { return source_->state_digest(); }
  std::string second_state_digest() const override { return source_->second_state_digest(); }
  const GoldenHistory& history() const { return history_; }

 private:
  std::unique_ptr<MomentSource> source_;
  GoldenHistory history_;
  std::size_t step_ = 0;
};

std::string squares_of(const Image& image) {
  std::array<std::uint64_t, kColumns * kRows * 3> sums{};
  std::array<std::uint64_t, kColumns * kRows> counts{};
  const auto width = static_cast<std::size_t>(image.size.width);
  const auto height = static_cast<std::size_t>(image.size.height);
  for (std::size_t i = 0; i < width * height; ++i) {
    const std::size_t square = i / width * kRows / height * kColumns + i % width * kColumns / width;
    ++counts[square];
    for (std::size_t channel = 0; channel < 3; ++channel) sums[3 * square + channel] += image.pixels[3 * i + channel];
  }
  std::string text;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const std::uint64_t count = std::max<std::uint64_t>(1, counts[k / 3]);
    text += fmt::format("{:02x}", (sums[k] + count / 2) / count);
  }
  return text;
}

/// The size of goldens, even in both directions, as colours of half the resolution need it.
ImageSize video_size(ImageSize recorded) {
  const ImageSize size = golden_size(recorded);
  return {.width = size.width / 2 * 2, .height = size.height / 2 * 2};
}

std::filesystem::path frame_file(const std::filesystem::path& folder, std::size_t frame) {
  return folder / "frames" / fmt::format("frame_{:06}.png", frame);
}

/// Frames are shown at N / fps.
std::string wrong_times(const MediaProbe& probe, double frames_per_second) {
  for (std::size_t i = 0; i < probe.times.size(); ++i) {
    const double wanted = static_cast<double>(i) / frames_per_second;
    if (std::abs(probe.times[i] - wanted) > kSameFrameTime) {
      return fmt::format("frame {} is shown at {:.4f} s instead of {:.4f} s", i, probe.times[i], wanted);
    }
  }
  return "";
}

RecordingPlan plan_of(const Scenario& scenario, const std::filesystem::path& folder, bool encodes) {
  return {.folder = folder,
          .description = {.name = scenario.name, .title = scenario.title, .resolved = scenario.resolved},
          .overlays = scenario.overlays,
          .view = scenario.view,
          .teaching = scenario.teaching,
          .size = video_size(scenario.record.size),
          .frames_per_second = scenario.record.frames_per_second,
          .records = false,
          .pictures = true,
          .video = encodes,
          .frames = true};
}

/// Throws PictureFailure when a device or the encoder fails.
void record_frames(RecordedVideo& result, const Scenario& scenario, const SourceFactory& sources,
                   const PainterFactory& painters, const std::filesystem::path& folder, bool encodes) {
  HashChain chain;
  HistorySource source(sources(scenario));
  const RecordingReport report = record(source, plan_of(scenario, folder, encodes), [&](ImageSize size) {
    return std::make_unique<HashingPainter>(painters(size), chain);
  });
  GoldenVideo& video = result.video;
  video.driver = report.driver;
  result.missing = report.failure;
  video.frames.clear();
  for (const std::string& hash : report.frame_hashes) {
    throw_if_interrupted();
    video.frames.push_back({.hash = hash, .squares = squares_of(read_png(frame_file(folder, video.frames.size())))});
  }
  video.captions = bytes_of_file(folder / "captions.vtt");
  video.state_digest = report.state_digest;
  video.second_state_digest = source.second_state_digest();
  video.scene_hash = chain.value();
  video.history = history_text(source.history());
}

}  // namespace

EncodedVideo read_encoded_video(const std::filesystem::path& folder, const GoldenVideo& video) {
  const std::filesystem::path file = folder / "video.mp4";
  const MediaProbe probe = probe_media(file);
  EncodedVideo encoded;
  encoded.program = program_version("ffmpeg");
  encoded.tags = probe.codec + " " + probe.pixel_format + " " + probe.color;
  encoded.times = wrong_times(probe, video.frames_per_second);
  encoded.captions = probe.has_captions ? read_captions(file) : "";
  encoded.chapters = probe.chapters;
  FrameReader reader(file, probe.size, FramePixels::kRgb8);
  Image decoded{.size = probe.size, .pixels = std::vector<std::uint8_t>(frame_bytes(probe.size, FramePixels::kRgb8))};
  HashChain chain;
  for (; reader.next(decoded.pixels); ++encoded.frames) {
    throw_if_interrupted();
    chain.add(image_hash(decoded));
    if (encoded.frames >= video.frames.size() || probe.size != video.size) continue;
    const Image given = read_png(frame_file(folder, encoded.frames));
    encoded.loss = std::max(encoded.loss, compare_images(given, decoded, 0).mean);
    encoded.drift = std::max(encoded.drift, drift(given, decoded).largest());
  }
  encoded.decoded = chain.value();
  return encoded;
}

std::vector<std::size_t> kept_frames(std::size_t frames, int count) {
  std::vector<std::size_t> kept;
  if (frames == 0) return kept;
  if (count == 1) return {frames / 2};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::size_t frame = i * (frames - 1) / static_cast<std::size_t>(count - 1);
    if (kept.empty() || kept.back() != frame) kept.push_back(frame);
  }
  return kept;
}

RecordedVideo record_golden_video(const Scenario& scenario, int kept, const SourceFactory& sources,
                                  const PainterFactory& painters, const std::filesystem::path& folder) {
  RecordedVideo result;
  GoldenVideo& video = result.video;
  video.size = video_size(scenario.record.size);
  video.frames_per_second = scenario.record.frames_per_second;
  video.resolved = scenario.resolved;
  video.files = named_files_record(scenario);
  try {
    painters({.width = 16, .height = 16});
  } catch (const PictureFailure& failure) {
    result.no_device = failure.what();
    return result;
  }
  try {
    try {
      record_frames(result, scenario, sources, painters, folder, true);
      if (!video.frames.empty()) video.encoded = read_encoded_video(folder, video);
      result.file = folder / "video.mp4";
    } catch (const ImageUnreadable& error) {
      result.encoder_failure = error.what();
    } catch (const FileUnwritable&) {
      // A full disk is no fault of the encoder, also where its file is the first that finds no room.
      throw;
    } catch (const PictureFailure& failure) {
      // Whether the frames alone can be had tells the encoder's failure from the renderer's.
      result.encoder_failure = failure.what();
      record_frames(result, scenario, sources, painters, folder, false);
    }
    video.kept = kept_frames(video.frames.size(), kept);
    for (const std::size_t frame : video.kept) result.pictures.push_back(read_png(frame_file(folder, frame)));
  } catch (const PictureFailure& failure) {
    result.missing = failure.what();
    result.cannot_be_made = true;
  }
  if (video.frames.empty() && result.missing.empty()) result.missing = "the scenario has no pictures";
  return result;
}

}  // namespace thinwall
