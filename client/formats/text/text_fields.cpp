#include "client/formats/text/text_fields.h"

#include <algorithm>

namespace saccade::client {
namespace {

std::size_t endOfField(std::string_view text, char separator) {
  return std::min(separator == kBlanks ? text.find_first_of(" \t") : text.find(separator), text.size());
}

}  // namespace

bool isComment(std::string_view line) {
  skipBlanks(line);
  return line.empty() || line.front() == '#' || line.front() == '%';
}

char separatorOf(std::string_view line) {
  for (const char c : {',', ';'}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return kBlanks;
}

std::vector<std::string_view> fieldsOf(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (skipBlanks(line); !line.empty() || !fields.empty(); skipBlanks(line)) {
    std::string_view field = line.substr(0, endOfField(line, separator));
    line.remove_prefix(field.size());
    while (!field.empty() && isBlank(field.back())) field.remove_suffix(1);
    fields.push_back(field);
    skipBlanks(line);
    if (line.empty()) break;
    if (separator != kBlanks) line.remove_prefix(1);
  }
  return fields;
}

void skipField(std::string_view& text, char separator) {
  text.remove_prefix(endOfField(text, separator));
}

}  // namespace saccade::client
