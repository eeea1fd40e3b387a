// Compares methods in a case of the stability suite.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stability/cases.h"

namespace saccade::test {

using MethodFigures = std::vector<std::pair<std::string, Figures>>;  // by method

// The claim of the case for a method; nullptr: none.
const Claim* claimOf(const StabilityCase& c, const std::string& method);

const Figures& figuresOf(const std::string& method, const MethodFigures& figures);  // it is one of them

// The methods whose judged figure is below kClearly times that of `method`.
inline constexpr double kClearly = 0.9;
std::vector<std::string> betterThan(const std::string& method, const StabilityCase& c,
                                    const MethodFigures& figures);

}  // namespace saccade::test
