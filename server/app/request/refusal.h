// The exception that refuses a request, and its Status.
#pragma once

#include <stdexcept>
#include <string>

#include "saccade/v1/control.pb.h"
#include "saccade/wire/ranges.h"

namespace saccade {

struct Refusal : std::runtime_error {
  Refusal(v1::Code code, std::string field, const std::string& message)
      : std::runtime_error(message), code(code), field(std::move(field)) {}
  v1::Code code;
  std::string field;  // path of the field at fault; empty if there is none
  std::string limit;  // name of the limit that is reached; empty unless CODE_RESOURCE_EXHAUSTED
  double retry_after_s = 0;
};

// The Status of the exception being handled.
v1::Status statusOfException();

[[noreturn]] void refuse(const std::string& field, const std::string& message);  // CODE_INVALID_ARGUMENT

// Throws unless min <= value <= max; NaN throws.
void checkRange(const std::string& field, double value, double min, double max);
template <class T>
void checkRange(const std::string& field, double value, const Range<T>& range) {
  checkRange(field, value, range.min, range.max);
}

}  // namespace saccade
