// The header of an array of NumPy: see numpy.lib.format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace saccade::client {

struct NpyHeader {
  char order = 0;                       // of bytes: '<' little, '>' big, '|' does not matter
  char kind = 0;                        // of values: 'i', 'u', 'b' for bool, 'f', ...
  std::size_t value_bytes = 0;          // 1 to 99
  std::optional<std::uint64_t> length;  // values of a one-dimensional array; none: a single value
};

// Takes the text of a header, such as "{'descr': '<i8', 'fortran_order': False, 'shape': (3,), }". Returns
// nullopt for another form: an array of several dimensions, or of structures.
std::optional<NpyHeader> parseNpyHeader(const std::string& text);

}  // namespace saccade::client
