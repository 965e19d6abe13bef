#include "renderer/overlay/ContactSheet.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "renderer/image/Resize.hpp"
#include "renderer/overlay/Canvas.hpp"
#include "renderer/overlay/Font.hpp"
#include "renderer/overlay/NumberText.hpp"
#include "renderer/overlay/Text.hpp"

namespace thinwall {
namespace {

constexpr Color kGround{0.075, 0.085, 0.10};
constexpr Color kTitleColor{0.97, 0.98, 0.99};
constexpr Color kTimeColor{0.74, 0.78, 0.82};
constexpr int kMargin = 24;
constexpr int kGap = 16;
constexpr int kSheetTitleHeight = 44;
constexpr int kTimeHeight = 30;

void paste(Image& sheet, const Image& picture, int left, int top) {
  const std::size_t row_bytes = static_cast<std::size_t>(picture.size.width) * 3;
  for (int y = 0; y < picture.size.height; ++y) {
    const std::size_t start = 3 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(sheet.size.width) +
                                   static_cast<std::size_t>(left));
    std::copy_n(picture.pixels.data() + static_cast<std::size_t>(y) * row_bytes, row_bytes,
                sheet.pixels.data() + start);
  }
}

}  // namespace

Image contact_sheet(const std::string& title, const std::vector<SheetFrame>& frames, int columns, int cell_width) {
  const FontUse use;
  assert(columns > 0 && cell_width > 0);
  const int count = static_cast<int>(frames.size());
  const int used_columns = std::clamp(count, 1, columns);
  const int rows = (count + columns - 1) / columns;
  const ImageSize shape = frames.empty() ? ImageSize{} : frames.front().picture.size;
  const ImageSize cell{cell_width, std::max(1, cell_width * shape.height / shape.width)};
  const int pitch = cell.height + kTimeHeight;
  const ImageSize size{2 * kMargin + used_columns * (cell.width + kGap) - kGap,
                       2 * kMargin + kSheetTitleHeight + std::max(0, rows * (pitch + kGap) - kGap)};
  Image sheet{.size = size,
              .pixels = std::vector<std::uint8_t>(static_cast<std::size_t>(size.width) * size.height * 3)};
  const Canvas canvas(size);
  canvas.fill(kGround);
  Text(title, {.size = 24, .bold = true, .color = kTitleColor}, {.width = size.width - 2.0 * kMargin})
      .draw(canvas, kMargin, kMargin);
  for (int i = 0; i < count; ++i) {
    const int left = kMargin + i % columns * (cell.width + kGap);
    const int top = kMargin + kSheetTitleHeight + i / columns * (pitch + kGap);
    Text(fixed_text(frames[static_cast<std::size_t>(i)].time, 2) + " s", {.size = 17, .color = kTimeColor})
        .draw(canvas, left, top + cell.height + 6);
  }
  canvas.blend_onto(sheet, 0, 0);
  for (int i = 0; i < count; ++i) {
    const int left = kMargin + i % columns * (cell.width + kGap);
    const int top = kMargin + kSheetTitleHeight + i / columns * (pitch + kGap);
    assert(frames[static_cast<std::size_t>(i)].picture.size == shape);
    paste(sheet, resize(frames[static_cast<std::size_t>(i)].picture, cell), left, top);
  }
  return sheet;
}

}  // namespace thinwall
