// Words of the command line as values of a request.
#pragma once

#include <google/protobuf/generated_enum_reflection.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace saccade::client {

// The value of a schema's enum that `name` stands for: "lossless" is DELIVERY_LOSSLESS. Throws
// std::invalid_argument naming `option` and what is valid.
template <class Enum>
Enum enumValue(const std::string& option, const std::string& prefix, const std::string& name) {
  const auto* names = google::protobuf::GetEnumDescriptor<Enum>();
  std::string valid;
  for (int i = 1; i < names->value_count(); ++i) {  // 0 is _UNSPECIFIED
    std::string word = names->value(i)->name().substr(prefix.size());
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    if (word == name) return static_cast<Enum>(names->value(i)->number());
    valid += (i > 1 ? ", " : "") + word;
  }
  throw std::invalid_argument(option + ": '" + name + "' is none of " + valid);
}

// All of `text`, or nothing.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  T value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

// What stands before and behind `separator`; nothing behind where there is none.
inline std::pair<std::string, std::string> splitAt(const std::string& text, char separator) {
  const std::size_t at = std::min(text.find(separator), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

}  // namespace saccade::client
