#include "studio/organs/PlyHeader.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;

constexpr std::array<PlyType, 16> kTypes = {{{"char", PlyNumber::kInt8, 1},
                                             {"int8", PlyNumber::kInt8, 1},
                                             {"uchar", PlyNumber::kUint8, 1},
                                             {"uint8", PlyNumber::kUint8, 1},
                                             {"short", PlyNumber::kInt16, 2},
                                             {"int16", PlyNumber::kInt16, 2},
                                             {"ushort", PlyNumber::kUint16, 2},
                                             {"uint16", PlyNumber::kUint16, 2},
                                             {"int", PlyNumber::kInt32, 4},
                                             {"int32", PlyNumber::kInt32, 4},
                                             {"uint", PlyNumber::kUint32, 4},
                                             {"uint32", PlyNumber::kUint32, 4},
                                             {"float", PlyNumber::kFloat32, 4},
                                             {"float32", PlyNumber::kFloat32, 4},
                                             {"double", PlyNumber::kFloat64, 8},
                                             {"float64", PlyNumber::kFloat64, 8}}};

class HeaderReader {
 public:
  explicit HeaderReader(PlyCursor& cursor) : cursor_(cursor) {}

  PlyHeader read() {
    const std::vector<std::string> first = cursor_.header_words();
    if (first != std::vector<std::string>{"ply"}) cursor_.refuse_header("a PLY file begins with the line `ply`");
    bool has_format = false;
    for (;;) {
      const std::vector<std::string> words = cursor_.header_words();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format") {
        read_format(words);
        has_format = true;
      } else if (words[0] == "element") {
        read_element(words);
      } else if (words[0] == "property") {
        read_property(words);
      } else {
        cursor_.refuse_header("the header knows `format`, `element`, `property`, `comment` and `end_header`, not " +
                              in_backticks(words[0]));
      }
    }
    if (!has_format) cursor_.refuse_header("the header lacks the line `format`");
    return std::move(header_);
  }

 private:
  void read_format(const std::vector<std::string>& words) {
    const std::string word = words.size() > 1 ? words[1] : "";
    if (word == "ascii") {
      header_.format = PlyFormat::kAscii;
    } else if (word == "binary_little_endian") {
      header_.format = PlyFormat::kLittleEndian;
    } else if (word == "binary_big_endian") {
      header_.format = PlyFormat::kBigEndian;
    } else {
      cursor_.refuse_header("the format is `ascii`, `binary_little_endian` or `binary_big_endian`, not " +
                            in_backticks(word));
    }
  }

  void read_element(const std::vector<std::string>& words) {
    PlyHeaderElement element{.name = words.size() > 1 ? words[1] : "", .line = cursor_.line() - 1};
    const std::string count = words.size() > 2 ? words[2] : "";
    const auto [stop, failure] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (words.size() != 3 || failure != std::errc() || stop != count.data() + count.size()) {
      cursor_.refuse_header("expected `element NAME COUNT`");
    }
    const auto is_same = [&](const PlyHeaderElement& other) { return other.name == element.name; };
    if (std::ranges::any_of(header_.elements, is_same)) {
      cursor_.refuse_header("the element " + in_backticks(element.name) + " is there twice");
    }
    if (header_.elements.size() == kMostElements) cursor_.refuse_header("more than 64 elements");
    header_.elements.push_back(std::move(element));
  }

  PlyType type_of(const std::string& word) const {
    const auto row = std::ranges::find_if(kTypes, [&](const PlyType& type) { return type.word == word; });
    if (row == kTypes.end()) cursor_.refuse_header("there is no type of numbers " + in_backticks(word));
    return *row;
  }

  void read_property(const std::vector<std::string>& words) {
    if (header_.elements.empty()) cursor_.refuse_header("a property stands before the first `element`");
    PlyHeaderProperty property;
    if (words.size() == 5 && words[1] == "list") {
      property = {.name = words[4], .type = type_of(words[3]), .count_type = type_of(words[2])};
      if (property.count_type->type >= PlyNumber::kFloat32) cursor_.refuse_header("a list cannot have broken counts");
    } else if (words.size() == 3) {
      property = {.name = words[2], .type = type_of(words[1])};
    } else {
      cursor_.refuse_header("expected `property TYPE NAME` or `property list TYPE TYPE NAME`");
    }
    std::vector<PlyHeaderProperty>& properties = header_.elements.back().properties;
    const auto is_same = [&](const PlyHeaderProperty& other) { return other.name == property.name; };
    if (std::ranges::any_of(properties, is_same)) {
      cursor_.refuse_header("the property " + in_backticks(property.name) + " is there twice");
    }
    if (properties.size() == kMostProperties) cursor_.refuse_header("more than 256 properties of an element");
    properties.push_back(std::move(property));
  }

  PlyCursor& cursor_;
  PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(PlyCursor& cursor) {
  return HeaderReader(cursor).read();
}

}  // namespace thinwall
