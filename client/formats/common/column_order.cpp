#include "client/formats/common/column_order.h"

#include <algorithm>
#include <cmath>

namespace saccade::client {
namespace {

bool isPixel(double value) {
  return value >= 0 && value <= UINT16_MAX && value == std::trunc(value);
}

// Times of real files may run back a little, now and then.
bool runsOn(const std::vector<SampleRow>& rows, std::size_t column) {
  std::size_t back = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) back += rows[i][column] < rows[i - 1][column];
  return back * 4 <= rows.size() && rows.back()[column] >= rows.front()[column];
}

bool fits(const ColumnOrder& order, const std::vector<SampleRow>& rows) {
  if (rows.empty()) return true;
  const auto at = [&](Role role) { return std::find(order.begin(), order.end(), role) - order.begin(); };
  const auto x = at(Role::kX), y = at(Role::kY), p = at(Role::kP);
  const bool is_signed = std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row[p] < 0; });
  const double off = is_signed ? -1 : 0;
  return runsOn(rows, at(Role::kT)) && std::all_of(rows.begin(), rows.end(), [&](const SampleRow& row) {
           return isPixel(row[x]) && isPixel(row[y]) && (row[p] == off || row[p] == 1);
         });
}

}  // namespace

ColumnOrder findOrder(const std::string& path, const std::vector<ColumnOrder>& orders,
                      const std::vector<SampleRow>& rows) {
  std::string tried;
  std::vector<ColumnOrder> fitting;
  for (const ColumnOrder& order : orders) {
    tried += (tried.empty() ? "" : " nor ") + textOf(order);
    if (fits(order, rows)) fitting.push_back(order);
  }
  if (fitting.empty())
    throw FileFault(path, "its columns have no names, and are not " + tried + "; give --columns");
  if (fitting.size() == 1 || rows.empty()) return fitting.front();
  throw FileFault(path, "its columns may be " + textOf(fitting[0]) + " or " + textOf(fitting[1]) +
                            ": give --columns " + textOf(fitting[0]) + " or --columns " + textOf(fitting[1]));
}

std::string textOf(const ColumnOrder& order) {
  std::string text;
  for (const Role role : order) {
    if (!text.empty()) text += ',';
    text += kRoleLetters[static_cast<std::size_t>(role)];
  }
  return text;
}

}  // namespace saccade::client
