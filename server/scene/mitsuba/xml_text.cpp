#include "scene/mitsuba/xml_text.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/names.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/mitsuba/xml_part.h"
#include "scene/mitsuba/xml_told.h"
#include "scene/mitsuba/xml_walk.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

// With links and dots followed, as far as they can be.
std::string followed(const std::string& path) {
  std::error_code fault;
  const fs::path real = fs::weakly_canonical(path, fault);
  return fault ? path : real.string();
}

}  // namespace

class XmlIncluder {
 public:
  XmlIncluder(XmlText& whole, fs::path folder, const LoadOptions& options, XmlNames names)
      : whole_(whole), folder_(std::move(folder)), options_(options), names_(std::move(names)) {}

  // Adds a part of a file, with what it includes.
  void add(const XmlPart& file, XmlPart::Span part) {
    open_.push_back(followed(file.path()));
    long line = file.lineAt(part.begin);  // where `part` begins
    const auto copyTo = [&](XmlPart::Span next) {
      whole_.pieces_.push_back({whole_.bytes_.size(), file.path(), line});
      whole_.bytes_ += file.text({part.begin, next.begin});
      line += lineEndsIn(file.text({part.begin, next.end}));
      part.begin = next.end;
    };
    forEachElement(file.root(), [&](pugi::xml_node node) {
      const std::string_view name = node.name();
      const auto value = [&](const char* attribute) {
        return toldAt(file, node, [&] { return names_.substituted(node.attribute(attribute).value()); });
      };
      if (name == "default") names_.define(value("name"), value("value"));
      if (name == "path") options_.search_folders.push_back(folder_ / value("value"));
      if (name != "include") return;
      copyTo(file.spanOf(node));
      const std::string filename = value("filename");
      const std::string path = toldAt(file, node, [&] { return findFile(filename, folder_, options_); });
      const XmlPart included(toldAt(file, node, [&] { return read(path); }), path);
      add(included, included.inner());
    });
    copyTo({part.end, part.end});
    open_.pop_back();
  }

 private:
  std::string read(const std::string& path) {
    const auto same = std::find(open_.begin(), open_.end(), followed(path));
    if (same != open_.end())
      throw SceneError("the file includes itself: " + joinNames(std::vector<std::string>(same, open_.end())));
    if (++includes_ > kMaxIncludes || open_.size() > kMaxIncludeDepth)
      throw SceneError("more than " + std::to_string(kMaxIncludes) + " includes, or " +
                       std::to_string(kMaxIncludeDepth) + " within each other");
    std::string text = readFile(path, kMaxXmlBytes);
    if ((bytes_ += text.size()) > kMaxXmlBytes)
      throw SceneError("the included files have more than " + std::to_string(kMaxXmlBytes) + " bytes");
    return text;
  }

  XmlText& whole_;
  const fs::path folder_;
  LoadOptions options_;
  XmlNames names_;
  int includes_ = 0;
  std::size_t bytes_ = 0;          // of the included files
  std::vector<std::string> open_;  // files, from the first to the innermost
};

XmlText::XmlText(std::string text, const std::string& path, const LoadOptions& options, XmlNames names) {
  if (text.find("<include") == text.npos) {
    bytes_ = std::move(text);
    pieces_ = {{0, path, 1}};
    return;
  }
  const XmlPart file(std::move(text), path);
  XmlIncluder(*this, fs::path(path).parent_path(), options, std::move(names)).add(file, file.all());
}

SceneError XmlText::error(std::ptrdiff_t offset, const std::string& what) const {
  const auto at = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(bytes_)));
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), at,
                                      [](std::size_t end, const Piece& piece) { return end < piece.begin; });
  const Piece& piece = *std::prev(after);
  const std::string_view before = std::string_view(bytes_).substr(piece.begin, at - piece.begin);
  return {piece.path, piece.line + lineEndsIn(before), what};
}

}  // namespace saccade
