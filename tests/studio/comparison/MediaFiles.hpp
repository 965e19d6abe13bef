#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/image/PngFile.hpp"
#include "renderer/video/Program.hpp"
#include "renderer/video/VideoWriter.hpp"
#include "tests/renderer/metric/MetricImages.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {

inline constexpr ImageSize kMediaSize{160, 96};

/// Runs ffmpeg from one file to another.
inline void convert(const std::filesystem::path& from, const std::vector<std::string>& options,
                    const std::filesystem::path& to) {
  std::vector<std::string> arguments = {"ffmpeg", "-v", "error", "-y", "-i", from};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.push_back(to);
  const ProgramResult result = run_program(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
}

/// A lossless video of a shape that moves, a frame for each of `shifts`.
inline void write_video(const std::filesystem::path& path, const std::vector<int>& shifts) {
  const std::filesystem::path folder = path.string() + ".frames";
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const int shift : shifts) {
    write_png(folder / (std::to_string(100 + number++) + ".png"), shaded_image(kMediaSize, shift));
  }
  const ProgramResult result = run_program({"ffmpeg", "-v", "error", "-y", "-framerate", "25", "-pattern_type", "glob",
                                            "-i", folder / "*.png", "-c:v", "ffv1", "-pix_fmt", "gbrp", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::filesystem::remove_all(folder);
}

inline void cut_short(const std::filesystem::path& path, double part) {
  const double bytes = static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(part * bytes));
}

}  // namespace thinwall
