#include "farm/engines/text.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace saccade::farm {
namespace {

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// The bytes of a character that begins with `first`; 0 where none does.
std::size_t lengthOf(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

// Surrogates and lengths that are too great pass: readers of the text refuse these themselves.
bool isUtf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = lengthOf(static_cast<unsigned char>(text[at]));
    if (length == 0 || at + length > text.size()) return false;
    for (std::size_t i = 1; i < length; ++i)
      if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80) return false;
    at += length;
  }
  return true;
}

}  // namespace

std::string filled(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '@' ? text.find('@', at + 1) : text.npos;
    const auto value = end == text.npos ? values.end() : values.find(text.substr(at + 1, end - at - 1));
    if (value == values.end()) {
      result += text[at++];
    } else {
      result += value->second;
      at = end + 1;
    }
  }
  return result;
}

std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
  return word + "'";
}

std::string shellWords(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + shellWord(word);
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

void checkPlain(const std::string& text, const std::string& what) {
  if (text.empty()) throw std::invalid_argument(what + " is empty");
  if (std::ranges::any_of(text, isControl))
    throw std::invalid_argument(what + ": '" + text + "' has control characters, such as a new line");
  if (!isUtf8(text)) throw std::invalid_argument(what + ": '" + text + "' is not UTF-8");
}

std::filesystem::path folderOf(const DataSet& set) {
  return (set.folder() / "").parent_path();
}

std::string plainName(const DataSet& set) {
  std::string name = set.plan().name();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') c = '-';
  return name;
}

std::size_t shardDigits(const DataSet& set) {
  return set.shardName(0).size();
}

}  // namespace saccade::farm
