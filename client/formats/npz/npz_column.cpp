#include "client/formats/npz/npz_column.h"

#include <new>
#include <stdexcept>

namespace saccade::client {
namespace {

constexpr int kLevel = 1, kRawDeflate = -15, kMostMemory = 9;
constexpr std::size_t kHeaderBytes = 128;
constexpr std::string_view kLastBlock("\3\0", 2);  // of a deflated stream: an empty one

// A block of a deflated stream that holds the bytes as they are.
std::string storedBlock(const std::string& bytes) {
  const auto size = static_cast<std::uint16_t>(bytes.size());
  const std::uint16_t lengths[] = {size, static_cast<std::uint16_t>(~size)};
  return std::string(1, '\0') + std::string(reinterpret_cast<const char*>(lengths), sizeof lengths) + bytes;
}

}  // namespace

std::string npyHeader(const std::string& type, const std::string& shape) {
  const std::string start("\x93NUMPY\1\0\x76\0", 10);  // 0x76 bytes follow
  std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  text.resize(kHeaderBytes - start.size() - 1, ' ');
  return start + text + '\n';
}

NpzColumn::NpzColumn(const std::string& path, const std::string& name, const char* type,
                     std::size_t value_bytes, int strategy, const std::string& shape)
    : name_(name), type_(type), shape_(shape), value_bytes_(value_bytes), file_(path) {
  if (deflateInit2(&deflate_, kLevel, Z_DEFLATED, kRawDeflate, kMostMemory, strategy) != Z_OK)
    throw std::bad_alloc();
}

NpzColumn::~NpzColumn() {
  deflateEnd(&deflate_);
}

// The flush ends the block at a whole byte, and the reset lets the next one stand without it.
void NpzColumn::spool(std::string_view values) {
  constexpr std::size_t kFlushBytes = 16;
  deflateReset(&deflate_);
  packed_.resize(deflateBound(&deflate_, values.size()) + kFlushBytes);
  deflate_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(values.data()));
  deflate_.avail_in = static_cast<uInt>(values.size());
  deflate_.next_out = reinterpret_cast<Bytef*>(packed_.data());
  deflate_.avail_out = static_cast<uInt>(packed_.size());
  const int done = deflate(&deflate_, Z_FULL_FLUSH);
  if (done != Z_OK || deflate_.avail_in > 0 || deflate_.avail_out == 0)
    throw std::logic_error("deflate() takes more room than deflateBound() says");
  packed_.resize(packed_.size() - deflate_.avail_out);
  file_.write(kept_.packed, packed_);
  spooled_ = {kept_.size + values.size(), kept_.packed + packed_.size(), zipCrc(values, kept_.crc)};
}

void NpzColumn::keep() {
  kept_ = spooled_;
}

std::string NpzColumn::header() const {
  return npyHeader(type_, "(" + std::to_string(kept_.size / value_bytes_) + "," + shape_ + ")");
}

ZipMember NpzColumn::member() const {
  const std::string start = header();
  const auto crc = crc32_combine(zipCrc(start), kept_.crc, static_cast<z_off_t>(kept_.size));
  return {name_ + ".npy", true, static_cast<std::uint32_t>(crc), start.size() + kept_.size,
          storedBlock(start).size() + kept_.packed + kLastBlock.size()};
}

void NpzColumn::moveTo(OutputFile& archive, const ZipMember& member) {
  const std::string start = zipHeader(member) + storedBlock(header());
  const std::uint64_t begin = member.offset + start.size();
  file_.moveTo(archive, begin, kept_.packed);
  archive.overwrite(member.offset, start);
  archive.overwrite(begin + kept_.packed, kLastBlock);
}

}  // namespace saccade::client
