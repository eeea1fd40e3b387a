#include "client/formats/aedat4/packet_file.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "client/formats/aedat4/packets.h"

namespace saccade::client::aedat4 {
namespace {

constexpr std::uint64_t kMostHeader = 16 << 20, kMostPacket = 256 << 20;  // bytes

}  // namespace

PacketFile::PacketFile(const std::string& path)
    : path_(path), file_(path, std::ios::binary), file_size_(file_ ? std::filesystem::file_size(path) : 0) {
  if (!file_) throw std::system_error(errno, std::generic_category(), path);
  readHeader();
}

void PacketFile::readHeader() {
  std::uint32_t size;
  const std::uint64_t begin = kMagic.size() + sizeof size;
  if (file_size_ < begin || take(0, kMagic.size()) != kMagic) fail("does not begin as AEDAT 4 does");
  std::memcpy(&size, take(kMagic.size(), sizeof size).data(), sizeof size);
  if (size > std::min(file_size_ - begin, kMostHeader))
    fail("the header has " + std::to_string(size) + " bytes, more than the file or than 16 MiB");
  at_ = begin + size;
  try {
    header_ = decodeHeader(take(kMagic.size(), sizeof size + size));
    streams_ = streamsOf(header_.info_node);
  } catch (const std::runtime_error& fault) {
    fail(std::string("the header ") + fault.what());
  }
}

std::optional<PacketFile::Packet> PacketFile::next() {
  const bool finished = header_.table_position != kNoTable;
  const auto table = static_cast<std::uint64_t>(header_.table_position);
  const std::uint64_t end = finished ? std::min(table, file_size_) : file_size_;
  if (at_ == end && (!finished || end == table)) return std::nullopt;
  const std::string place = "the packet at byte " + std::to_string(at_) + " ";
  PacketHeader header{};
  const bool begun = at_ <= end && end - at_ >= sizeof header;
  if (begun) std::memcpy(&header, take(at_, sizeof header).data(), sizeof header);
  if (header.size < 0) fail(place + "has the size " + std::to_string(header.size));
  const auto size = static_cast<std::uint32_t>(header.size);
  if (!begun || size > end - at_ - sizeof header) {
    if (!finished) return std::nullopt;
    fail(place + "does not end before " +
         (end == table ? "the table" : "the end of the file, which should reach") + " at byte " +
         std::to_string(table));
  }
  const Packet packet{at_, streamOf(header.stream_id), size};
  if (!packet.stream) fail(place + "is of the unknown stream " + std::to_string(header.stream_id));
  at_ += sizeof header + size;
  return packet;
}

const std::string& PacketFile::content(const Packet& packet) {
  if (packet.size > kMostPacket) fail(packet, "has more than 256 MiB");
  try {
    expand(content_, take(packet.start + sizeof(PacketHeader), packet.size), header_.compression,
           kMostPacket);
  } catch (const std::runtime_error& fault) {
    fail(packet, fault.what());
  }
  return content_;
}

const Stream* PacketFile::streamOf(std::int32_t id) const {
  const auto found =
      std::find_if(streams_.begin(), streams_.end(), [=](const Stream& stream) { return stream.id == id; });
  return found == streams_.end() ? nullptr : &*found;
}

std::string PacketFile::take(std::uint64_t from, std::uint64_t size) {
  std::string bytes(size, '\0');
  file_.seekg(static_cast<std::streamoff>(from));
  if (!file_.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw std::system_error(errno, std::generic_category(), path_);
  return bytes;
}

void PacketFile::fail(const Packet& packet, const std::string& what) const {
  fail("the packet at byte " + std::to_string(packet.start) + " " + what);
}

void PacketFile::fail(const std::string& what) const {
  throw FileFault(path_, what);
}

}  // namespace saccade::client::aedat4
