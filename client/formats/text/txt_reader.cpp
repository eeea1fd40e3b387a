// The text format of rpg_e2vid: a line `width height`, then one line `t x y p` per event, t in seconds.
#include <algorithm>

#include "client/formats/common/units.h"
#include "client/formats/text/text_reader.h"

namespace saccade::client {
namespace {

constexpr std::size_t kDecimals = 9;

std::optional<ImageSize> parseSize(std::string_view line) {
  const auto width = takeNumber<std::uint32_t>(line, ' ');
  const auto height = takeNumber<std::uint32_t>(line, kEnd);
  if (!width || !height) return std::nullopt;
  return ImageSize{*width, *height};
}

// Decimal digits after the point, as whole nanoseconds; digits beyond the ninth are cut off.
std::optional<std::int64_t> takeDecimals(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  std::string digits(text.substr(0, std::min(end, kDecimals)));
  digits.resize(kDecimals, '0');
  if (!std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  text.remove_prefix(std::min(end + 1, text.size()));
  return std::stoll(digits);
}

std::optional<Event> parseLine(std::string_view line) {
  const auto seconds = takeNumber<std::uint32_t>(line, '.');
  const auto decimals_ns = takeDecimals(line);
  const auto x = takeNumber<std::uint16_t>(line, ' ');
  const auto y = takeNumber<std::uint16_t>(line, ' ');
  const auto p = takeNumber<std::uint8_t>(line, kEnd);
  if (!seconds || !decimals_ns || !x || !y || !p) return std::nullopt;
  return Event{*seconds * kNsPerSecond + *decimals_ns, *x, *y, *p};
}

std::unique_ptr<Reader> make(const std::string& path) {
  return std::make_unique<TextReader>(path, "'t x y p' under a line 'width height'", parseSize, parseLine);
}

}  // namespace

extern const ReaderInfo kTxtReader{".txt", "a line \"width height\", then t[s] x y p", make};

}  // namespace saccade::client
