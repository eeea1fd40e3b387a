// The order of the columns of a table without names.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "client/formats/common/column_names.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

using ColumnOrder = std::array<Role, 4>;
using SampleRow = std::array<double, 4>;

inline constexpr ColumnOrder kTxyp{Role::kT, Role::kX, Role::kY, Role::kP},
    kXypt{Role::kX, Role::kY, Role::kP, Role::kT}, kXytp{Role::kX, Role::kY, Role::kT, Role::kP};

// The one of `orders` that fits the first rows of a file. There p is 0 and 1, or -1 and 1, and x and y are
// pixels. t runs on, and alone has fractions. Throws FileFault if none fits, or more than one.
ColumnOrder findOrder(const std::string& path, const std::vector<ColumnOrder>& orders,
                      const std::vector<SampleRow>& rows);

std::string textOf(const ColumnOrder& order);  // "t,x,y,p"

}  // namespace saccade::client
