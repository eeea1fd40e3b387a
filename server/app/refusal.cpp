#include "app/refusal.h"

#include <algorithm>
#include <cctype>
#include <new>

#include "base/range.h"
#include "scene/scene_error.h"
#include "stream/status.h"

namespace saccade {

LimitReached::LimitReached(Limit reached, std::string field, const std::string& message, double retry_s)
    : Refusal(v1::CODE_RESOURCE_EXHAUSTED, std::move(field),
              std::string("limit ") + rowOf(reached).name + ": " + message) {
  limit = rowOf(reached).name;
  retry_after_s = retry_s;
}

v1::Status statusOfException() {
  try {
    throw;
  } catch (const Refusal& refusal) {
    v1::Status status = makeStatus(refusal.code, refusal.what(), refusal.field);
    status.set_limit(refusal.limit);
    status.set_retry_after_s(refusal.retry_after_s);
    return status;
  } catch (const SceneError& fault) {  // trajectories have become Refusals: this is the scene's own file
    return makeStatus(v1::CODE_UNAVAILABLE, fault.what(), "scene");
  } catch (const std::bad_alloc&) {
    return noMemoryStatus();
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
