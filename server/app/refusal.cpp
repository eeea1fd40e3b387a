#include "app/refusal.h"

#include <algorithm>
#include <cctype>

#include "base/range.h"
#include "scene/scene_error.h"
#include "stream/control_server.h"

namespace saccade {

v1::Status statusOfException() {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return makeStatus(refusal.code, refusal.what(), refusal.field);
  } catch (const SceneError& fault) {  // trajectories have become Refusals: this is the scene's own file
    return makeStatus(v1::CODE_UNAVAILABLE, fault.what(), "scene");
  } catch (const std::exception& fault) {
    return makeStatus(v1::CODE_INTERNAL, fault.what());
  }
}

void refuse(const std::string& field, const std::string& message) {
  throw Refusal(v1::CODE_INVALID_ARGUMENT, field, message);
}

void checkRange(const std::string& field, double value, double min, double max) {
  const std::string fault = rangeFault(value, min, max);
  if (!fault.empty()) refuse(field, fault);
}

std::string nameWithout(const std::string& prefix, const std::string& value) {
  std::string name = value.substr(prefix.size());
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

}  // namespace saccade
