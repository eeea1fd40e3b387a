#include "farm/card/json_text.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

namespace saccade::farm {
namespace {

std::string indented(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return result;
}

std::string enclosed(char open, const std::vector<std::string>& lines, char close) {
  if (lines.empty()) return {open, close};
  std::string text(1, open);
  for (const std::string& line : lines) text += (text.size() > 1 ? ",\n  " : "\n  ") + indented(line);
  return text + "\n" + close;
}

}  // namespace

std::string jsonText(const std::string& text) {
  google::protobuf::Value value;
  value.set_string_value(text);
  std::string json;
  if (google::protobuf::util::MessageToJsonString(value, &json).ok()) return json;
  std::string plain = text;
  for (char& c : plain) c = static_cast<unsigned char>(c) < 0x80 ? c : '?';
  return jsonText(plain);
}

std::string jsonObject(const std::vector<std::pair<std::string, std::string>>& members) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : members) lines.push_back(jsonText(name) + ": " + value);
  return enclosed('{', lines, '}');
}

std::string jsonArray(const std::vector<std::string>& elements) {
  return enclosed('[', elements, ']');
}

}  // namespace saccade::farm
