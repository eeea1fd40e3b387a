// Reads words and numbers of the command line.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/generated_enum_reflection.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/formats/common/reader.h"
#include "saccade/v1/geometry.pb.h"

namespace saccade::client {

// The words for an enum of the schema, ", " between them: "lossless, live, broadcast" for Delivery.
std::string enumWords(const google::protobuf::EnumDescriptor& names);

// The number for a word: "lossless" gives DELIVERY_LOSSLESS. Throws std::invalid_argument with `option` and
// the valid words.
int enumNumber(const google::protobuf::EnumDescriptor& names, const std::string& option,
               const std::string& word);

// The names of the fields of a message, ", " between them.
std::string fieldNames(const google::protobuf::Descriptor& message);

template <class Enum>
std::string enumWords() {
  return enumWords(*google::protobuf::GetEnumDescriptor<Enum>());
}

// The word for a number that the schema names.
std::string enumWord(const google::protobuf::EnumDescriptor& names, int number);
template <class Enum>
std::string enumWord(Enum value) {
  return enumWord(*google::protobuf::GetEnumDescriptor<Enum>(), value);
}

template <class Enum>
Enum enumValue(const std::string& option, const std::string& word) {
  return static_cast<Enum>(enumNumber(*google::protobuf::GetEnumDescriptor<Enum>(), option, word));
}

// The number that `text` is as a whole; nothing if it is none of type T.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  T value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

// Reads numbers with commas between them; none where one is no number.
std::vector<double> parseNumbers(std::string text);
// Reads X,Y,Z, which sets no rotation, or X,Y,Z,QX,QY,QZ,QW. Throws std::invalid_argument with `option`.
v1::RigidTransform parsePose(const std::string& option, const std::string& text);

// Reads WIDTHxHEIGHT. Throws std::invalid_argument with `option`.
ImageSize parseSize(const std::string& option, const std::string& text);

// The parts before and after the first `separator`; without one, the second is empty.
inline std::pair<std::string, std::string> splitAt(const std::string& text, char separator) {
  const std::size_t at = std::min(text.find(separator), text.size());
  return {text.substr(0, at), text.substr(std::min(at + 1, text.size()))};
}

}  // namespace saccade::client
