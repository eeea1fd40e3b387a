#include <cmath>

#include "base/names.h"
#include "base/range.h"
#include "base/text_cut.h"
#include "methods/a_svgf.h"
#include "methods/adaptive_denoising.h"
#include "methods/adaptive_sampling.h"
#include "methods/event_svgf.h"
#include "methods/irradiance_cache.h"
#include "methods/optional_method.h"
#include "methods/path_traced.h"
#include "methods/relax.h"
#include "methods/svgf.h"

namespace saccade {
namespace {

const std::vector<OptionalMethod>& optionalMethods() {
  static const std::vector<OptionalMethod> methods{oidnMethod(), learnedMethod()};
  return methods;
}

std::vector<MethodInfo> makeTable() {
  std::vector<MethodInfo> table{
      IrradianceCache::info(),  // the default
      EventSvgf::info(),
      Relax::info(),
      Svgf::info(),
      ASvgf::info(),
      AdaptiveDenoising::info(),
      AdaptiveSampling::info(),
      PathTraced::correlatedInfo(),
      PathTraced::independentInfo(),
  };
  for (const OptionalMethod& method : optionalMethods())
    if (method.absent.empty()) table.push_back(method.info);
  return table;
}

}  // namespace

const std::vector<MethodInfo>& methodTable() {
  static const std::vector<MethodInfo> table = makeTable();
  return table;
}

// A lamp that fades is new in every frame, so that no light is known.
const MethodInfo& defaultMethod(bool steady_light) {
  return steady_light ? methodTable().front() : *findMethod("event_svgf");
}

const MethodInfo* findMethod(const std::string& name) {
  return findRow(methodTable(), name);
}

std::string methodNames() {
  return joinRowNames(methodTable());
}

std::string noMethod(const std::string& name) {
  for (const OptionalMethod& method : optionalMethods())
    if (method.info.name == name) return "there is no method '" + name + "' here: " + method.absent;
  return "there is no method '" + cutText(name, 64) + "'; there are: " + methodNames();
}

namespace {

std::string unknownParam(const MethodInfo& method, const std::string& name) {
  for (const ParamSpec& spec : method.params) {
    if (!name.empty() && spec.former == name)
      return "the parameter \"" + name + "\" is named \"" + spec.name + "\" now";
  }
  return method.name + " has no parameter \"" + cutText(name, 64) +
         "\"; it has: " + joinRowNames(method.params);
}

}  // namespace

std::string resolveParams(const MethodInfo& method, const ParamValues& given, ParamValues& resolved,
                          std::string& bad_name) {
  resolved.clear();
  for (const ParamSpec& spec : method.params) resolved[spec.name] = spec.fallback;
  for (const auto& [name, value] : given) {
    bad_name = name;
    if (!resolved.contains(name)) return unknownParam(method, name);
    resolved[name] = value;
  }
  for (const ParamSpec& spec : method.params) {
    bad_name = spec.name;
    const double value = resolved[spec.name];
    if (std::string fault = rangeFault(value, spec.min, spec.max); !fault.empty()) return fault;
    if (spec.whole && value != std::round(value)) return "must be a whole number";
  }
  bad_name.clear();
  return {};
}

bool takesSpp(const MethodInfo& method, const ParamValues& resolved, int spp) {
  const SeedPlan plan = method.seeds(resolved)(0, 1, spp);
  return plan.spp1 + plan.spp2 == spp;
}

}  // namespace saccade
