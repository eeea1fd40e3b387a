#include "log/escape.h"

#include <algorithm>
#include <cstdio>

#include "base/text_cut.h"

namespace saccade {
namespace {

// The code of a control character: those of ASCII, DEL and U+0080 to U+009F. 0 for any other character.
unsigned controlOf(std::string_view character) {
  const unsigned first = static_cast<unsigned char>(character[0]);
  if (character.size() == 2 && first == 0xC2) {
    const unsigned number = static_cast<unsigned char>(character[1]);
    return number < 0xA0 ? number : 0;
  }
  return first < ' ' || first == 0x7F ? first : 0;
}

std::string escapeOf(unsigned control) {
  if (control == '\n') return "\\n";
  char text[8];
  std::snprintf(text, sizeof text, "\\u%04x", control);
  return text;
}

// Puts a backslash before each character of `marked`.
std::string escape(std::string_view text, std::string_view marked) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view character = length > 0 ? text.substr(0, length) : "\uFFFD";
    const unsigned control = controlOf(character);
    if (marked.find(character) != marked.npos) escaped += '\\';
    escaped += control > 0 || text[0] == '\0' ? escapeOf(control) : std::string(character);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

}  // namespace

std::string escapeControls(std::string_view text) {
  return escape(text, "");
}

std::string quoteJson(std::string_view text) {
  return '"' + escape(text, "\"\\") + '"';
}

}  // namespace saccade
