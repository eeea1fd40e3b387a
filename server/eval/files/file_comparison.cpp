#include "eval/files/file_comparison.h"

#include <algorithm>
#include <stdexcept>

namespace saccade::eval {
namespace {

// Of the window that holds `t_ns`.
std::int64_t endOfWindow(std::int64_t t_ns, std::int64_t window_ns) {
  const std::int64_t since = t_ns % window_ns;  // negative before 0
  return t_ns - since + (since < 0 ? 0 : window_ns);
}

}  // namespace

FileComparison compareFiles(EventWindows& a, EventWindows& b, std::int64_t window_ns) {
  if (textOf(a.size()) != textOf(b.size()))
    throw std::invalid_argument("A has " + textOf(a.size()) + " pixels, and B " + textOf(b.size()));
  FileComparison result(a.size());
  Events of_a, of_b;
  for (std::int64_t next; (next = std::min(a.nextNs(), b.nextNs())) != INT64_MAX;) {
    const std::int64_t end = endOfWindow(next, window_ns);
    a.until(end, of_a), b.until(end, of_b);
    result.of_a.add(of_a), result.of_b.add(of_b);
    result.distance.add(of_a, of_b);
  }
  return result;
}

}  // namespace saccade::eval
