#include "scene/mitsuba/xml_part.h"

#include <algorithm>

namespace saccade {
namespace {

// Behind the '>' of the tag in which `at` is.
std::size_t tagEnd(std::string_view text, std::size_t at) {
  for (char quote = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote == 0 && c == '>') return at + 1;
    if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    }
  }
  return text.size();
}

bool isElement(pugi::xml_node node) {
  return node.type() == pugi::node_element;
}

}  // namespace

long lineEndsIn(std::string_view text) {
  return std::count(text.begin(), text.end(), '\n');
}

// Comments and the like are kept as nodes, so that the end of the root is known.
XmlPart::XmlPart(std::string text, const std::string& path) : text_(std::move(text)), path_(path) {
  const unsigned options = pugi::parse_default | pugi::parse_comments | pugi::parse_pi;
  const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size(), options);
  if (!result) throw errorAt(result.offset, std::string("faulty XML: ") + result.description());
  if (std::string_view(root().name()) != "scene") throw error(root(), "the root element is not <scene>");
  for (pugi::xml_node after = root().next_sibling(); after; after = after.next_sibling())
    if (isElement(after)) throw error(after, "a second root element");
}

XmlPart::Span XmlPart::inner() const {
  const std::size_t begin = tagEnd(text_, nameOf(root()));
  if (text_[begin - 2] == '/') return {begin, begin};
  const pugi::xml_node after = root().next_sibling();
  return {begin, text_.rfind("</scene", after ? static_cast<std::size_t>(after.offset_debug()) : text_.npos)};
}

XmlPart::Span XmlPart::spanOf(pugi::xml_node include) const {
  if (std::any_of(include.begin(), include.end(), isElement))
    throw error(include, "an <include> has no elements within it");
  const std::size_t name = nameOf(include), end = tagEnd(text_, name);
  return {name - 1, text_[end - 2] == '/' ? end : tagEnd(text_, text_.find("</include", end))};
}

// Where the name of an element stands.
std::size_t XmlPart::nameOf(pugi::xml_node element) const {
  const auto offset = static_cast<std::size_t>(element.offset_debug());
  if (offset < text_.size() && text({offset, text_.size()}).starts_with(element.name())) return offset;
  throw SceneError(path_ + ": is not UTF-8, so that it can neither include a file nor be included");
}

SceneError XmlPart::errorAt(std::ptrdiff_t offset, const std::string& what) const {
  const auto end = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
  return {path_, lineAt(static_cast<std::size_t>(end)), what};
}

}  // namespace saccade
