#pragma once

#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

struct SheetFrame {
  Image picture;
  double time = 0;  // seconds
};

/// All frames of a film at a glance: a grid in reading order, each picture shrunk to `cell_width` pixels with its time
/// below, the title above. The pictures must have one shape; without any there is only the title. Throws PictureFailure
/// when the font is missing.
Image contact_sheet(const std::string& title, const std::vector<SheetFrame>& frames, int columns = 4,
                    int cell_width = 400);

}  // namespace thinwall
