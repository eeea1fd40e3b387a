#include "scene/model/mtl_file.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/text_cut.h"
#include "scene/files/limits.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

constexpr std::size_t kMostUnread = 32;

class MtlReader {
 public:
  explicit MtlReader(const std::string& path) : path_(path) {}

  MtlFile read(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      readLine(takeLine(text));
    }
    return std::move(file_);
  }

 private:
  void readLine(std::string_view line);
  void readStatement(const std::string& keyword, std::string_view rest);
  Rgb readColor(const std::string& keyword, std::string_view rest, float max) const;
  float readNumber(const std::string& keyword, std::string_view rest, float max) const;
  MtlMaterial::Map readMap(std::string_view rest);
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(path_, line_, what); }

  const std::string& path_;
  long line_ = 0;
  bool has_d_ = false;  // the last material
  MtlFile file_;
};

void MtlReader::readLine(std::string_view line) {
  const std::string keyword(takeWord(line));
  if (keyword.empty() || keyword[0] == '#') return;
  if (keyword == "newmtl") {
    file_.materials.emplace_back().name = trimmed(line);
    has_d_ = false;
    return;
  }
  if (file_.materials.empty()) fail("a newmtl must come before '" + cutText(keyword, kMaxEcho) + "'");
  readStatement(keyword, line);
}

void MtlReader::readStatement(const std::string& keyword, std::string_view rest) {
  static const std::set<std::string> of_no_use{"Ka", "map_Ka", "Ni", "illum", "sharpness"};
  MtlMaterial& m = file_.materials.back();
  if (keyword == "Kd") {
    m.diffuse = readColor(keyword, rest, 1);
  } else if (keyword == "Ks") {
    m.specular = readColor(keyword, rest, 1);
  } else if (keyword == "Ke") {
    m.emission = readColor(keyword, rest, kMaxRadiance);
  } else if (keyword == "Ns") {
    m.shininess = readNumber(keyword, rest, 1e6f);
  } else if (keyword == "d") {
    m.opacity = readNumber(keyword, rest, 1);
    has_d_ = true;
  } else if (keyword == "Tr") {
    const float clear = readNumber(keyword, rest, 1);
    if (!has_d_) m.opacity = 1 - clear;
  } else if (keyword == "map_Kd") {
    m.diffuse_map = readMap(rest);
  } else if (keyword == "map_d") {
    m.opacity_map = readMap(rest);
  } else if (!of_no_use.contains(keyword) && file_.unread.size() < kMostUnread) {
    file_.unread.insert(cutText(keyword, kMaxEcho));
  }
}

// Three numbers, or one for all parts.
Rgb MtlReader::readColor(const std::string& keyword, std::string_view rest, float max) const {
  std::array<float, 3> parts;
  const auto one = takeWord(rest);
  parts.fill(readNumber(keyword, one, max));
  for (std::size_t i = 1; i < 3; ++i) {
    const auto word = takeWord(rest);
    if (i == 1 && (word.empty() || word[0] == '#')) break;
    parts[i] = readNumber(keyword, word, max);
  }
  return {parts[0], parts[1], parts[2]};
}

float MtlReader::readNumber(const std::string& keyword, std::string_view rest, float max) const {
  const auto word = takeWord(rest);
  const auto value = parseNumber(word);
  if (!value || !(*value >= 0 && *value <= max))
    fail(keyword + ": '" + cutText(word, kMaxEcho) + "' is not a number from 0" +
         (max == 1 ? " to 1" : ", or is too large"));
  return static_cast<float>(*value);
}

// The name of a file, which may have blanks, after options such as "-s 1 1 1".
MtlMaterial::Map MtlReader::readMap(std::string_view rest) {
  rest = trimmed(rest);
  while (rest.starts_with('-')) {
    file_.unread.insert(cutText(takeWord(rest), kMaxEcho));
    for (rest = trimmed(rest);; rest = trimmed(rest)) {
      std::string_view after = rest;
      const auto word = takeWord(after);
      if (!parseNumber(word) && word != "on" && word != "off") break;
      rest = after;
    }
  }
  std::string file(rest);
  std::replace(file.begin(), file.end(), '\\', '/');
  if (file.empty()) fail("the map names no file");
  return {file, line_};
}

}  // namespace

MtlFile parseMtl(std::string_view bytes, const std::string& path) {
  return MtlReader(path).read(bytes);
}

}  // namespace saccade
