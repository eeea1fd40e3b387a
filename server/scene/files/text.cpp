#include "scene/files/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace saccade {
namespace {

bool parts(char c, std::string_view also) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || also.find(c) != also.npos;
}

template <class T>
std::optional<T> parseAs(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);  // from_chars knows no plus
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

}  // namespace

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view takeWord(std::string_view& text, std::string_view also) {
  std::size_t begin = 0;
  while (begin < text.size() && parts(text[begin], also)) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !parts(text[end], also)) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::optional<double> parseNumber(std::string_view word) {
  const auto value = parseAs<double>(word);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parseInteger(std::string_view word) {
  return parseAs<long long>(word);
}

}  // namespace saccade
