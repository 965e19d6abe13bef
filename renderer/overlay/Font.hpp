#pragma once

#include <pango/pango.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace thinwall {

struct ReleaseObject {
  void operator()(void* object) const;
};

/// The files of the fonts for scripts that Inter has not: Chinese, Japanese and Korean, Arabic, Hebrew, and what South
/// and Southeast Asia, Armenia, Georgia and Ethiopia write with.
std::vector<std::filesystem::path> fonts_of_other_scripts();

/// The font of all pictures, read from its files alone: neither the system's fonts nor its font settings take part, so
/// that pictures do not depend on the machine. Pango's font maps serve one thread at a time, see `FontUse`.
class Font {
 public:
  /// Throws PictureFailure naming the package when Inter-Regular.otf or Inter-SemiBold.otf is not in `folder`.
  /// `others`: files that serve letters which these have no shape for; boxes stand for those of files that are missing.
  explicit Font(const std::filesystem::path& folder,
                const std::vector<std::filesystem::path>& others = fonts_of_other_scripts());

  /// For making layouts: glyphs unhinted, at exact places, grey edges, language English.
  PangoContext* context() const { return context_.get(); }
  /// Family and version as the file says, e.g. "Inter, font file version 4.0".
  const std::string& description() const { return description_; }

 private:
  std::unique_ptr<PangoFontMap, ReleaseObject> map_;
  std::unique_ptr<PangoContext, ReleaseObject> context_;
  std::string description_;
};

/// The font of the program, loaded at the first call. Throws PictureFailure.
const Font& overlay_font();

/// Keeps other threads from the font of the program: to be held while texts are laid out and drawn.
class FontUse {
 public:
  FontUse();

 private:
  std::scoped_lock<std::mutex> lock_;
};

}  // namespace thinwall
