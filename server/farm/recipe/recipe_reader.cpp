#include "farm/recipe/recipe_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "base/names.h"
#include "farm/recipe/recipe_fault.h"
#include "farm/recipe/toml_value.h"

namespace saccade::farm {
namespace {

constexpr std::size_t kMostNameLetters = 64;
constexpr std::size_t kMostEntries = 1000;

const toml::node& required(const toml::table& table, const char* key, const TomlPlace& place) {
  if (const toml::node* node = table.get(key)) return *node;
  place.fail(std::string("there is no ") + key);
}

void checkKeys(const toml::table& table, const std::set<std::string>& valid, const TomlPlace& place) {
  for (const auto& [key, node] : table)
    if (!valid.contains(std::string(key)))
      place.below(std::string(key), node).fail("unknown key; there are: " + joinNames(valid));
}

// Names stand in the names of files and folders.
std::string nameOf(const std::string& text, const TomlPlace& place) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
  };
  if (!text.empty() && text.size() <= kMostNameLetters && std::ranges::all_of(text, plain) && text[0] != '-')
    return text;
  place.fail("'" + text.substr(0, kMostNameLetters) + "' is not a name of 1 to 64 letters, digits, - and _");
}

void readSplits(const toml::table& root, const TomlPlace& place, Recipe& recipe) {
  const toml::node* node = root.get("splits");
  if (!node) return recipe.splits.emplace_back("all", 1.0), void();
  const TomlPlace at = place.below("splits", *node);
  const toml::table* table = node->as_table();
  if (!table || table->empty()) at.fail("give a table of shares, such as { train = 0.9, test = 0.1 }");
  double sum = 0;
  for (const auto& [key, share] : inOrder(*table)) {
    const TomlPlace below = at.below(key, *share);
    recipe.splits.emplace_back(nameOf(key, below), numberOf(*share, below));
    if (recipe.splits.back().second < 0) below.fail("a share is below 0");
    sum += recipe.splits.back().second;
  }
  if (std::abs(sum - 1) > 1e-6) at.fail("the shares add up to " + numberText(sum) + " instead of 1");
}

const toml::table& tableOf(const toml::node& node, const TomlPlace& place) {
  const toml::table* table = node.as_table();
  if (!table) place.fail("is not a table");
  if (table->size() > kMostEntries) place.fail("has more than " + std::to_string(kMostEntries) + " keys");
  return *table;
}

std::vector<Entry> entriesOf(const toml::node& node, const TomlPlace& place) {
  std::vector<Entry> entries;
  for (const auto& [key, value] : inOrder(tableOf(node, place))) {
    const TomlPlace at = place.below(key, *value);
    entries.push_back({key, drawOf(*value, at), at.line});
  }
  return entries;
}

void readDraws(const toml::table& root, const TomlPlace& place, Recipe& recipe) {
  const toml::node* node = root.get("draw");
  if (!node) return;
  recipe.draws = entriesOf(*node, place.below("draw", *node));
  for (const Entry& entry : recipe.draws) {
    const TomlPlace at{place.file, "draw." + entry.name, entry.line};
    nameOf(entry.name, at);
    for (const Value& value : entry.draw.values)
      if (value.texts.size() != 1) at.fail("its values are not single texts or numbers");
  }
}

// `options`, with those of `more` instead of or after them.
std::vector<Entry> merged(std::vector<Entry> options, const std::vector<Entry>& more) {
  for (const Entry& entry : more) {
    const auto same = std::ranges::find(options, entry.name, &Entry::name);
    same == options.end() ? options.push_back(entry) : void(*same = entry);
  }
  return options;
}

void readCases(const toml::table& root, const TomlPlace& place, const std::vector<Entry>& record,
               Recipe& recipe) {
  const toml::node* node = root.get("case");
  if (!node) return recipe.cases.push_back(record), void();
  const TomlPlace at = place.below("case", *node);
  const toml::array* list = node->as_array();
  if (!list || list->empty() || list->size() > kMostEntries) at.fail("write cases as [[case]], up to 1000");
  for (const toml::node& one : *list)
    recipe.cases.push_back(merged(record, entriesOf(one, {at.file, "case", lineOf(one)})));
}

void readOutputs(std::vector<Entry>& record, const TomlPlace& place, Recipe& recipe) {
  const auto output = std::ranges::find(record, "output", &Entry::name);
  if (output == record.end()) place.fail("there is no output, such as output = \"events.h5\"");
  const TomlPlace at{place.file, "record.output", output->line};
  if (output->draw.kind != Draw::Kind::kFixed || output->draw.values[0].texts.empty())
    at.fail("give a name of a file, or an array of such names");
  recipe.outputs = output->draw.values[0].texts;
  recipe.output_line = output->line;
  for (const std::string& name : recipe.outputs) {
    const std::filesystem::path path(name);
    nameOf(path.stem(), at);
    nameOf(path.has_extension() ? path.extension().string().substr(1) : "", at);
    if (path.has_parent_path()) at.fail("'" + name + "' has a folder; each sequence has a folder of its own");
    if (std::ranges::count(recipe.outputs, name) > 1) at.fail("'" + name + "' is given twice");
  }
  record.erase(output);
}

// {name} in a text of an option stands for a value of [draw].
void checkEntry(const Entry& entry, const Recipe& recipe) {
  const TomlPlace at{recipe.file, "record." + entry.name, entry.line};
  if (entry.name == "output") at.fail("stands in [record] alone, as all sequences have the same files");
  for (const Value& value : entry.draw.values) {
    for (const std::string& text : value.texts) {
      for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{', open + 1)) {
        const std::size_t close = text.find('}', open);
        const std::string name = close == text.npos ? "" : text.substr(open + 1, close - open - 1);
        const auto isName = [&](const Entry& draw) { return draw.name == name; };
        std::vector<std::string> names;
        for (const Entry& draw : recipe.draws) names.push_back(draw.name);
        if (std::ranges::none_of(recipe.draws, isName))
          at.fail("'" + text + "' names no value of [draw]; there are: " + joinNames(names));
      }
    }
  }
}

Recipe readTable(const toml::table& root, const TomlPlace& place) {
  checkKeys(root, {"name", "seed", "sequences", "shards", "splits", "draw", "record", "case"}, place);
  Recipe recipe{.file = place.file, .name = {}};
  const auto below = [&](const char* key) { return place.below(key, required(root, key, place)); };
  recipe.name = nameOf(textOf(required(root, "name", place), below("name")), below("name"));
  recipe.sequences = wholeOf(required(root, "sequences", place), 1, kMostSequences, below("sequences"));
  const std::uint64_t most_shards = std::min<std::uint64_t>(recipe.sequences, kMostShards);
  if (const toml::node* shards = root.get("shards"))
    recipe.shards =
        static_cast<std::uint32_t>(wholeOf(*shards, 1, most_shards, place.below("shards", *shards)));
  if (const toml::node* seed = root.get("seed"))
    recipe.seed = wholeOf(*seed, 0, std::numeric_limits<std::int64_t>::max(), place.below("seed", *seed));
  readSplits(root, place, recipe);
  readDraws(root, place, recipe);
  const TomlPlace at = below("record");
  std::vector<Entry> record = entriesOf(required(root, "record", place), at);
  readOutputs(record, at, recipe);
  readCases(root, place, record, recipe);
  for (const auto& options : recipe.cases)
    for (const Entry& entry : options) checkEntry(entry, recipe);
  return recipe;
}

}  // namespace

Recipe readRecipe(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  if (!input || !std::filesystem::is_regular_file(file))
    throw std::runtime_error(file + ": there is no such file");
  return parseRecipe({std::istreambuf_iterator<char>(input), {}}, file);
}

Recipe parseRecipe(const std::string& text, const std::string& file) {
  try {
    return readTable(toml::parse(text), {file, "", 1});
  } catch (const toml::parse_error& fault) {
    throw RecipeFault(file, static_cast<int>(fault.source().begin.line), std::string(fault.description()));
  }
}

}  // namespace saccade::farm
