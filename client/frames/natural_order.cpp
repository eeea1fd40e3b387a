#include "client/frames/natural_order.h"

#include <algorithm>
#include <cctype>

namespace saccade::client {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Takes the number that `text` begins with, without leading zeros.
std::string_view takeNumber(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
  std::string_view digits(text.begin(), end);
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

struct Difference {
  int order = 0;  // below 0: a comes first
  bool in_number = false;
};

Difference differenceOf(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (isDigit(a[0]) && isDigit(b[0])) {
      const std::string_view m = takeNumber(a), n = takeNumber(b);
      if (m != n) return {m.size() == n.size() ? m.compare(n) : m.size() < n.size() ? -1 : 1, true};
    } else if (a[0] == b[0]) {
      a.remove_prefix(1);
      b.remove_prefix(1);
    } else {
      break;
    }
  }
  return {a.compare(b)};
}

}  // namespace

bool naturalLess(std::string_view a, std::string_view b) {
  const int order = differenceOf(a, b).order;
  return order < 0 || (order == 0 && a < b);
}

bool numberFalls(std::string_view a, std::string_view b) {
  const Difference difference = differenceOf(a, b);
  return difference.in_number && difference.order > 0;
}

}  // namespace saccade::client
