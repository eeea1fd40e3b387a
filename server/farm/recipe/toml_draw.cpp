#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/names.h"
#include "farm/recipe/toml_value.h"

namespace saccade::farm {
namespace {

const toml::array& listOf(const toml::node& node, const TomlPlace& place) {
  const toml::array* list = node.as_array();
  if (!list || list->empty()) place.fail("give an array of at least one value");
  return *list;
}

void readPair(const toml::node& node, const TomlPlace& place, const char* what, double& first,
              double& second) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 2) place.fail(std::string("give ") + what);
  first = numberOf(*list->get(0), place), second = numberOf(*list->get(1), place);
}

void readBounds(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readPair(node, place, "[least, greatest]", draw.low, draw.high);
  if (draw.low > draw.high) place.fail("the first number is the least, and is greater than the second");
}

void readValues(const toml::node& node, const TomlPlace& place, Draw& draw) {
  for (const toml::node& element : listOf(node, place)) draw.values.push_back(valueOf(element, place));
  draw.weights.assign(draw.values.size(), 1);
}

void readUniform(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readBounds(node, place, draw);
}

void readInteger(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readBounds(node, place, draw);
  if (draw.low != std::trunc(draw.low) || draw.high != std::trunc(draw.high) ||
      std::max(-draw.low, draw.high) > 1e15)
    place.fail("the bounds are not whole numbers within 1e15");
}

void readLogUniform(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readBounds(node, place, draw);
  if (draw.low <= 0) place.fail("the bounds of a log_uniform are above 0");
}

void readNormal(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readPair(node, place, "[mean, deviation]", draw.mean, draw.deviation);
  if (draw.deviation <= 0) place.fail("the deviation is not above 0");
}

struct DrawRow {
  Draw::Kind kind;
  void (*read)(const toml::node&, const TomlPlace&, Draw&);
  const char* with = nullptr;  // a second key that it may have
};

// THE list of draws.
const std::map<std::string, DrawRow>& drawTable() {
  static const std::map<std::string, DrawRow> table{
      {"each", {Draw::Kind::kEach, readValues}},
      {"choice", {Draw::Kind::kChoice, readValues, "weights"}},
      {"uniform", {Draw::Kind::kUniform, readUniform}},
      {"integer", {Draw::Kind::kInteger, readInteger}},
      {"log_uniform", {Draw::Kind::kLogUniform, readLogUniform}},
      {"normal", {Draw::Kind::kNormal, readNormal, "bounds"}},
  };
  return table;
}

std::string drawNames() {
  std::vector<std::string> names;
  for (const auto& row : drawTable()) names.push_back(row.first);
  return joinNames(names);
}

void readWeights(const toml::node& node, const TomlPlace& place, Draw& draw) {
  draw.weights.clear();
  double sum = 0;
  for (const toml::node& element : listOf(node, place)) {
    draw.weights.push_back(numberOf(element, place));
    if (draw.weights.back() < 0) place.fail("a weight is below 0");
    sum += draw.weights.back();
  }
  if (draw.weights.size() != draw.values.size())
    place.fail("there are " + std::to_string(draw.weights.size()) + " weights for " +
               std::to_string(draw.values.size()) + " values");
  if (!(sum > 0)) place.fail("all weights are 0");
}

// The share of a normal distribution that lies within the bounds.
double shareWithin(const Draw& draw) {
  const auto below = [&](double x) {
    return std::erfc((draw.mean - x) / (draw.deviation * std::numbers::sqrt2)) / 2;
  };
  return below(draw.high) - below(draw.low);
}

void readNormalBounds(const toml::node& node, const TomlPlace& place, Draw& draw) {
  readBounds(node, place, draw);
  if (shareWithin(draw) < 0.01) place.fail("less than a hundredth of the distribution is within the bounds");
}

}  // namespace

Draw drawOf(const toml::node& node, const TomlPlace& place) {
  const toml::table* table = node.as_table();
  if (!table) return {Draw::Kind::kFixed, {valueOf(node, place)}};
  Draw draw;
  const DrawRow* row = nullptr;
  for (const auto& [key, value] : *table) {
    const auto found = drawTable().find(std::string(key));
    if (found == drawTable().end()) continue;
    if (row) place.fail("gives two draws; there are: " + drawNames());
    row = &found->second;
    draw.kind = row->kind;
    row->read(value, place, draw);
  }
  if (!row) place.fail("is a table without a draw; there are: " + drawNames());
  const std::string with = row->with ? row->with : "";
  const toml::node* second = with.empty() ? nullptr : table->get(with);
  if (table->size() != (second ? 2u : 1u))
    place.fail("has a key that the draw does not take" + (with.empty() ? "" : "; it may have " + with));
  if (with == "bounds" && !second) place.fail("give bounds = [least, greatest] too");
  if (second) (with == "bounds" ? readNormalBounds : readWeights)(*second, place, draw);
  return draw;
}

}  // namespace saccade::farm
