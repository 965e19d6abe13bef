#include "studio/commands/PictureName.hpp"

#include <system_error>

#include "studio/commands/ExitCode.hpp"

namespace thinwall {

void require_picture_name(const std::string& option, const std::filesystem::path& name) {
  const std::string given = option + " " + name.string();
  std::error_code absent;
  if (std::filesystem::is_directory(name, absent)) {
    throw UsageError(given + ": this is a folder; name a picture in it, ending with .png");
  }
  if (name.extension() == ".png") return;
  throw UsageError(given + ": the picture is a PNG file; let its name end with .png");
}

}  // namespace thinwall
