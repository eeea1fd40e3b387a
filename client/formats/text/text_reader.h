// Reads a text format: a first line, then one line per event. A line has at most 4 KiB.
#pragma once

#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "client/formats/common/reader.h"

namespace saccade::client {

class TextReader : public Reader {
 public:
  // Takes the first line; returns the size of the image if the line tells it, and nullopt if it is wrong.
  using ParseFirst = std::optional<ImageSize> (*)(std::string_view line);
  using ParseLine = std::optional<Event> (*)(std::string_view line);

  // `form`: what lines look like, for errors.
  TextReader(const std::string& path, const char* form, ParseFirst parse_first, ParseLine parse_line);

  ImageSize size() const override { return size_; }
  bool read(Events& events) override;

 private:
  static constexpr std::size_t kLongestLine = 4096;

  bool nextLine();
  [[noreturn]] void fail() const;

  const std::string path_;
  const std::string form_;
  const ParseLine parse_line_;
  std::ifstream file_;
  std::array<char, kLongestLine + 2> buffer_;  // with CR and an end
  std::string_view line_;
  std::uint64_t number_ = 0;  // of the line
  ImageSize size_;
};

// Takes a number and the separator after it from the front of `text`; nullopt if they are not there. With
// kEnd as separator the number is the last of the line.
inline constexpr char kEnd = 0;
template <class T>
std::optional<T> takeNumber(std::string_view& text, char separator) {
  T value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(rest - text.data());
  if (separator == kEnd && text.empty()) return value;
  if (text.empty() || text.front() != separator) return std::nullopt;
  text.remove_prefix(1);
  return value;
}

}  // namespace saccade::client
