#pragma once

#include <pango/pango.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace thinwall {

struct ReleaseObject {
  void operator()(void* object) const;
};

/// The one font of all pictures, read from its files alone: neither the system's fonts nor its font settings take part,
/// so that pictures do not depend on the machine. Pango's font maps serve one thread at a time, see `FontUse`.
class Font {
 public:
  /// Throws PictureFailure naming the package when Inter-Regular.otf or Inter-SemiBold.otf is not in `folder`.
  explicit Font(const std::filesystem::path& folder);

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
