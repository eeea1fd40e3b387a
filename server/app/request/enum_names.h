// The names of the schema's enumerations.
#pragma once

#include <cctype>
#include <string>
#include <vector>

#include "app/request/refusal.h"
#include "base/check.h"
#include "base/names.h"

namespace saccade {

// `value`, or `fallback` where it is 0. Throws Refusal unless the schema names the value.
template <class Enum>
Enum resolveEnum(const std::string& field, Enum value, Enum fallback) {
  const auto* names = google::protobuf::GetEnumDescriptor<Enum>();
  if (value == 0) return fallback;
  if (names->FindValueByNumber(value)) return value;
  std::vector<std::string> valid;
  for (int i = 1; i < names->value_count(); ++i) valid.push_back(names->value(i)->name());
  throw Refusal(
      v1::CODE_INVALID_ARGUMENT, field,
      std::to_string(value) + " is not a value of " + names->name() + "; valid: " + joinNames(valid));
}

// A value's name in lower case and without its prefix: "kalman" of RECONSTRUCTION_KALMAN without
// "RECONSTRUCTION_".
std::string nameWithout(const std::string& prefix, const std::string& value);

// The reverse. The schema must have a value of that name.
template <class Enum>
Enum valueNamed(const std::string& prefix, const std::string& name) {
  std::string full = prefix;
  for (const unsigned char c : name) full += static_cast<char>(std::toupper(c));
  const auto* value = google::protobuf::GetEnumDescriptor<Enum>()->FindValueByName(full);
  SACCADE_CHECK(value);
  return static_cast<Enum>(value->number());
}

}  // namespace saccade
