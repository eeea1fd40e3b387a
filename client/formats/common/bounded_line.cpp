#include "client/formats/common/bounded_line.h"

namespace saccade::client {

LineRead takeLine(std::istream& in, std::span<char> buffer, std::string_view& line) {
  in.getline(buffer.data(), static_cast<std::streamsize>(buffer.size()));
  const auto count = static_cast<std::size_t>(in.gcount());
  if (in.fail()) return !in.bad() && count + 1 == buffer.size() ? LineRead::kTooLong : LineRead::kEnd;
  line = {buffer.data(), count - (in.eof() ? 0 : 1)};
  if (line.ends_with('\r')) line.remove_suffix(1);
  return LineRead::kLine;
}

}  // namespace saccade::client
