#include <gtest/gtest.h>

#include <algorithm>

#include "base/hash_rng.h"
#include "fuzz/fuzz_target.h"
#include "scene/scene_error.h"

namespace saccade {
namespace {

constexpr std::uint64_t kMutants = 50000;

// Numbers of one mutant, by address.
class Draws {
 public:
  explicit Draws(std::uint64_t mutant) : mutant_(mutant) {}
  std::size_t below(std::size_t count) { return count == 0 ? 0 : hashKey(mutant_, next_++) % count; }

 private:
  std::uint64_t mutant_, next_ = 0;
};

void mutateOnce(std::string& bytes, const FuzzTarget& target, Draws& draw) {
  const std::size_t at = draw.below(bytes.size() + 1), length = draw.below(bytes.size() - at + 1);
  const std::string& token = target.tokens[draw.below(target.tokens.size())];
  const std::string& other = target.seeds[draw.below(target.seeds.size())];
  switch (draw.below(7)) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(draw.below(256));
      break;
    case 1:
      bytes.insert(at, token);
      break;
    case 2:  // a word for a word
      bytes.replace(at, std::min(bytes.find_first_of(" \n\"'/", at), bytes.size()) - at, token);
      break;
    case 3:
      bytes.erase(at, std::min<std::size_t>(length, 1 + draw.below(16)));
      break;
    case 4:
      bytes.resize(at);
      break;
    case 5:
      bytes.insert(at, bytes.substr(at, length));
      break;
    default:
      bytes = bytes.substr(0, at) + other.substr(draw.below(other.size()));
  }
}

std::string mutantOf(const FuzzTarget& target, std::uint64_t mutant) {
  Draws draw(mutant);
  std::string bytes = target.seeds[draw.below(target.seeds.size())];
  for (std::size_t steps = 1 + draw.below(4); steps > 0; --steps) mutateOnce(bytes, target, draw);
  return bytes;
}

TEST(Fuzz, SeedsAreWellFormed) {
  for (const std::string& seed : fuzzTarget().seeds) EXPECT_NO_THROW(fuzzTarget().read(seed)) << seed;
}

TEST(Fuzz, MutantsAreReadOrRefused) {
  int refused = 0;
  for (std::uint64_t mutant = 0; mutant < kMutants; ++mutant) {
    const std::string bytes = mutantOf(fuzzTarget(), mutant);
    try {
      fuzzTarget().read(bytes);
    } catch (const SceneError& e) {
      ++refused;
      EXPECT_NE(std::string(e.what()), "");
    } catch (const std::exception& e) {
      ADD_FAILURE() << "mutant " << mutant << ": " << e.what() << "\n" << bytes;
    }
  }
  EXPECT_GT(refused, static_cast<int>(kMutants) / 4);
  EXPECT_LT(refused, static_cast<int>(kMutants));
}

}  // namespace
}  // namespace saccade
