#include "methods/method_spec.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "methods/optional_method.h"

namespace saccade {

bool MethodSpec::takes(int spp) const {
  return takesSpp(*findMethod(name), params, spp);
}

MethodSpec parseMethod(const std::string& name, const std::vector<std::string>& settings) {
  const MethodInfo* method = findMethod(name);
  if (!method) throw std::runtime_error(noMethod(name));
  MethodSpec spec{name, name, {}};
  ParamValues given;
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    char* end = nullptr;
    const double value = equals == std::string::npos ? 0 : std::strtod(setting.c_str() + equals + 1, &end);
    if (!end || *end != 0 || end == setting.c_str() + equals + 1) {
      throw std::runtime_error("a setting is name=number, not \"" + setting + "\"");
    }
    given[setting.substr(0, equals)] = value;
    spec.text += ":" + setting;
  }
  std::string bad;
  const std::string fault = resolveParams(*method, given, spec.params, bad);
  if (!fault.empty()) throw std::runtime_error(bad + ": " + fault);
  return spec;
}

MethodSpec parseMethod(const std::string& text) {
  std::istringstream parts(text);
  std::string name, setting;
  std::getline(parts, name, ':');
  std::vector<std::string> settings;
  while (std::getline(parts, setting, ':')) settings.push_back(setting);
  return parseMethod(name, settings);
}

}  // namespace saccade
