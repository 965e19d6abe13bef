#pragma once

#include "renderer/overlay/Overlay.hpp"
#include "tests/renderer/image/TestImages.hpp"

namespace thinwall {

inline constexpr ImageSize kSize{1280, 720};

/// Every part has something to show, of a force that grows evenly up to `time` (seconds).
inline OverlayContent some_content(double time = 2.5) {
  OverlayContent content{.time = time,
                         .duration = 6,
                         .title = "Palpation",
                         .caption = "Press slowly.",
                         .phase = "contact",
                         .tool = "probe",
                         .force = 0.3 * time / 6,
                         .depth = 0.003,
                         .pressure = 900,
                         .history = {}};
  for (int i = 0; i * 0.005 <= time; ++i) content.history.push_back({i * 0.005, 0.3 * i * 0.005 / 6});
  return content;
}

/// No part is shown.
inline OverlayContent nothing() {
  return {.title = "",
          .caption = "",
          .phase = "",
          .tool = "",
          .history = {},
          .shown = {.force_plot = false, .gauge = false, .captions = false, .time = false}};
}

/// On an even ground.
inline Image overlaid(const OverlayContent& content, ImageSize size = kSize) {
  Image image = plain_image(size, 90, 60, 50);
  draw_overlay(image, content);
  return image;
}

}  // namespace thinwall
