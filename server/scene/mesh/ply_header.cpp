#include "scene/mesh/ply_header.h"

#include <optional>
#include <utility>

#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

std::optional<PlyType> findType(std::string_view name) {
  static constexpr std::pair<std::string_view, PlyType> kTypes[] = {
      {"char", {1, false, true}},    {"int8", {1, false, true}},    {"uchar", {1, false, false}},
      {"uint8", {1, false, false}},  {"short", {2, false, true}},   {"int16", {2, false, true}},
      {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, false, true}},
      {"int32", {4, false, true}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
      {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
      {"float64", {8, true, true}}};
  for (const auto& [known, type] : kTypes)
    if (known == name) return type;
  return {};
}

class HeaderReader {
 public:
  HeaderReader(std::string_view& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  PlyHeader read() {
    if (nextLine() != "ply") fail("not a PLY file: the first line is not 'ply'");
    readFormat();
    for (auto line = nextLine(); line != "end_header"; line = nextLine()) {
      const auto keyword = takeWord(line);
      if (keyword == "element") {
        readElement(line);
      } else if (keyword == "property") {
        readProperty(line);
      } else if (keyword != "comment" && keyword != "obj_info") {
        fail("unknown keyword '" + std::string(keyword) +
             "'; known: element, property, comment, obj_info, end_header");
      }
    }
    return std::move(header_);
  }

 private:
  std::string_view nextLine() {
    if (bytes_.empty()) fail("the file ends within its header");
    ++line_;
    return takeLine(bytes_);
  }

  void readFormat() {
    auto line = nextLine();
    const auto keyword = takeWord(line), name = takeWord(line), version = takeWord(line);
    if (keyword != "format" || version != "1.0") fail("expected 'format <name> 1.0'");
    if (name == "ascii") {
      header_.format = PlyFormat::kAscii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::kBigEndian;
    } else {
      fail("unknown format; known: ascii, binary_little_endian, binary_big_endian");
    }
  }

  void readElement(std::string_view words) {
    const auto name = takeWord(words);
    const auto count = parseInteger(takeWord(words));
    if (name.empty() || !count || *count < 0) fail("expected 'element <name> <count>'");
    header_.elements.push_back({std::string(name), *count, {}});
  }

  void readProperty(std::string_view words) {
    if (header_.elements.empty()) fail("a property before any element");
    const auto first = takeWord(words);
    const bool is_list = first == "list";
    const PlyType count_type = is_list ? readType(takeWord(words)) : PlyType{};
    const PlyType type = readType(is_list ? takeWord(words) : first);
    if (is_list && count_type.is_float) fail("the length of a list must be a whole number");
    header_.elements.back().properties.push_back({std::string(takeWord(words)), is_list, count_type, type});
  }

  PlyType readType(std::string_view name) const {
    const auto type = findType(name);
    if (!type)
      fail("unknown type '" + std::string(name) + "'; known: char uchar short ushort int uint float double");
    return *type;
  }

  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_, line_, what); }

  std::string_view& bytes_;
  const std::string& path_;
  long line_ = 0;
  PlyHeader header_{};
};

}  // namespace

PlyHeader takePlyHeader(std::string_view& bytes, const std::string& path) {
  return HeaderReader(bytes, path).read();
}

}  // namespace saccade
