#include "app/request/refusal.h"

#include <new>

#include "base/range.h"
#include "reply/status.h"
#include "scene/files/scene_error.h"

namespace saccade {

v1::Status statusOfException() {
  try {
    throw;
  } catch (const Refusal& refusal) {
    v1::Status status = makeStatus(refusal.code, refusal.what(), refusal.field);
    status.set_limit(refusal.limit);
    status.set_retry_after_s(refusal.retry_after_s);
    return status;
  } catch (const SceneError& fault) {  // of the scene's file: those of trajectories have become Refusals
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

}  // namespace saccade
