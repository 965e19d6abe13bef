#include "renderer/image/ExrFile.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <string>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

/// A file in memory.
class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("picture") {}
  void write(const char bytes[], int count) override {
    const std::size_t end = place_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::copy(bytes, bytes + count, bytes_.begin() + static_cast<std::ptrdiff_t>(place_));
    place_ = end;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

// More work makes files a few per cent smaller and takes several times as long.
constexpr int kCompression = 1;

}  // namespace

std::vector<std::uint8_t> encode_exr(const FloatLayer& layer, ExrNumbers numbers) {
  const auto width = static_cast<std::size_t>(layer.size.width);
  assert(layer.channels == 1 || layer.channels == 3);
  assert(layer.values.size() == width * static_cast<std::size_t>(layer.size.height) * layer.channels);
  if (!std::ranges::all_of(layer.values, [](float value) { return std::isfinite(value); })) {
    throw PictureFailure("cannot make an OpenEXR picture: it holds a value that is not finite");
  }
  std::vector<Imath::half> halves;
  if (numbers == ExrNumbers::kHalf) halves.assign(layer.values.begin(), layer.values.end());
  const bool is_half = numbers == ExrNumbers::kHalf;
  const Imf::PixelType type = is_half ? Imf::HALF : Imf::FLOAT;
  const std::size_t bytes = is_half ? sizeof(Imath::half) : sizeof(float);
  // The library takes a pointer that it could write to, and only reads.
  char* const first = is_half ? reinterpret_cast<char*>(halves.data())
                              : reinterpret_cast<char*>(const_cast<float*>(layer.values.data()));
  try {
    Imf::Header header(layer.size.width, layer.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = kCompression;
    Imf::FrameBuffer frame;
    constexpr const char* kColors[] = {"R", "G", "B"};
    for (std::size_t k = 0; k < layer.channels; ++k) {
      const char* const name = layer.channels == 1 ? "Y" : kColors[k];
      header.channels().insert(name, Imf::Channel(type));
      frame.insert(name, Imf::Slice(type, first + k * bytes, bytes * layer.channels, bytes * layer.channels * width));
    }
    MemoryStream stream;
    {
      Imf::OutputFile file(stream, header, 0);
      file.setFrameBuffer(frame);
      file.writePixels(layer.size.height);
    }
    return std::move(stream.bytes());
  } catch (const std::exception& error) {
    throw PictureFailure(std::string("cannot make an OpenEXR picture: ") + error.what());
  }
}

}  // namespace thinwall
