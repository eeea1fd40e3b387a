// One file of a scene that includes others, as text and as elements.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "scene/files/scene_error.h"

namespace saccade {

// How many ends of lines stand in a text.
long lineEndsIn(std::string_view text);

class XmlPart {
 public:
  // Bytes of a text, from `begin` to before `end`.
  struct Span {
    std::size_t begin, end;
  };

  // Throws SceneError with file and line: faulty XML, or other roots than one <scene>.
  XmlPart(std::string text, const std::string& path);

  std::string_view text(Span span) const { return {text_.data() + span.begin, span.end - span.begin}; }
  const std::string& path() const { return path_; }
  pugi::xml_node root() const { return document_.document_element(); }
  Span all() const { return {0, text_.size()}; }
  // The text between the tags of the <scene>.
  Span inner() const;
  // An <include> with both its tags. Throws SceneError where an element stands within it.
  Span spanOf(pugi::xml_node include) const;
  long lineAt(std::size_t offset) const { return 1 + lineEndsIn(text({0, offset})); }
  SceneError error(pugi::xml_node at, const std::string& what) const {
    return errorAt(at.offset_debug(), what);
  }

 private:
  std::size_t nameOf(pugi::xml_node element) const;
  SceneError errorAt(std::ptrdiff_t offset, const std::string& what) const;

  std::string text_, path_;
  pugi::xml_document document_;
};

}  // namespace saccade
