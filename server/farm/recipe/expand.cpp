#include "farm/recipe/expand.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/content_hash.h"
#include "farm/recipe/permutation.h"

namespace saccade::farm {
namespace {

using Values = std::map<std::string, Value>;

std::uint64_t addressOf(std::uint64_t key, const std::string& name) {
  ContentHash hash{key};
  hash.bytes(name.data(), name.size());
  return hashKey(hash.value, name.size());
}

// Draws each entry. `turn` goes through all combinations of lists, those of the first entry fastest.
void drawAll(const std::vector<Entry>& entries, std::uint64_t key, std::uint64_t& turn, Values& values) {
  for (const Entry& entry : entries) {
    values[entry.name] = valueAt(entry.draw, addressOf(key, entry.name), turn);
    if (entry.draw.kind == Draw::Kind::kEach) turn /= entry.draw.values.size();
  }
}

// The text with the values of {names}.
std::string filled(const std::string& text, const Values& draws) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t end = text[at] == '{' ? text.find('}', at) : text.npos;
    const auto draw = end == text.npos ? draws.end() : draws.find(text.substr(at + 1, end - at - 1));
    if (draw == draws.end()) {
      result += text[at];
    } else {
      result += draw->second.texts.front();
      at = end;
    }
  }
  return result;
}

void addWords(const std::string& name, const Value& value, const Values& draws,
              v1::DataSetSequence& sequence) {
  if (!value.present) return;
  if (value.texts.empty()) sequence.add_options("--" + name);
  for (const std::string& text : value.texts) {
    const std::string word = filled(text, draws);
    sequence.add_options(name == "scene" ? word : "--" + name + "=" + word);
  }
}

// A motion KIND:SPEED that has a seed has one of its own in each sequence.
bool isMotion(const Values& options) {
  for (const char* name : {"motion", "trajectory"}) {
    const auto at = options.find(name);
    if (at != options.end() && !at->second.texts.empty())
      return at->second.texts.front().find(':') != std::string::npos;
  }
  return false;
}

void addSeeds(std::uint64_t key, Values& options) {
  const auto seed = [&](const std::string& name) {
    return Value{true, {std::to_string(addressOf(key, name))}};
  };
  options.try_emplace("seed", seed("seed"));
  if (isMotion(options)) options.try_emplace("motion-seed", seed("motion-seed"));
}

void fill(Values options, const Values& draws, std::uint64_t key, v1::DataSetSequence& sequence) {
  addSeeds(key, options);
  if (const auto scene = options.extract("scene")) addWords("scene", scene.mapped(), draws, sequence);
  for (const auto& [name, value] : options) addWords(name, value, draws, sequence);
  for (const auto& [name, value] : draws) (*sequence.mutable_draws())[name] = value.texts.front();
}

std::string splitOf(const Recipe& recipe, std::uint64_t number) {
  const std::uint64_t place = shuffled(number, recipe.sequences, hashKey(recipe.seed, 1));
  const std::vector<std::uint64_t> sizes = splitSizes(recipe);
  std::uint64_t end = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (place < (end += sizes[i])) return recipe.splits[i].first;
  return recipe.splits.back().first;
}

// Takes the n-th of all combinations of what `entries` can be at their edges, and counts them in `n`. Numbers
// are all at their low end, or all at their high end.
void takeEdges(const std::vector<Entry>& entries, bool high, std::uint64_t& n, Values& values) {
  for (const Entry& entry : entries) {
    const std::vector<Value> edges = extremes(entry.draw);
    const bool listed = !entry.draw.values.empty();
    values[entry.name] = listed ? edges[n % edges.size()] : edges[high ? 1 : 0];
    if (listed) n /= edges.size();
  }
}

// Adds the combinations with the least numbers, or with the greatest.
void addEdges(const Recipe& recipe, std::size_t of_case, bool high, std::size_t most,
              std::vector<Probe>& all) {
  for (std::uint64_t n = 0; n < most; ++n) {
    std::uint64_t left = n;
    Values draws, options;
    takeEdges(recipe.draws, high, left, draws);
    takeEdges(recipe.cases[of_case], high, left, options);
    if (left > 0) return;  // that was all of them
    fill(std::move(options), draws, n, all.emplace_back(Probe{of_case, {}}).sequence);
  }
}

bool hasNumbers(const std::vector<Entry>& entries) {
  return std::ranges::any_of(entries, [](const Entry& entry) { return entry.draw.values.empty(); });
}

}  // namespace

std::uint32_t shardOf(std::uint64_t number, std::uint64_t sequences, std::uint32_t shards) {
  return static_cast<std::uint32_t>(number * shards / sequences);
}

std::uint64_t firstOf(std::uint32_t shard, std::uint64_t sequences, std::uint32_t shards) {
  return (shard * sequences + shards - 1) / shards;
}

std::vector<std::uint64_t> splitSizes(const Recipe& recipe) {
  std::vector<std::uint64_t> sizes;
  double share = 0;
  std::uint64_t before = 0;
  for (const auto& split : recipe.splits) {
    share += split.second;
    const auto end = static_cast<std::uint64_t>(std::llround(share * static_cast<double>(recipe.sequences)));
    sizes.push_back(std::min(end, recipe.sequences) - before);
    before += sizes.back();
  }
  sizes.back() += recipe.sequences - before;  // where the shares add up to less than 1 by rounding
  return sizes;
}

v1::DataSetSequence sequenceOf(const Recipe& recipe, std::uint64_t number) {
  const std::uint64_t key = hashKey(hashKey(recipe.seed, 2), number);
  std::uint64_t turn = number / recipe.cases.size();
  v1::DataSetSequence sequence;
  sequence.set_number(number);
  sequence.set_shard(shardOf(number, recipe.sequences, recipe.shards));
  sequence.set_split(splitOf(recipe, number));
  Values draws, options;
  drawAll(recipe.draws, hashKey(key, 1), turn, draws);
  drawAll(recipe.cases[number % recipe.cases.size()], hashKey(key, 2), turn, options);
  fill(std::move(options), draws, key, sequence);
  return sequence;
}

std::vector<Probe> edgeProbes(const Recipe& recipe, std::size_t most) {
  std::vector<Probe> all;
  for (std::size_t i = 0; i < recipe.cases.size(); ++i) {
    const int ends = hasNumbers(recipe.draws) || hasNumbers(recipe.cases[i]) ? 2 : 1;
    for (int high = 0; high < ends; ++high) addEdges(recipe, i, high != 0, most / ends, all);
  }
  return all;
}

}  // namespace saccade::farm
