#include "base/text_cut.h"

#include <algorithm>

namespace saccade {

std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first > 0xF4 || (first == 0xF4 && second >= 0x90);
  return overlong || surrogate || beyond ? 0 : length;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string cutText(std::string_view text, std::size_t max_bytes) {
  std::string cut;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view character = length > 0 ? text.substr(0, length) : "\uFFFD";
    if (cut.size() + character.size() > max_bytes) return cut + "...";
    cut += character;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return cut;
}

}  // namespace saccade
