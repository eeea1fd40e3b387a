// CSV: the heading `t_us,x,y,p`, then one line per event. The file does not tell the size of the image.
#include "client/formats/common/units.h"
#include "client/formats/text/text_reader.h"

namespace saccade::client {
namespace {

constexpr const char* kHeading = "t_us,x,y,p";

std::optional<ImageSize> parseHeading(std::string_view line) {
  if (line != kHeading) return std::nullopt;
  return ImageSize{};
}

std::optional<Event> parseLine(std::string_view line) {
  const auto t_us = takeNumber<std::int64_t>(line, ',');
  const auto x = takeNumber<std::uint16_t>(line, ',');
  const auto y = takeNumber<std::uint16_t>(line, ',');
  const auto p = takeNumber<std::uint8_t>(line, kEnd);
  if (!t_us || !x || !y || !p) return std::nullopt;
  std::int64_t t_ns;
  if (__builtin_mul_overflow(*t_us, kNsPerUs, &t_ns)) return std::nullopt;
  return Event{t_ns, *x, *y, *p};
}

std::unique_ptr<Reader> make(const std::string& path) {
  return std::make_unique<TextReader>(path, "t_us,x,y,p", parseHeading, parseLine);
}

}  // namespace

extern const ReaderInfo kCsvReader{".csv", "t_us,x,y,p with a heading", make};

}  // namespace saccade::client
