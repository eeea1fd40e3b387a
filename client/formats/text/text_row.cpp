#include "client/formats/text/text_row.h"

#include <utility>

#include "client/formats/common/units.h"
#include "client/formats/text/text_fields.h"
#include "client/formats/text/text_numbers.h"

namespace saccade::client {
namespace {

bool takePixel(std::string_view& text, std::uint16_t& pixel) {
  std::int64_t value;
  if (!takeWhole(text, value) || value < 0 || value > UINT16_MAX) return false;
  pixel = static_cast<std::uint16_t>(value);
  return true;
}

// As Python writes a bool.
std::optional<std::uint8_t> takeBool(std::string_view& text) {
  for (const auto& [word, value] : {std::pair{"True", 1}, {"true", 1}, {"False", 0}, {"false", 0}}) {
    if (!text.starts_with(word)) continue;
    text.remove_prefix(std::string_view(word).size());
    return static_cast<std::uint8_t>(value);
  }
  return std::nullopt;
}

}  // namespace

bool RowParser::parse(std::string_view line, Event& event) {
  for (std::size_t i = 0; i < form_.columns.size(); ++i) {
    if (i > 0 && !takeSeparator(line, form_.separator)) return false;
    skipBlanks(line);
    if (!takeField(line, form_.columns[i], event)) return false;
  }
  skipBlanks(line);
  return line.empty();
}

bool RowParser::takeField(std::string_view& text, const std::optional<Role>& role, Event& event) {
  if (!role) return skipField(text, form_.separator), true;
  switch (*role) {
    case Role::kT:
      return takeTime(text, form_.unit, form_.decimals, event.t_ns) &&
             !__builtin_mul_overflow(event.t_ns, kNsPerUs, &event.t_ns);
    case Role::kX:
      return takePixel(text, event.x);
    case Role::kY:
      return takePixel(text, event.y);
    case Role::kP:
      if (const auto p = takePolarity(text)) return event.p = *p, true;
      return false;
  }
  return false;
}

std::optional<std::uint8_t> RowParser::takePolarity(std::string_view& text) {
  std::int64_t value;
  return takeWhole(text, value) ? polarities_.parse(value) : takeBool(text);
}

}  // namespace saccade::client
