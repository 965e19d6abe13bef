#pragma once

#include <epoxy/gl.h>

namespace thinwall {

/// While it lives, what is drawn is added to what is there times a second colour, as light through a clear layer is. A
/// blend function of two sources is allowed where one buffer is drawn to; some drivers refuse it elsewhere even while
/// nothing is blended, so none is left behind.
class TwoSourceBlending {
 public:
  TwoSourceBlending() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_SRC1_COLOR);
  }
  ~TwoSourceBlending() {
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
  }
  TwoSourceBlending(const TwoSourceBlending&) = delete;
  TwoSourceBlending& operator=(const TwoSourceBlending&) = delete;
};

}  // namespace thinwall
