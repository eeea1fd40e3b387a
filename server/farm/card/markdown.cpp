#include "farm/card/markdown.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace saccade::farm {
namespace {

constexpr std::array<const char*, 9> kBars{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr double kCounted = 1e4, kMostCounted = 1e15;  // numbers that are shown without a fraction
constexpr std::string_view kMarks = "\\`*_{}[]<>()#+!|~&$";

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

std::string rowOf(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

}  // namespace

std::string codeOf(const std::string& text) {
  std::string code;
  for (const char c : text) code += c == '|' ? std::string("\\|") : std::string(1, isControl(c) ? ' ' : c);
  std::ranges::replace(code, '`', '\'');
  return code.empty() ? "" : "`" + code + "`";
}

std::string plainOf(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (kMarks.find(c) != kMarks.npos) plain += '\\';
    plain += isControl(c) ? ' ' : c;
  }
  return plain;
}

std::string tableOf(const std::vector<std::string>& heads,
                    const std::vector<std::vector<std::string>>& rows) {
  std::string table = rowOf(heads) + rowOf(std::vector<std::string>(heads.size(), "---"));
  for (const std::vector<std::string>& row : rows) table += rowOf(row);
  return table + "\n";
}

std::string shortText(double number) {
  if (number >= kCounted && number < kMostCounted) return countText(static_cast<std::uint64_t>(number + 0.5));
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

std::string countText(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string barsOf(const Numbers::Summary& summary) {
  const std::uint64_t most = std::max<std::uint64_t>(1, std::ranges::max(summary.bins));
  std::string bars;
  for (const std::uint64_t bin : summary.bins) bars += kBars[(bin * (kBars.size() - 1) + most - 1) / most];
  return bars;
}

}  // namespace saccade::farm
