#include "client/formats/npz/zip_archive.h"

#include <zlib.h>

#include <algorithm>

namespace saccade::client {
namespace {

constexpr std::uint16_t kZip64Version = 45, kStored = 0, kDeflated = 8, kZip64Field = 1;
constexpr std::uint16_t kMadeByUnix = 3 << 8, kDate = 1 << 5 | 1;  // the first day of 1980: none is known
constexpr std::uint32_t kMode = 0100644u << 16;
constexpr std::uint32_t kElsewhere = UINT32_MAX;  // the number is in a field of 64 bits

template <class... Numbers>
std::string littleEndian(Numbers... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

std::uint16_t short16(std::size_t number) {
  return static_cast<std::uint16_t>(number);
}

// Fields that a header and an entry of the directory share.
std::string common(const ZipMember& member, std::uint32_t packed, std::uint32_t size, std::size_t extra) {
  return littleEndian(kZip64Version, std::uint16_t{0}, member.deflated ? kDeflated : kStored,
                      std::uint16_t{0}, kDate, member.crc, packed, size, short16(member.name.size()),
                      short16(extra));
}

std::string entry(const ZipMember& m) {
  const bool large = std::max({m.size, m.packed, m.offset}) >= kElsewhere;
  const auto field = [&](std::uint64_t n) { return large ? kElsewhere : static_cast<std::uint32_t>(n); };
  const std::string extra =
      large ? littleEndian(kZip64Field, std::uint16_t{24}, m.size, m.packed, m.offset) : "";
  return "PK\1\2" + littleEndian(static_cast<std::uint16_t>(kMadeByUnix | kZip64Version)) +
         common(m, field(m.packed), field(m.size), extra.size()) +
         littleEndian(std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}, kMode, field(m.offset)) + m.name +
         extra;
}

}  // namespace

ZipMember zipMember(const std::string& name, std::string_view bytes) {
  return {name, false, zipCrc(bytes), bytes.size(), bytes.size()};
}

std::uint32_t zipCrc(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string zipHeader(const ZipMember& member) {
  const std::string extra = littleEndian(kZip64Field, std::uint16_t{16}, member.size, member.packed);
  return "PK\3\4" + common(member, kElsewhere, kElsewhere, extra.size()) + member.name + extra;
}

std::string zipDirectory(const std::vector<ZipMember>& members, std::uint64_t offset) {
  std::string bytes;
  for (const ZipMember& member : members) bytes += entry(member);
  const std::uint64_t size = bytes.size(), count = members.size();
  const bool large = offset >= kElsewhere;
  if (large) {
    constexpr std::uint64_t kRest = 44;  // bytes that follow
    bytes += "PK\6\6" + littleEndian(kRest, kZip64Version, kZip64Version, 0u, 0u, count, count, size, offset);
    bytes += "PK\6\7" + littleEndian(0u, offset + size, 1u);
  }
  const auto short_offset = large ? kElsewhere : static_cast<std::uint32_t>(offset);
  return bytes + "PK\5\6" +
         littleEndian(0u, short16(count), short16(count), static_cast<std::uint32_t>(size), short_offset,
                      std::uint16_t{0});
}

}  // namespace saccade::client
