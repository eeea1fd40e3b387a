// Why a request is refused. Thrown where it is found out, made a Status in one place.
#pragma once

#include <cctype>
#include <stdexcept>
#include <string>

#include "app/limits.h"
#include "base/check.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

struct Refusal : std::runtime_error {
  Refusal(v1::Code code, std::string field, const std::string& message)
      : std::runtime_error(message), code(code), field(std::move(field)) {}
  v1::Code code;
  std::string field;  // path of the offending field; empty if none is at fault
  std::string limit;  // the one that is reached; empty unless CODE_RESOURCE_EXHAUSTED
  double retry_after_s = 0;
};

// Others who hold what is wanted end when they like.
inline constexpr double kRetrySeconds = 2;

struct LimitReached : Refusal {
  // `retry_after_s` as in Status.
  LimitReached(Limit limit, std::string field, const std::string& message, double retry_after_s = 0);
};

// The Status of the exception being handled.
v1::Status statusOfException();

[[noreturn]] void refuse(const std::string& field, const std::string& message);  // CODE_INVALID_ARGUMENT

// Throws unless min <= value <= max; NaN throws.
void checkRange(const std::string& field, double value, double min, double max);

// Throws unless `value` is one that the schema names. `value` 0 becomes `fallback`.
template <class Enum>
Enum resolveEnum(const std::string& field, Enum value, Enum fallback) {
  const auto* names = google::protobuf::GetEnumDescriptor<Enum>();
  if (value == 0) return fallback;
  if (names->FindValueByNumber(value)) return value;
  std::string valid;
  for (int i = 1; i < names->value_count(); ++i) valid += (i > 1 ? ", " : "") + names->value(i)->name();
  throw Refusal(v1::CODE_INVALID_ARGUMENT, field,
                std::to_string(value) + " is no " + names->name() + "; valid: " + valid);
}

// What the code calls a value of the schema: RECONSTRUCTION_KALMAN without the prefix "RECONSTRUCTION_" is
// "kalman".
std::string nameWithout(const std::string& prefix, const std::string& value);

// The reverse. The schema has a value of that name.
template <class Enum>
Enum valueNamed(const std::string& prefix, const std::string& name) {
  std::string full = prefix;
  for (const unsigned char c : name) full += static_cast<char>(std::toupper(c));
  const auto* value = google::protobuf::GetEnumDescriptor<Enum>()->FindValueByName(full);
  SACCADE_CHECK(value);
  return static_cast<Enum>(value->number());
}

}  // namespace saccade
