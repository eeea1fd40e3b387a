#include "client/formats/evt/raw_header_reader.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "client/formats/text/text_numbers.h"

namespace saccade::client {
namespace {

constexpr std::size_t kMaxLine = 4096;  // bytes
constexpr std::size_t kMaxLines = 1000;

// Values by their keys.
using Fields = std::map<std::string, std::string, std::less<>>;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == text.npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

// Splits `text` at the first `separator`; the second part is empty without one.
std::pair<std::string_view, std::string_view> split(std::string_view text, char separator) {
  const auto at = std::min(text.find(separator), text.size());
  return {trimmed(text.substr(0, at)), trimmed(text.substr(std::min(at + 1, text.size())))};
}

// The next line without its "% "; nullopt where the words begin.
std::optional<std::string> nextLine(std::istream& file, const std::string& path) {
  if (file.get() != '%') {
    file.unget();
    return std::nullopt;
  }
  if (file.peek() != ' ') {
    file.unget();
    return std::nullopt;
  }
  char line[kMaxLine];
  if (!file.getline(line, sizeof(line))) throw FileFault(path, "a line of its header does not end");
  return std::string(trimmed(line));
}

Fields readFields(std::istream& file, const std::string& path) {
  Fields fields;
  while (const auto line = nextLine(file, path)) {
    const auto [key, value] = split(*line, ' ');
    if (key == "end") break;
    fields.insert_or_assign(std::string(key), value);
    if (fields.size() > kMaxLines) throw FileFault(path, "its header has more than 1000 keys");
  }
  return fields;
}

std::string upperCase(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  return upper;
}

// "EVT3" of "EVT3;height=720;width=1280", or of version "3.0".
std::string encodingOf(const Fields& fields, const std::string& path) {
  std::string version, format;
  if (const auto evt = fields.find("evt"); evt != fields.end())
    version = evt->second == "2.1" ? "EVT21" : "EVT" + std::string(split(evt->second, '.').first);
  if (const auto found = fields.find("format"); found != fields.end())
    format = upperCase(split(found->second, ';').first);
  if (version.empty() && format.empty())
    throw FileFault(path, "has no header of Prophesee that names an encoding, as '% evt 3.0' does");
  if (!version.empty() && !format.empty() && version != format)
    throw FileFault(path, "its header names two encodings, " + version + " and " + format);
  return format.empty() ? version : format;
}

std::uint32_t edgeOf(std::string_view text, const std::string& path) {
  std::string_view rest = text;
  const auto edge = takeNumber<std::uint32_t>(rest, kEnd);
  if (!edge || *edge == 0) throw FileFault(path, "its header has the size '" + std::string(text) + "'");
  return *edge;
}

// From "EVT3;height=720;width=1280" or "1280x720".
ImageSize sizeOf(const Fields& fields, const std::string& path) {
  ImageSize size;
  if (const auto geometry = fields.find("geometry"); geometry != fields.end()) {
    const auto [width, height] = split(geometry->second, 'x');
    size = {edgeOf(width, path), edgeOf(height, path)};
  }
  if (const auto format = fields.find("format"); format != fields.end()) {
    for (std::string_view rest = split(format->second, ';').second; !rest.empty();) {
      const auto [option, others] = split(rest, ';');
      const auto [name, value] = split(option, '=');
      if (name == "width") size.width = edgeOf(value, path);
      if (name == "height") size.height = edgeOf(value, path);
      rest = others;
    }
  }
  return size;
}

}  // namespace

RawHeader readRawHeader(std::istream& file, const std::string& path) {
  const Fields fields = readFields(file, path);
  return {encodingOf(fields, path), sizeOf(fields, path)};
}

}  // namespace saccade::client
