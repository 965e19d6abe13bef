#include "renderer/picture/FinePixels.hpp"

#include <gtest/gtest.h>

#include <array>

#include "renderer/picture/FrameUniforms.hpp"

namespace thinwall {
namespace {

constexpr ImageSize kFineSize{70, 6};
constexpr ScreenArea kWhole{0, 0, kFineSize.width, kFineSize.height};

std::size_t at(int column, int row, int width = kFineSize.width) {
  return static_cast<std::size_t>(row * width + column);
}

std::vector<std::uint8_t> even_picture(std::uint8_t level) {
  return std::vector<std::uint8_t>(
      4 * static_cast<std::size_t>(kFineSize.width) * static_cast<std::size_t>(kFineSize.height), level);
}

TEST(FinePixels, AreNoneWhereNeighboursHardlyDiffer) {
  std::vector<std::uint8_t> pixels = even_picture(100);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(100 + 7 * (i / 4 % 2));
  const FinePixels fine = find_fine_pixels(pixels, {}, kFineSize.width, kWhole);
  EXPECT_EQ(fine.area, ScreenArea{});
  EXPECT_TRUE(fine.is_fine.empty());
}

TEST(FinePixels, AreAStepsBothSidesInAnyChannelAndWantTheirFourCorners) {
  for (const int column : {3, 40, 66}) {
    for (const std::size_t channel : {0U, 1U, 2U}) {
      std::vector<std::uint8_t> pixels = even_picture(100);
      pixels[4 * at(column, 2) + channel] = 130;
      const FinePixels fine = find_fine_pixels(pixels, {}, kFineSize.width, kWhole);
      // A cross of five, and a border of one for the corners on the left and below.
      ASSERT_EQ(fine.area, (ScreenArea{column - 2, 0, 4, 4}));
      EXPECT_EQ(fine.is_fine, (std::vector<std::uint8_t>{0, 0, 0, 0,  //
                                                         0, 0, 1, 0,  //
                                                         0, 1, 1, 1,  //
                                                         0, 0, 1, 0}));
      EXPECT_EQ(fine.is_corner, (std::vector<std::uint8_t>{0, 1, 1, 0,  //
                                                           1, 1, 1, 1,  //
                                                           1, 1, 1, 1,  //
                                                           0, 1, 1, 0}));
    }
  }
}

TEST(FinePixels, AreThoseThatShowFluid) {
  const std::vector<std::uint8_t> bare = even_picture(100);
  std::vector<std::uint8_t> pixels = bare;
  pixels[4 * at(20, 3)] = 102;
  pixels[4 * at(30, 3)] = 103;
  const FinePixels fine = find_fine_pixels(pixels, bare, kFineSize.width, kWhole);
  EXPECT_EQ(fine.area, (ScreenArea{29, 2, 2, 2}));
  EXPECT_EQ(fine.is_fine, (std::vector<std::uint8_t>{0, 0, 0, 1}));
}

TEST(FinePixels, AreFoundInPicturesOfOnePixelsWidth) {
  EXPECT_TRUE(find_fine_pixels(std::vector<std::uint8_t>(4, 7), {}, 1, {0, 0, 1, 1}).is_fine.empty());
  const std::vector<std::uint8_t> pixels{0, 0, 0, 255, 90, 90, 90, 255, 90, 90, 90, 255};
  EXPECT_EQ(find_fine_pixels(pixels, {}, 1, {0, 0, 1, 3}).is_fine, (std::vector<std::uint8_t>{1, 1}));
}

TEST(FinePixels, AreSoughtWithinAnAreaAlone) {
  std::vector<std::uint8_t> pixels = even_picture(100), bare = pixels;
  pixels[4 * at(10, 2)] = 200;
  pixels[4 * at(50, 2)] = 200;
  bare[4 * at(20, 3)] = 0;
  const ScreenArea area{45, 1, 20, 4};
  const FinePixels fine = find_fine_pixels(pixels, bare, kFineSize.width, area);
  const FinePixels of_whole = find_fine_pixels(pixels, {}, kFineSize.width, {40, 0, 30, 6});
  EXPECT_EQ(fine.area, (ScreenArea{48, 1, 4, 3}));
  EXPECT_EQ(of_whole.area, (ScreenArea{48, 0, 4, 4}));
  EXPECT_EQ(fine.is_fine, std::vector<std::uint8_t>(of_whole.is_fine.begin() + 4, of_whole.is_fine.end()));
}

TEST(FinePixels, AreHalfTheirMiddleAndAnEighthEachCornerOthersStay) {
  const FinePixels fine{.area = {5, 3, 3, 2}, .is_fine = {0, 0, 0, 0, 1, 0}, .is_corner = {1, 1, 0, 1, 1, 0}};
  std::vector<std::uint8_t> picture = even_picture(50), corners(24, 0);
  const std::size_t fine_pixel = 4 * at(6, 4);
  picture[fine_pixel] = 80;
  const std::array<std::size_t, 4> around{0, 1, 3, 4};
  for (std::size_t k = 0; k < 4; ++k) corners[4 * around[k]] = static_cast<std::uint8_t>(8 * (k + 1));
  add_corners(fine, corners, picture, kFineSize.width);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const int expected = i == fine_pixel ? 50 : i / 4 == fine_pixel / 4 ? 25 : 50;  // 80 / 2 + (8 + 16 + 24 + 32) / 8
    EXPECT_EQ(picture[i], expected) << i;
  }
}

TEST(FinePixels, ACornerBeginsWithTheBackdropAndAnythingElseStays) {
  const FinePixels fine{.area = {5, 2, 3, 2}, .is_fine = {0, 0, 0, 0, 1, 0}, .is_corner = {1, 1, 0, 1, 1, 0}};
  std::vector<std::uint8_t> backdrop = even_picture(0);
  for (std::size_t i = 0; i < backdrop.size(); ++i) backdrop[i] = static_cast<std::uint8_t>(i / 4 % 200);
  const std::vector<std::uint8_t> ground = with_backdrop(fine, even_picture(250), backdrop, kFineSize.width);
  const std::vector<std::uint32_t> numbers = at_corners(fine, 7, 3);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t seen = at(5 + static_cast<int>(i % 3), 2 + static_cast<int>(i / 3));
    for (std::size_t channel = 0; channel < 4; ++channel) {
      EXPECT_EQ(ground[4 * i + channel], fine.is_corner[i] ? seen % 200 : 250) << i;
    }
    EXPECT_EQ(numbers[i], fine.is_corner[i] ? 7U : 3U) << i;
  }
}

TEST(FinePixels, AreSampledWhereTheShiftSays) {
  CameraDefinition definition;
  definition.position = Double3{0.1, -0.2, 0.15};
  definition.target = Double3{0, 0, 0};
  const ImageSize size{640, 360};
  const Camera camera = resolve_camera(definition, SceneExtent{}, size, 0);
  FrameUniforms frame;
  const Matrix4 matrix = camera.matrix();
  for (std::size_t i = 0; i < 16; ++i) frame.view_projection[i] = static_cast<float>(matrix.values[i]);
  const FrameUniforms shifted = sampled_off_middle(frame, {0.5, 0.25}, size);
  const Vector3 point{0.01, 0.02, -0.01};
  const auto window = [&](const FloatMatrix4& m) {
    std::array<double, 4> clip{};
    for (std::size_t row = 0; row < 4; ++row) {
      clip[row] = m[row] * point.x + m[4 + row] * point.y + m[8 + row] * point.z + static_cast<double>(m[12 + row]);
    }
    return std::array{0.5 * (1 + clip[0] / clip[3]) * size.width, 0.5 * (1 + clip[1] / clip[3]) * size.height};
  };
  // What lay half a pixel to the right lies in the middle; floats leave 1e-4 of a pixel.
  EXPECT_NEAR(window(shifted.view_projection)[0], window(frame.view_projection)[0] - 0.5, 2e-4);
  EXPECT_NEAR(window(shifted.view_projection)[1], window(frame.view_projection)[1] - 0.25, 2e-4);
  EXPECT_FLOAT_EQ(shifted.sample_shift[0], 1.0F / 640);
  EXPECT_FLOAT_EQ(shifted.sample_shift[1], 0.5F / 360);
}

}  // namespace
}  // namespace thinwall
