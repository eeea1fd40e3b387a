// Maps the names of parameters to the members of a method's Params. Their initialisers are the defaults.
#pragma once

#include <variant>
#include <vector>

#include "methods/method.h"

namespace saccade {

template <class Params>
struct ParamField {
  const char* name;
  std::variant<float Params::*, int Params::*, bool Params::*> member;
  double min, max;
  const char *what, *source;
  const char* former = "";  // the name that it had in an earlier version
};

// The switch of methods that trace paths as the paper does.
template <class Params, class Member>
ParamField<Params> independentNumbersField(Member member) {
  return {"independent_numbers",
          member,
          0,
          1,
          "1: random numbers of paths know nothing of each other; 0: they fill space evenly",
          "[ours] less noise; paper: 1"};
}

// The passes of kPlan, a maker of SeedPlan, with the numbers that this switch asks for.
template <SeedPlan (*kPlan)(std::uint64_t, FrameIndex, int)>
SeedPlanner seedsWith(bool independent_numbers) {
  return independent_numbers ? SeedPlan::byChance<kPlan> : kPlan;
}

template <class Params>
std::vector<ParamSpec> paramSpecs(const std::vector<ParamField<Params>>& fields) {
  std::vector<ParamSpec> specs;
  static const Params defaults{};
  for (const auto& f : fields) {
    const bool whole = !std::holds_alternative<float Params::*>(f.member);
    const double fallback = std::visit([&](auto m) { return static_cast<double>(defaults.*m); }, f.member);
    specs.push_back({f.name, f.min, f.max, fallback, whole, f.what, f.source, f.former});
  }
  return specs;
}

// `values` are from resolveParams().
template <class Params>
Params makeParams(const std::vector<ParamField<Params>>& fields, const ParamValues& values) {
  Params params;
  for (const auto& f : fields) {
    const double value = values.at(f.name);
    std::visit([&](auto m) { params.*m = static_cast<std::remove_reference_t<decltype(params.*m)>>(value); },
               f.member);
  }
  return params;
}

}  // namespace saccade
