// Runs every method in every case of the stability suite, and expects of them what verdict.h says.
//
// Quick by default: small pictures, references of 512 paths. SACCADE_FULL=1 takes 128x128, 4096 paths and the
// full lengths, and keeps its references in $SACCADE_CACHE (default: the cache of the programs). Both write
// stability.csv and stability.md to $SACCADE_OUT (default: the working folder).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/default_cache.h"
#include "eval/bench/compared_methods.h"
#include "stability/measure.h"
#include "stability/table.h"
#include "stability/verdict.h"

namespace saccade::test {

namespace {

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;

StabilityForm chosenForm() {
  const char* cache = std::getenv("SACCADE_CACHE");
  const std::string own = kFull ? defaultCache() : ::testing::TempDir() + "saccade-cache";
  return {.reference_spp = kFull ? 4096 : 512, .repeats = kFull ? 2 : 1, .cache = cache ? cache : own};
}

std::string settings(const StabilityForm& form) {
  return std::string(kFull ? "full" : "quick") + " form: " + std::to_string(kStabilitySpp) +
         " paths per pixel and frame, references of " + std::to_string(form.reference_spp) + ", " +
         std::to_string(form.repeats) + (form.repeats == 1 ? " seed" : " seeds");
}

StabilityTable& table() {
  static StabilityTable table(settings(chosenForm()));
  return table;
}

// Writes the table once all cases have run.
class WriteTable : public ::testing::Environment {
 public:
  void TearDown() override {
    const char* chosen = std::getenv("SACCADE_OUT");
    const std::filesystem::path folder = chosen ? chosen : std::filesystem::current_path();
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "stability.csv") << table().csv();
    std::ofstream(folder / "stability.md") << table().markdown();
    std::printf("%s\nwritten: %s, %s\n", table().markdown().c_str(), (folder / "stability.csv").c_str(),
                (folder / "stability.md").c_str());
  }
};
const auto* const kWriteTable = ::testing::AddGlobalTestEnvironment(new WriteTable);

std::vector<MethodSpec> methods() {
  std::vector<MethodSpec> specs;
  for (const std::string& text : eval::comparedMethods()) specs.push_back(parseMethod(text));
  return specs;
}

MethodFigures measureAll(const StabilityCase& c) {
  TilePool pool(2);
  const StabilityBench bench(c, chosenForm(), pool);
  MethodFigures figures;
  for (const MethodSpec& method : methods()) figures.emplace_back(method.text, bench.measure(method));
  table().add(c, figures);
  return figures;
}

class Stability : public ::testing::TestWithParam<StabilityCase> {};

TEST_P(Stability, Holds) {
  const StabilityCase& c = GetParam();
  const MethodFigures figures = measureAll(c);
  expectSound(c, figures);
  for (const Claim& claim : c.claims) expectKept(claim, c, figures);
  if (c.lap == 0) return;
  const MethodFigures before = measureAll(lapBefore(c));
  for (const Claim& claim : c.claims) expectNoWorse(claim, c, figures, before);
}

std::string testName(const ::testing::TestParamInfo<StabilityCase>& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char ch) { return ch == '.' || ch == '-'; }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Cases, Stability, ::testing::ValuesIn(stabilityCases(kFull)), testName);

}  // namespace
}  // namespace saccade::test
