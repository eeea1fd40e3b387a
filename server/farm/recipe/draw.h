// How a recipe gives a value to each sequence: fixed, listed or drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace saccade::farm {

// The texts of an option. Several give it several times. None, and present: a flag.
struct Value {
  bool present = true;
  std::vector<std::string> texts = {};
  friend bool operator==(const Value&, const Value&) = default;
};

struct Draw {
  enum class Kind {
    kFixed,       // values[0]
    kEach,        // the values in turn
    kChoice,      // one of the values, by their weights
    kUniform,     // a number from low to high
    kInteger,     // a whole number from low to high, both included
    kLogUniform,  // a number from low to high, > 0, whose logarithm is uniform
    kNormal,      // a number of this mean and deviation; outside of [low, high] it is drawn again
  };
  Kind kind = Kind::kFixed;
  std::vector<Value> values = {};
  std::vector<double> weights = {};  // of kChoice, of the values; they need not add up to 1
  double low = 0, high = 0, mean = 0, deviation = 0;
};

// The value at a random address: equal addresses give equal values. `turn`: which value of kEach, counted
// round. Numbers have 6 digits.
Value valueAt(const Draw& draw, std::uint64_t address, std::uint64_t turn);

// Values that are on the edge of what valueAt() can give: all of a list, or the least and the greatest
// number.
std::vector<Value> extremes(const Draw& draw);

std::string numberText(double number);  // 6 digits
std::string exactText(double number);   // the shortest text that is read as the same number

}  // namespace saccade::farm
