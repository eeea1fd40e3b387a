#include "reply/status.h"

#include "base/text_cut.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxStatusBytes = 4096;  // scene files and their names may hold any bytes

}  // namespace

v1::Status okStatus() {
  return makeStatus(v1::CODE_OK, {});
}

v1::Status makeStatus(v1::Code code, const std::string& message, const std::string& field) {
  v1::Status status;
  status.set_code(code);
  status.set_message(cutText(message, kMaxStatusBytes));
  status.set_field(field);
  return status;
}

v1::Status noMemoryStatus() {
  v1::Status status = makeStatus(v1::CODE_RESOURCE_EXHAUSTED, "the server has no memory for this request");
  status.set_limit("memory");
  return status;
}

}  // namespace saccade
