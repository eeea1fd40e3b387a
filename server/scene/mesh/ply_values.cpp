#include "scene/mesh/ply_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/text_cut.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {

void PlyValues::fail(const std::string& what) const {
  throw SceneError(path_ + ": " + what);
}

void PlyValues::ignore(const PlyProperty& property) {
  const long long values = property.is_list ? readCount(property.count_type) : 1;
  for (long long i = 0; i < values; ++i) readNumber(property.type);
}

long long PlyValues::readCount(PlyType type) {
  const double count = readNumber(type);
  if (!(count >= 0 && count == std::floor(count))) fail("the length of a list is not a whole number");
  return static_cast<long long>(std::min(count, 1e18));
}

double PlyValues::readNumber(PlyType type) {
  if (format_ != PlyFormat::kAscii) return readBinary(type);
  const auto word = takeWord(rest_);
  if (word.empty()) fail("the file ends within its data");
  const auto number = parseNumber(word);
  if (!number) fail("'" + cutText(word, 40) + "' is not a finite number");
  return *number;
}

double PlyValues::readBinary(PlyType type) {
  const auto size = static_cast<std::size_t>(type.bytes);
  if (rest_.size() < size) fail("the file ends within its data");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = format_ == PlyFormat::kLittleEndian ? size - 1 - i : i;
    bits = bits << 8 | static_cast<unsigned char>(rest_[at]);
  }
  rest_.remove_prefix(size);
  if (type.is_float)
    return size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
  if (!type.is_signed) return static_cast<double>(bits);
  const int unused = 64 - 8 * type.bytes;  // shift the sign up and back down
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace saccade
