#include "renderer/overlay/Font.hpp"

#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/overlay/NumberText.hpp"

#ifdef __SANITIZE_ADDRESS__
// fontconfig keeps offsets where others keep pointers, so the leak checker takes what is in use for lost.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
#endif

namespace thinwall {
namespace {

/// A configuration that knows the given font files and nothing else.
class FontSettings {
 public:
  FontSettings() : config_(FcConfigCreate()) {}
  FontSettings(const FontSettings&) = delete;
  FontSettings& operator=(const FontSettings&) = delete;
  ~FontSettings() { FcConfigDestroy(config_); }

  bool has_added(const std::filesystem::path& file) {
    return FcConfigAppFontAddFile(config_, reinterpret_cast<const FcChar8*>(file.c_str())) == FcTrue;
  }

  void add(const std::filesystem::path& file) {
    if (has_added(file)) return;
    throw PictureFailure("cannot read the font " + file.string() +
                         ", which all texts on pictures are set in; install it (on Debian: apt-get install "
                         "fonts-inter)");
  }

  FcConfig* get() const { return config_; }

  /// Font files count their versions in units of 1 / 65536.
  std::string description() const {
    const FcFontSet* fonts = FcConfigGetFonts(config_, FcSetApplication);
    int version = 0;
    FcPatternGetInteger(fonts->fonts[0], FC_FONTVERSION, 0, &version);
    return "Inter, font file version " + fixed_text(version / 65536.0, 3);
  }

 private:
  FcConfig* config_;
};

std::mutex& font_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

void ReleaseObject::operator()(void* object) const {
  g_object_unref(object);
}

std::vector<std::filesystem::path> fonts_of_other_scripts() {
  const std::filesystem::path folder = THINWALL_OTHER_FONTS_FOLDER;
  std::vector<std::filesystem::path> files{folder / "wqy" / "wqy-microhei.ttc"};
  for (const char* script :
       {"Arabic", "Armenian", "Bengali", "Devanagari", "Ethiopic", "Georgian", "Gujarati", "Gurmukhi", "Hebrew",
        "Kannada", "Khmer", "Lao", "Malayalam", "Myanmar", "Oriya", "Sinhala", "Tamil", "Telugu", "Thai"}) {
    files.push_back(folder / "noto" / (std::string("NotoSans") + script + "-Regular.ttf"));
  }
  return files;
}

Font::Font(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& others) {
  FontSettings settings;
  settings.add(folder / "Inter-Regular.otf");
  settings.add(folder / "Inter-SemiBold.otf");
  for (const std::filesystem::path& file : others) settings.has_added(file);
  description_ = settings.description();
  map_.reset(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
  pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map_.get()), settings.get());
  context_.reset(pango_font_map_create_context(map_.get()));
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context_.get(), FALSE);
  pango_context_set_language(context_.get(), pango_language_from_string("en"));
}

const Font& overlay_font() {
  // Never freed, because a thread may still draw while the program ends.
  static const Font* const font = new Font(THINWALL_FONT_FOLDER);
  return *font;
}

FontUse::FontUse() : lock_(font_mutex()) {}

}  // namespace thinwall
