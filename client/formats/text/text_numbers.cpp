#include "client/formats/text/text_numbers.h"

#include <charconv>

#include "client/formats/common/array_file.h"

namespace saccade::client {
namespace {

template <class T>
bool take(std::string_view& text, T& value) {
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  text.remove_prefix(rest - text.data());
  return true;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool atExponent(std::string_view text) {
  return !text.empty() && (text.front() == 'e' || text.front() == 'E');
}

bool atDecimals(std::string_view text) {
  return !text.empty() && (text.front() == '.' || atExponent(text));
}

// Digits as a number of `count` digits, rounded by the next.
std::int64_t takeDecimals(std::string_view& text, int count) {
  std::int64_t value = 0;
  int digits = 0;
  bool up = false;
  for (; !text.empty() && isDigit(text.front()); text.remove_prefix(1), ++digits) {
    if (digits < count) value = value * 10 + (text.front() - '0');
    if (digits == count) up = text.front() >= '5';
  }
  for (; digits < count; ++digits) value *= 10;
  return value + up;
}

bool takeRealTime(std::string_view& text, TimeUnit unit, std::int64_t& t_us) {
  double time;
  if (!takeReal(text, time)) return false;
  const auto us = toUs(time, unit);
  t_us = us.value_or(0);
  return us.has_value();
}

}  // namespace

bool takeReal(std::string_view& text, double& value) {
  return take(text, value);
}

bool takeAnyWhole(std::string_view& text, std::int64_t& value) {
  const std::string_view start = text;
  if (!take(text, value)) return false;
  if (!atDecimals(text)) return true;
  text = start;
  double real;
  if (!takeReal(text, real)) return false;
  value = wholeOf(real);
  return true;
}

bool takeTime(std::string_view& text, TimeUnit unit, bool decimals, std::int64_t& t_us) {
  if (unit == TimeUnit::kUs && takeDigits(text, t_us)) return true;
  const std::string_view start = text;
  std::int64_t whole;
  if (!take(text, whole)) return false;
  const auto us = toUs(whole, unit);
  if (!us) return false;
  t_us = *us;
  if (!atDecimals(text)) return true;
  if (!decimals) return false;
  const int digits = unit == TimeUnit::kS ? 6 : 3;  // of microseconds
  if (text.front() == '.' && (unit == TimeUnit::kS || unit == TimeUnit::kMs)) {
    text.remove_prefix(1);
    const std::int64_t part = takeDecimals(text, digits);
    const bool fits = !__builtin_add_overflow(t_us, start.front() == '-' ? -part : part, &t_us);
    if (!atExponent(text)) return fits;
  }
  text = start;
  return takeRealTime(text, unit, t_us);
}

}  // namespace saccade::client
