// The text of a Mitsuba scene file, with the files that it includes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/files/scene_error.h"
#include "scene/mitsuba/xml_names.h"

namespace saccade {

// Each <include filename="..."> is replaced by what stands within the <scene> of that file, and so on within
// it. As in Mitsuba, all files are looked up beside the first one, see findFile().
class XmlText {
 public:
  // `text` is the content of the file at `path`; `names` are those known before it. Throws SceneError with
  // file and line: faulty XML, a root other than <scene>, a file that includes itself, anything beyond
  // limits.h.
  XmlText(std::string text, const std::string& path, const LoadOptions& options, XmlNames names);

  const std::string& bytes() const { return bytes_; }
  // Names the file and the line of what stands at `offset` of bytes().
  SceneError error(std::ptrdiff_t offset, const std::string& what) const;

 private:
  friend class XmlIncluder;
  struct Piece {
    std::size_t begin;  // in bytes_
    std::string path;
    long line;  // of its beginning, in the file at `path`
  };
  std::string bytes_;
  std::vector<Piece> pieces_;  // without gaps
};

}  // namespace saccade
