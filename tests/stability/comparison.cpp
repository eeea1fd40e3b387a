#include "stability/comparison.h"

#include <algorithm>

#include "base/check.h"

namespace saccade::test {

const Claim* claimOf(const StabilityCase& c, const std::string& method) {
  const auto claim = std::find_if(c.claims.begin(), c.claims.end(),
                                  [&](const Claim& some) { return some.method == method; });
  return claim == c.claims.end() ? nullptr : &*claim;
}

const Figures& figuresOf(const std::string& method, const MethodFigures& figures) {
  const auto its =
      std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.first == method; });
  SACCADE_CHECK(its != figures.end());
  return its->second;
}

std::vector<std::string> betterThan(const std::string& method, const StabilityCase& c,
                                    const MethodFigures& figures) {
  const double its = figuresOf(method, figures).*c.judged;
  std::vector<std::string> better;
  for (const auto& [name, f] : figures)
    if (f.*c.judged < kClearly * its) better.push_back(name);
  return better;
}

}  // namespace saccade::test
