// A file of named arrays of numbers, as NumPy and HDF5 have them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace saccade::client {

// A column of numbers, read part by part. Every call throws FileFault with the file's name and the array's.
class NumberColumn {
 public:
  virtual ~NumberColumn() = default;
  virtual std::uint64_t size() const = 0;
  virtual bool real() const = 0;  // floating-point numbers
  // Replaces the values by the next `count`. A number that is not whole, or has no place in 64 bits, becomes
  // INT64_MAX, which is none of an event.
  virtual void read(std::uint64_t count, std::vector<std::int64_t>& values) = 0;
  virtual void readReal(std::uint64_t count, std::vector<double>& values) = 0;
};

// A column of an array: the whole of it, or one field of its structures, or one column of its table.
struct ColumnPlace {
  std::string array;
  std::string field = "";                              // of structures
  std::optional<std::uint64_t> column = std::nullopt;  // of a table
};

struct ArrayForm {
  std::vector<std::string> fields;       // of an array of structures
  std::optional<std::uint64_t> columns;  // of an array of two dimensions, a table
};

// Calls throw as those of NumberColumn.
class ArrayFile {
 public:
  virtual ~ArrayFile() = default;
  virtual std::vector<std::string> names() const = 0;   // of arrays that may be of events
  virtual bool has(const std::string& name) const = 0;  // also of others
  // Without fields and columns: an array of one dimension, or something else.
  virtual ArrayForm form(const std::string& name) const = 0;
  virtual std::unique_ptr<NumberColumn> open(const ColumnPlace& place) const = 0;
};

// Values of floating-point columns as whole numbers, as read() gives them.
std::int64_t wholeOf(double value);

}  // namespace saccade::client
