#include <gtest/gtest.h>

#include "renderer/overlay/HalfCaptions.hpp"
#include "studio/recorder/Painter.hpp"
#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kSize{1280, 720};

class BlackPainter final : public Painter {
 public:
  Image paint(const Snapshot&, const Shot&) override {
    return {.size = kSize, .pixels = std::vector<std::uint8_t>(3UL * kSize.width * kSize.height, 0)};
  }
  std::string driver() const override { return "black"; }
};

/// A ball with an arrow from left of it, whose words stand beyond its tail.
Frame arrow_frame(const std::array<std::string, 2>& captions) {
  Frame frame;
  frame.snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0}, 0.02, 3));
  frame.shot.camera.position = Double3{0, -0.12, 0};
  frame.shot.camera.target = Double3{0, 0, 0};
  frame.overlay.half_captions = captions;
  AnnotationDefinition annotations;
  annotations.arrows.push_back({.text = "Words beside an arrow",
                                .body = "organ",
                                .at = {-0.0141, 0, 0.0141},
                                .direction = {0.86, 0, -0.51},
                                .length = 0.0178});
  frame.annotations = std::make_shared<const AnnotationDefinition>(annotations);
  return frame;
}

int differing_bytes(const Image& a, const Image& b, const Box& place) {
  int count = 0;
  for (int y = static_cast<int>(place.y); y < place.bottom(); ++y) {
    for (int x = static_cast<int>(place.x); x < place.right(); ++x) {
      const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * kSize.width + static_cast<std::size_t>(x));
      for (std::size_t k = pixel; k < pixel + 3; ++k) count += a.pixels[k] != b.pixels[k];
    }
  }
  return count;
}

TEST(FinishedPicture, WordsOfAnArrowKeepClearOfTheCaptionsOfHalves) {
  const std::array<std::string, 2> captions{"A wall of two millimetres", "Another"};
  const Box place = half_caption_places(kSize, captions).front();
  const auto picture_of = [](Frame frame, bool is_annotated) {
    if (!is_annotated) frame.annotations = nullptr;
    BlackPainter painter;
    return finished_picture(frame, painter);
  };
  const Frame bare = arrow_frame({}), captioned = arrow_frame(captions);
  EXPECT_GT(differing_bytes(picture_of(bare, true), picture_of(bare, false), place), 500) << "they would stand there";
  EXPECT_EQ(differing_bytes(picture_of(captioned, true), picture_of(captioned, false), place), 0);
}

/// A ball at the left, with a label of its top, which lies where a title does.
Frame frame_with_a_label_under(const std::string& title) {
  Frame frame;
  frame.snapshot.surfaces.push_back(test::sphere("organ", {0, 0, 0}, 0.02, 3));
  frame.shot.camera.position = Double3{0.0482, -0.12, -0.008};
  frame.shot.camera.target = Double3{0.0482, 0, -0.008};
  frame.overlay.title = title;
  AnnotationDefinition annotations;
  annotations.labels.push_back({.text = "Fundus", .body = "organ", .at = {0, 0, 0.02}});
  frame.annotations = std::make_shared<const AnnotationDefinition>(annotations);
  return frame;
}

TEST(FinishedPicture, ThePointOfALabelIsSeenOverATitle) {
  BlackPainter painter;
  const Image bare = finished_picture(frame_with_a_label_under(""), painter);
  const Image titled = finished_picture(frame_with_a_label_under("A long title over the point"), painter);
  const Box dot{98, 44, 4, 4}, beside{60, 43, 6, 6};
  EXPECT_GT(differing_bytes(bare, titled, beside), 50) << "the title stands there";
  EXPECT_EQ(differing_bytes(bare, titled, dot), 0);
}

}  // namespace
}  // namespace thinwall
