// The header of an array of NumPy: see numpy.lib.format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace saccade::client {

struct NpyField {
  std::string name;             // empty: the array is one of numbers
  char order = 0;               // of bytes: '<' little, '>' big, '|' does not matter
  char kind = 0;                // of values: 'i', 'u', 'b' for bool, 'f', 'V' for none, ...
  std::size_t value_bytes = 0;  // 1 to 99
  std::size_t offset = 0;       // within an element, in bytes
};

struct NpyHeader {
  std::vector<NpyField> fields;  // of a structure; one of an array of numbers
  std::size_t element_bytes = 0;
  std::optional<std::uint64_t> length;   // along the first dimension; none: a single value
  std::optional<std::uint64_t> columns;  // along the second, if there are two: 1 to 64
  bool by_columns = false;               // in Fortran's order

  bool structured() const { return !fields.front().name.empty(); }
};

// Takes the text of a header, such as "{'descr': '<i8', 'fortran_order': False, 'shape': (3,), }". Returns
// nullopt for another form: more than two dimensions, structures within structures or more than 64 fields.
std::optional<NpyHeader> parseNpyHeader(const std::string& text);

}  // namespace saccade::client
