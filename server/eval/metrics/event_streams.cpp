#include "eval/metrics/event_streams.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace saccade::eval {
namespace {

// A cell of a sparse histogram, and the value that is added to it.
struct Cell {
  std::int64_t bin;
  std::uint16_t y, x;
  std::uint8_t p;
  int amount;

  auto place() const { return std::tie(bin, y, x, p); }
};

// Sum over the cells of |sum of the added values|.
double sumOfCells(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.place() < b.place(); });
  double sum = 0;
  for (auto cell = cells.begin(); cell != cells.end();) {
    std::int64_t amount = 0;
    const auto place = cell->place();
    auto next = cell;
    for (; next != cells.end() && next->place() == place; ++next) amount += next->amount;
    sum += static_cast<double>(std::abs(amount));
    cell = next;
  }
  return sum;
}

// Relative L1 of two histograms; toCell(event) returns the cell and the value of an event.
template <class ToCell>
double histogramError(const Events& x, const Events& ref, ToCell toCell) {
  std::vector<Cell> cells;
  for (const Event& e : ref) cells.push_back(toCell(e));
  const double size = sumOfCells(cells);
  for (Cell& cell : cells) cell.amount = -cell.amount;
  for (const Event& e : x) cells.push_back(toCell(e));
  const double error = sumOfCells(std::move(cells));
  if (size == 0) return error == 0 ? 0 : std::numeric_limits<double>::infinity();
  return error / size;
}

std::int64_t floorDivide(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0);
}

auto byPixelAndTime(const Event& e) {
  return std::tuple(e.y, e.x, e.p == 1, e.t_ns);
}

bool sameSource(const Event& a, const Event& b) {
  return a.x == b.x && a.y == b.y && a.p == b.p;
}

}  // namespace

double countError(const Events& x, const Events& ref) {
  return histogramError(x, ref, [](const Event& e) { return Cell{0, e.y, e.x, e.p, 1}; });
}

double voxelError(const Events& x, const Events& ref, std::int64_t bin_ns) {
  return histogramError(x, ref, [bin_ns](const Event& e) {
    return Cell{floorDivide(e.t_ns, bin_ns), e.y, e.x, 0, e.p == 1 ? 1 : -1};
  });
}

TimeError nearestTimeError(const Events& x, const Events& ref, std::int64_t cap_ns) {
  const auto before = [](const Event& a, const Event& b) { return byPixelAndTime(a) < byPixelAndTime(b); };
  Events sorted = ref;
  std::sort(sorted.begin(), sorted.end(), before);
  double sum = 0;
  std::size_t capped = 0;
  for (const Event& e : x) {
    std::int64_t nearest = cap_ns + 1;
    const auto after = std::lower_bound(sorted.begin(), sorted.end(), e, before);
    if (after != sorted.end() && sameSource(*after, e)) nearest = std::min(nearest, after->t_ns - e.t_ns);
    if (after != sorted.begin() && sameSource(after[-1], e))
      nearest = std::min(nearest, e.t_ns - after[-1].t_ns);
    if (nearest > cap_ns) ++capped;
    sum += static_cast<double>(std::min(nearest, cap_ns));
  }
  return {sum / static_cast<double>(x.size()), capped};
}

}  // namespace saccade::eval
