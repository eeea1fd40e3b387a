#include "farm/card/option_tables.h"

#include <algorithm>
#include <numeric>

#include "farm/card/markdown.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kMostValues = 16;  // of a list that are shown

using Rows = std::vector<std::vector<std::string>>;

std::string describe(const Value& value) {
  if (!value.present) return "not given";
  if (value.texts.empty()) return "given";
  std::string text;
  for (const std::string& one : value.texts) text += (text.empty() ? "" : " and ") + codeOf(one);
  return text;
}

std::string listOf(const Draw& draw) {
  const double sum = std::accumulate(draw.weights.begin(), draw.weights.end(), 0.0);
  std::string text;
  for (std::size_t i = 0; i < std::min(draw.values.size(), kMostValues); ++i) {
    text += (i == 0 ? "" : ", ") + describe(draw.values[i]);
    if (draw.kind == Draw::Kind::kChoice && sum > 0)
      text += " (" + shortText(100 * draw.weights[i] / sum) + " %)";
  }
  const std::size_t more = draw.values.size() - std::min(draw.values.size(), kMostValues);
  return more > 0 ? text + " and " + std::to_string(more) + " more" : text;
}

std::string rangeOf(const Draw& draw) {
  return "in \\[" + numberText(draw.low) + ", " + numberText(draw.high) + "\\]";
}

bool isIn(const Entry& entry, const std::vector<Entry>& options) {
  return std::ranges::any_of(options, [&](const Entry& other) {
    return other.name == entry.name && describe(other.draw) == describe(entry.draw);
  });
}

Rows rowsOf(const std::vector<Entry>& options) {
  Rows rows;
  for (const Entry& entry : options) rows.push_back({codeOf(shownName(entry.name)), describe(entry.draw)});
  return rows;
}

std::string countsOf(const std::map<std::string, std::uint64_t>& counts) {
  std::vector<std::pair<std::string, std::uint64_t>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(sorted.size(), kMostValues); ++i)
    text += (i == 0 ? "" : ", ") + (sorted[i].first.empty() ? "without it" : codeOf(sorted[i].first)) + ": " +
            countText(sorted[i].second);
  return sorted.size() > kMostValues ? text + ", …" : text;
}

}  // namespace

std::string describe(const Draw& draw) {
  switch (draw.kind) {
    case Draw::Kind::kFixed:
      return describe(draw.values.front());
    case Draw::Kind::kEach:
      return "in turn: " + listOf(draw);
    case Draw::Kind::kChoice:
      return "one of: " + listOf(draw);
    case Draw::Kind::kUniform:
      return "uniform " + rangeOf(draw);
    case Draw::Kind::kInteger:
      return "whole number " + rangeOf(draw);
    case Draw::Kind::kLogUniform:
      return "log-uniform " + rangeOf(draw);
    case Draw::Kind::kNormal:
      return "normal, mean " + numberText(draw.mean) + ", deviation " + numberText(draw.deviation) + ", " +
             rangeOf(draw);
  }
  return "";
}

std::string optionTables(const Recipe& recipe) {
  std::vector<Entry> common;
  for (const Entry& entry : recipe.cases.front())
    if (std::ranges::all_of(recipe.cases, [&](const auto& options) { return isIn(entry, options); }))
      common.push_back(entry);
  std::string text;
  Rows draws;
  for (const Entry& entry : recipe.draws) draws.push_back({codeOf(entry.name), describe(entry.draw)});
  if (!draws.empty()) text += tableOf({"drawn value", "how"}, draws);
  text += tableOf({"option of `saccade record`", "value"}, rowsOf(common));
  for (std::size_t i = 0; recipe.cases.size() > 1 && i < std::min(recipe.cases.size(), kMostValues); ++i) {
    std::vector<Entry> own = recipe.cases[i];
    std::erase_if(own, [&](const Entry& entry) { return isIn(entry, common); });
    text += tableOf({"case " + std::to_string(i + 1) + " of " + std::to_string(recipe.cases.size()), "value"},
                    rowsOf(own));
  }
  return text;
}

std::string drawnTables(const Statistics& found) {
  Rows numbers, texts;
  const auto measure = [&](const std::string& name, const Numbers& values) {
    if (values.empty()) return;
    const Numbers::Summary all = values.summary();
    numbers.push_back(
        {name, shortText(all.min), shortText(all.median), shortText(all.max), codeOf(barsOf(all))});
  };
  measure("events of a sequence", found.events);
  measure("events per second and pixel", found.rate);
  measure("duration, seconds", found.duration_s);
  measure("bytes of a sequence", found.bytes);
  for (const auto& [name, values] : found.numbers) measure(codeOf(name), values);
  for (const auto& [name, counts] : found.texts) texts.push_back({codeOf(name), countsOf(counts)});
  std::string text =
      numbers.empty() ? "" : tableOf({"", "least", "median", "greatest", "histogram"}, numbers);
  return texts.empty() ? text : text + tableOf({"value", "sequences that have it"}, texts);
}

}  // namespace saccade::farm
