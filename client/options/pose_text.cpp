#include "client/options/pose_text.h"

#include <fstream>
#include <stdexcept>

#include "saccade/wire/ranges.h"

namespace saccade::client {
namespace {

// How many bytes follow the first byte of a UTF-8 character; -1: no character begins so.
int followers(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

// The schema wants UTF-8; protobuf reports anything else in its own words.
bool isText(const std::string& bytes) {
  int due = 0;  // bytes of the present character
  for (const unsigned char byte : bytes) {
    const bool follows = byte >= 0x80 && byte < 0xC0;
    if (byte == 0 || follows != (due > 0)) return false;
    due = follows ? due - 1 : followers(byte);
    if (due < 0) return false;
  }
  return due == 0;
}

}  // namespace

std::string readPoseText(const std::string& option, const std::string& path) {
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument(option + ": '" + path + "' " + what);
  };
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("cannot be read");
  std::string text(ranges::kMaxCsvBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad()) fail("cannot be read");
  if (text.size() > ranges::kMaxCsvBytes)
    fail("is longer than " + std::to_string(ranges::kMaxCsvBytes) + " bytes");
  if (text.empty()) fail("is empty");
  if (!isText(text)) fail("is not a text file");
  return text;
}

}  // namespace saccade::client
