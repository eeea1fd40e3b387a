#include "client/formats/text/text_head.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "client/formats/common/column_names.h"
#include "client/formats/common/event_columns.h"
#include "client/formats/text/text_fields.h"
#include "client/formats/text/text_numbers.h"

namespace saccade::client {
namespace {

std::vector<std::string> namesIn(std::string_view line) {
  const auto fields = fieldsOf(line, separatorOf(line));
  return {fields.begin(), fields.end()};
}

// Of a comment, which may have other words.
bool namesColumns(const std::string& path, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [](const auto& word) { return parseColumnName(word); }) &&
         placesOf(path, words);
}

// Two whole numbers and nothing else.
std::optional<ImageSize> sizeIn(const std::string& path, std::string_view line, char separator) {
  std::int64_t width, height;
  skipBlanks(line);
  if (!takeWhole(line, width) || !takeSeparator(line, separator)) return std::nullopt;
  skipBlanks(line);
  if (!takeWhole(line, height)) return std::nullopt;
  skipBlanks(line);
  if (!line.empty()) return std::nullopt;
  return ImageSize{toSide(path, "width", width), toSide(path, "height", height)};
}

void takeComment(const std::string& path, std::string_view line, TextHead& head) {
  constexpr std::string_view kGeometry = "geometry:";
  while (!line.empty() && (isBlank(line.front()) || line.front() == '#' || line.front() == '%'))
    line.remove_prefix(1);
  if (line.starts_with(kGeometry)) {
    const auto size = sizeIn(path, line.substr(kGeometry.size()), ',');
    if (!size) throw FileFault(path, "the line of geometry is not 'geometry:WIDTH,HEIGHT'");
    head.size = *size;
    head.geometry = true;
  }
  if (head.names.empty() && namesColumns(path, namesIn(line))) head.names = namesIn(line);
}

bool startsAsNumber(std::string_view line) {
  skipBlanks(line);
  return !line.empty() && (std::isdigit(static_cast<unsigned char>(line.front())) || line.front() == '-' ||
                           line.front() == '.' || line.front() == '+');
}

}  // namespace

TextHead parseHead(const std::string& path, const std::vector<std::string>& lines) {
  TextHead head;
  bool heading = false;
  for (const std::string& line : lines) {
    const auto size = sizeIn(path, line, kBlanks);
    if (isComment(line)) {
      takeComment(path, line, head);
    } else if (size && !head.size_line && !heading) {
      head.size = *size;
      head.size_line = true;
    } else if (!startsAsNumber(line) && !heading) {
      head.names = namesIn(line);
      heading = true;
    } else {
      break;
    }
    ++head.lines;
  }
  return head;
}

}  // namespace saccade::client
