// Finds the columns of the events in a file of arrays, as others lay them out.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "client/formats/common/array_file.h"
#include "client/formats/common/column_names.h"
#include "client/formats/common/column_order.h"

namespace saccade::client {

struct FoundColumns {
  std::array<ColumnPlace, 4> places;  // of t, x, y and p
  std::optional<TimeUnit> told;       // the unit of t, by its name
  std::string text;                   // "columns t x y p of events"
};

// Looks for four arrays with names of t, x, y and p. If they are not there, looks for an array of structures
// with such fields, or of rows of four numbers in one of `orders`. Throws FileFault where there is none, or
// more than one, and std::invalid_argument if `options` do not fit.
FoundColumns findColumns(const std::string& path, const ArrayFile& file, const ColumnOptions& options,
                         const std::vector<ColumnOrder>& orders);

}  // namespace saccade::client
