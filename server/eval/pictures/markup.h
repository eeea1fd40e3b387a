// Text for SVG and HTML.
#pragma once

#include <string>

namespace saccade::eval {

inline std::string escapeMarkup(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

}  // namespace saccade::eval
