#include "eval/bench/compared_methods.h"

#include "base/names.h"
#include "methods/method.h"

namespace saccade::eval {

std::vector<std::string> comparedMethods() {
  std::vector<std::string> methods;
  for (const MethodInfo& method : methodTable()) {
    methods.push_back(method.name);
    if (method.name == "svgf") methods.emplace_back("svgf:as_falcor=1");
  }
  return methods;
}

std::vector<std::string> luminanceSweep(const std::vector<std::string>& values) {
  std::vector<std::string> methods;
  for (const MethodInfo& method : methodTable()) {
    if (!findRow(method.params, "sigma_l")) continue;
    const bool two = findRow(method.params, "sigma_l_diff");
    for (const std::string& value : values)
      methods.push_back(method.name + ":sigma_l=" + value + (two ? ":sigma_l_diff=" + value : ""));
  }
  return methods;
}

}  // namespace saccade::eval
