#include "client/options/request_text.h"

#include <cctype>
#include <stdexcept>

namespace saccade::client {
namespace {

// By number from 1 on; 0 is PREFIX_UNSPECIFIED, and PREFIX_ begins every name.
std::vector<std::string> wordsOf(const google::protobuf::EnumDescriptor& names) {
  const std::size_t prefix = names.value(0)->name().size() - std::string_view("UNSPECIFIED").size();
  std::vector<std::string> words;
  for (int i = 1; i < names.value_count(); ++i) {
    std::string word = names.value(i)->name().substr(prefix);
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    words.push_back(word);
  }
  return words;
}

}  // namespace

std::string enumWords(const google::protobuf::EnumDescriptor& names) {
  std::string text;
  for (const std::string& word : wordsOf(names)) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string enumWord(const google::protobuf::EnumDescriptor& names, int number) {
  const auto words = wordsOf(names);
  const auto* value = names.FindValueByNumber(number);
  return value && value->index() > 0 ? words[static_cast<std::size_t>(value->index()) - 1]
                                     : std::to_string(number);
}

std::string fieldNames(const google::protobuf::Descriptor& message) {
  std::string text;
  for (int i = 0; i < message.field_count(); ++i) text += (i == 0 ? "" : ", ") + message.field(i)->name();
  return text;
}

int enumNumber(const google::protobuf::EnumDescriptor& names, const std::string& option,
               const std::string& word) {
  const std::vector<std::string> words = wordsOf(names);
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.end())
    throw std::invalid_argument(option + ": '" + word + "' is none of " + enumWords(names));
  return names.value(1 + static_cast<int>(at - words.begin()))->number();
}

std::vector<double> parseNumbers(std::string text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const auto [first, rest] = splitAt(text, ',');
    const auto number = parseNumber<double>(first);
    if (!number) return {};
    numbers.push_back(*number);
    text = rest;
  }
  return numbers;
}

v1::RigidTransform parsePose(const std::string& option, const std::string& text) {
  const std::vector<double> n = parseNumbers(text);
  if (n.size() != 3 && n.size() != 7)
    throw std::invalid_argument(option + ": '" + text + "' is not X,Y,Z or X,Y,Z,QX,QY,QZ,QW");
  v1::RigidTransform pose;
  v1::Vector3& position = *pose.mutable_position();
  position.set_x(n[0]), position.set_y(n[1]), position.set_z(n[2]);
  if (n.size() == 3) return pose;
  v1::Quaternion& rotation = *pose.mutable_rotation();
  rotation.set_x(n[3]), rotation.set_y(n[4]), rotation.set_z(n[5]), rotation.set_w(n[6]);
  return pose;
}

ImageSize parseSize(const std::string& option, const std::string& text) {
  const auto [left, right] = splitAt(text, text.find('x') == std::string::npos ? 'X' : 'x');
  const auto width = parseNumber<std::uint16_t>(left), height = parseNumber<std::uint16_t>(right);
  if (width.value_or(0) == 0 || height.value_or(0) == 0)
    throw std::invalid_argument(option + ": '" + text +
                                "' is not WIDTHxHEIGHT with sides up to 65535, such as 346x260");
  return {*width, *height};
}

}  // namespace saccade::client
