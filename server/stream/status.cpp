#include "stream/status.h"

namespace saccade {

v1::Status okStatus() {
  return makeStatus(v1::CODE_OK, {});
}

v1::Status makeStatus(v1::Code code, const std::string& message, const std::string& field) {
  v1::Status status;
  status.set_code(code);
  status.set_message(message);
  status.set_field(field);
  return status;
}

v1::Status noMemoryStatus() {
  v1::Status status = makeStatus(v1::CODE_RESOURCE_EXHAUSTED, "the server has no memory for this request");
  status.set_limit("memory");
  return status;
}

}  // namespace saccade
