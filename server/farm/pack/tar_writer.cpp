#include "farm/pack/tar_writer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

namespace saccade::farm {
namespace {

constexpr std::uint64_t kMostName = 100, kMostBytes = std::uint64_t{1} << 33;  // of ustar alone
constexpr std::size_t kSumAt = 148;

std::string octal(std::uint64_t number, int digits) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%0*llo", digits, static_cast<unsigned long long>(number));
  return text.data();
}

void put(std::string& block, std::size_t at, std::string_view text) {
  block.replace(at, text.size(), text);
}

// `type`: '0' a file, 'x' an extended header.
std::string ustarBlock(const std::string& name, std::uint64_t bytes, char type) {
  std::string block(kTarBlock, '\0');
  put(block, 0, name.substr(0, kMostName));
  put(block, 100, octal(0644, 7));
  put(block, 108, octal(0, 7));  // user
  put(block, 116, octal(0, 7));  // group
  put(block, 124, octal(bytes < kMostBytes ? bytes : 0, 11));
  put(block, 136, octal(0, 11));  // time
  put(block, kSumAt, "        ");
  block[156] = type;
  put(block, 257,
      {"ustar\0"
       "00",
       8});
  put(block, 329, octal(0, 7));  // device
  put(block, 337, octal(0, 7));
  const auto add = [](std::uint64_t sum, char c) { return sum + static_cast<unsigned char>(c); };
  put(block, kSumAt, octal(std::accumulate(block.begin(), block.end(), std::uint64_t{0}, add), 6) + '\0');
  return block;
}

std::uint64_t padding(std::uint64_t bytes) {
  return (kTarBlock - bytes % kTarBlock) % kTarBlock;
}

// "LENGTH key=value\n", where LENGTH counts itself.
std::string paxRecord(const std::string& key, const std::string& value) {
  const std::string rest = " " + key + "=" + value + "\n";
  std::size_t length = rest.size() + 1;
  while (length != rest.size() + std::to_string(length).size())
    length = rest.size() + std::to_string(length).size();
  return std::to_string(length) + rest;
}

}  // namespace

std::string tarHeader(const std::string& name, std::uint64_t bytes) {
  std::string records;
  if (name.size() > kMostName) records += paxRecord("path", name);
  if (bytes >= kMostBytes) records += paxRecord("size", std::to_string(bytes));
  std::string header;
  if (!records.empty()) {
    header = ustarBlock("pax", records.size(), 'x') + records;
    header.append(padding(records.size()), '\0');
  }
  return header + ustarBlock(name, bytes, '0');
}

std::uint64_t tarSpace(const std::string& name, std::uint64_t bytes) {
  return tarHeader(name, bytes).size() + bytes + padding(bytes);
}

void TarWriter::begin(const std::string& name, std::uint64_t bytes) {
  output_.append(tarHeader(name, bytes));
}

void TarWriter::end() {
  output_.append(std::string(padding(output_.size()), '\0'));
}

void TarWriter::close() {
  output_.append(std::string(kTarEnd, '\0'));
  output_.close();
}

}  // namespace saccade::farm
