// The bytes of a zip archive around its members, as in APPNOTE.TXT of PKWARE 6.3: headers and directory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace saccade::client {

struct ZipMember {
  std::string name;
  bool deflated = false;
  std::uint32_t crc = 0;               // of the bytes before compression
  std::uint64_t size = 0, packed = 0;  // bytes, before and after compression
  std::uint64_t offset = 0;            // of its header in the archive
};

// A member that is stored as it is, without its place.
ZipMember zipMember(const std::string& name, std::string_view bytes);
// The CRC of the bytes whose CRC is `before`, and these.
std::uint32_t zipCrc(std::string_view bytes, std::uint32_t before = 0);

// Stands at member.offset, before the packed bytes. As NumPy does, it always gives the sizes as 64 bits.
std::string zipHeader(const ZipMember& member);
// Stands at `offset`, after the last member; the end of the file.
std::string zipDirectory(const std::vector<ZipMember>& members, std::uint64_t offset);

}  // namespace saccade::client
