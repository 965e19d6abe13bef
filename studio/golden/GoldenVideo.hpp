#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "studio/golden/GoldenHistory.hpp"
#include "studio/golden/GoldenPicture.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What is known of a frame before it is encoded.
struct VideoFrameRecord {
  std::string hash;     // of the picture
  std::string squares;  // 4 x 3 squares x 3 colours: mean levels, two hexadecimal digits each
};

/// What the encoder has made of the frames, from the file itself.
struct EncodedVideo {
  std::string program;  // the encoder, as it names itself
  std::string decoded;  // a hash of all decoded frames; empty when the file could not be read
  std::string tags;     // codec, pixel format and colour tags: "h264 yuv420p tv bt709 bt709 bt709"
  std::size_t frames = 0;
  std::string times;     // what is wrong with the frames' times; empty when frame N is shown at N / fps
  std::string captions;  // of the file's caption track, as WebVTT
  std::string chapters;  // of the file, a line each
  double loss = 0;       // mean difference between decoded and given frame, 8-bit levels, of the worst frame
  double drift = 0;      // change of a colour's mean between given and decoded frame, of the worst frame
};

/// The video of a scenario, as far as a golden keeps it or needs it to judge.
struct GoldenVideo {
  std::string driver;
  ImageSize size;
  double frames_per_second = 30;
  std::vector<VideoFrameRecord> frames;
  std::vector<std::size_t> kept;         // indices of the frames that are kept as pictures
  std::string captions;                  // as WebVTT, before the encoder
  std::string state_digest;              // of the simulation at its end
  std::string second_state_digest = {};  // likewise of the take that it is compared with; empty when there is none
  std::string scene_hash;                // of all frames without overlays
  std::string history;                   // the main quantities step by step, see `history_text`
  std::string resolved;                  // the scenario (JSON)
  std::string files = {};  // JSON: hashes of the files that it names; empty in earlier versions' approvals
  EncodedVideo encoded;
};

/// Today's video, with what a golden does not keep.
struct RecordedVideo {
  GoldenVideo video;
  std::vector<Image> pictures;  // of the frames in `video.kept`
  std::string no_device;        // why nothing could be drawn here; empty when something could
  std::string missing;          // why there are no frames or no room for a file; empty when there are
  bool cannot_be_made = false;  // whether `missing` is of device or disk, not of the simulation
  std::string encoder_failure;  // why there is no file though there are frames; empty when there is one
  std::filesystem::path file;   // the video
};

/// The frames that are kept of a video: `count` from the first to the last, or the middle one.
std::vector<std::size_t> kept_frames(std::size_t frames, int count);

/// Reads `folder`/video.mp4 and holds it against the frames before the encoder, which lie in `folder`/frames. Throws
/// ImageUnreadable, PictureFailure.
EncodedVideo read_encoded_video(const std::filesystem::path& folder, const GoldenVideo& video);

/// Records the scenario's video as `thinwall run` does, in the size of goldens, into `folder`, and reads it again.
RecordedVideo record_golden_video(const Scenario& scenario, int kept, const SourceFactory& sources,
                                  const PainterFactory& painters, const std::filesystem::path& folder);

}  // namespace thinwall
