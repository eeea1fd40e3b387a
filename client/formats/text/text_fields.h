// The parts of a line of a text file: between commas, semicolons, or blanks and tabs.
#pragma once

#include <string_view>
#include <vector>

namespace saccade::client {

inline constexpr char kBlanks = ' ';  // as a separator: any number of blanks and tabs

inline bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

inline void skipBlanks(std::string_view& text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
}

bool isComment(std::string_view line);  // it is empty, or starts with # or %
char separatorOf(std::string_view line);
// The parts without blanks around them.
std::vector<std::string_view> fieldsOf(std::string_view line, char separator);

// Takes the separator off the front of `text`, with blanks before it; false: it is not there.
inline bool takeSeparator(std::string_view& text, char separator) {
  if (separator == kBlanks) return !text.empty() && isBlank(text.front());
  skipBlanks(text);
  if (text.empty() || text.front() != separator) return false;
  text.remove_prefix(1);
  return true;
}
void skipField(std::string_view& text, char separator);

}  // namespace saccade::client
