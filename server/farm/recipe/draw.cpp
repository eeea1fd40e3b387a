#include "farm/recipe/draw.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/hash_rng.h"

namespace saccade::farm {
namespace {

constexpr int kDigits = 6;
constexpr int kMaxTries = 1000;  // of kNormal, whose bounds hold at least a hundredth of it

// Uniform in (0, 1), with 53 bits.
double unit(std::uint64_t address, std::uint64_t number) {
  return (static_cast<double>(hashKey(address, number) >> 12) + 0.5) * 0x1p-52;
}

const Value& choose(const Draw& draw, double at) {
  double left = at * std::accumulate(draw.weights.begin(), draw.weights.end(), 0.0);
  for (std::size_t i = 0; i < draw.values.size(); ++i)
    if ((left -= draw.weights[i]) < 0) return draw.values[i];
  return draw.values.back();
}

// [Box and Muller 1958]
double normal(const Draw& draw, std::uint64_t address) {
  double value = draw.mean;
  for (std::uint64_t i = 0; i < kMaxTries; ++i) {
    const double radius = std::sqrt(-2 * std::log(unit(address, 2 * i)));
    value = draw.mean + draw.deviation * radius * std::cos(2 * std::numbers::pi * unit(address, 2 * i + 1));
    if (value >= draw.low && value <= draw.high) return value;
  }
  return std::clamp(value, draw.low, draw.high);
}

double number(const Draw& draw, std::uint64_t address) {
  const double at = unit(address, 0), low = draw.low, high = draw.high;
  switch (draw.kind) {
    case Draw::Kind::kInteger:
      return std::min(high, low + std::floor(at * (high - low + 1)));
    case Draw::Kind::kLogUniform:
      return low * std::exp(at * std::log(high / low));
    case Draw::Kind::kNormal:
      return normal(draw, address);
    default:
      return low + at * (high - low);
  }
}

Value ofNumber(const Draw& draw, double value) {
  if (draw.kind == Draw::Kind::kInteger) return {true, {std::to_string(std::llround(value))}};
  return {true, {numberText(value)}};
}

}  // namespace

std::string numberText(double number) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

std::string exactText(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

Value valueAt(const Draw& draw, std::uint64_t address, std::uint64_t turn) {
  switch (draw.kind) {
    case Draw::Kind::kFixed:
      return draw.values.front();
    case Draw::Kind::kEach:
      return draw.values[turn % draw.values.size()];
    case Draw::Kind::kChoice:
      return choose(draw, unit(address, 0));
    default:
      return ofNumber(draw, number(draw, address));
  }
}

std::vector<Value> extremes(const Draw& draw) {
  if (!draw.values.empty()) return draw.values;
  return {ofNumber(draw, draw.low), ofNumber(draw, draw.high)};
}

}  // namespace saccade::farm
