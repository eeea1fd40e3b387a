// Takes numbers off the front of a text. Those that return a bool return false if there is none.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "client/formats/common/time_unit.h"

namespace saccade::client {

// Up to 18 digits, if no decimal point or exponent follows: what most numbers are.
inline bool takeDigits(std::string_view& text, std::int64_t& value) {
  std::size_t count = 0;
  std::uint64_t digits = 0;  // wraps where there are more
  for (; count < text.size() && text[count] >= '0' && text[count] <= '9'; ++count)
    digits = digits * 10 + static_cast<std::uint64_t>(text[count] - '0');
  const char next = count < text.size() ? text[count] : ',';
  if (count == 0 || count > 18 || next == '.' || next == 'e' || next == 'E') return false;
  text.remove_prefix(count);
  value = static_cast<std::int64_t>(digits);
  return true;
}

bool takeReal(std::string_view& text, double& value);
// A whole number, also as 96.0 or 9.6e+01. One that is not whole becomes INT64_MAX.
bool takeAnyWhole(std::string_view& text, std::int64_t& value);
inline bool takeWhole(std::string_view& text, std::int64_t& value) {
  return takeDigits(text, value) || takeAnyWhole(text, value);
}

// A time in `unit`, as the nearest whole microsecond: exactly, unless it has an exponent. False also for one
// with a decimal point or an exponent, unless `decimals`, and beyond 292 years.
bool takeTime(std::string_view& text, TimeUnit unit, bool decimals, std::int64_t& t_us);

// Takes a number and the separator after it; nullopt if they are not there. With kEnd as separator the number
// is the last of the text.
inline constexpr char kEnd = 0;
template <class T>
std::optional<T> takeNumber(std::string_view& text, char separator) {
  T value;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(rest - text.data());
  if (separator == kEnd && text.empty()) return value;
  if (text.empty() || text.front() != separator) return std::nullopt;
  text.remove_prefix(1);
  return value;
}

}  // namespace saccade::client
