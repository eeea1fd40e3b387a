#include "client/formats/npz/npy_column.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace saccade::client {
namespace {

constexpr std::size_t kMaxStride = 256;  // bytes

template <class T>
T numberAt(const char* at) {
  T number;
  std::memcpy(&number, at, sizeof number);
  return number;
}

template <class T>
void widenWhole(const char* at, std::size_t stride, std::size_t count, std::int64_t* values) {
  for (std::size_t i = 0; i < count; ++i, at += stride) {
    const T number = numberAt<T>(at);
    if constexpr (std::is_floating_point_v<T>) {
      values[i] = wholeOf(number);
    } else {
      values[i] = std::in_range<std::int64_t>(number) ? static_cast<std::int64_t>(number) : INT64_MAX;
    }
  }
}

template <class T>
void widenReal(const char* at, std::size_t stride, std::size_t count, double* values) {
  for (std::size_t i = 0; i < count; ++i, at += stride) values[i] = static_cast<double>(numberAt<T>(at));
}

}  // namespace

NpyColumn::NpyColumn(const std::string& path, const ZipArchive& archive, const ColumnPlace& place)
    : stream_(path, archive, place.array),
      field_(fieldAt(place)),
      stride_(header().element_bytes * (header().by_columns ? 1 : header().columns.value_or(1))) {
  chooseType();
  if (stride_ > kMaxStride) stream_.fail("has rows of " + std::to_string(stride_) + " bytes");
  if (!header().by_columns) return;
  std::uint64_t bytes;
  if (__builtin_mul_overflow(size(), *place.column * header().element_bytes, &bytes))
    stream_.fail("is too large");
  stream_.skip(bytes);
  to_end_ = *place.column + 1 == *header().columns;
}

NpyField NpyColumn::fieldAt(const ColumnPlace& place) const {
  const auto& fields = header().fields;
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const NpyField& field) { return field.name == place.field; });
  if (found == fields.end() || place.column.has_value() != header().columns.has_value() ||
      place.column.value_or(0) >= header().columns.value_or(1))
    stream_.fail("is not one column of numbers");
  NpyField field = *found;
  if (!header().by_columns) field.offset += place.column.value_or(0) * header().element_bytes;
  return field;
}

template <class T>
void NpyColumn::setType() {
  whole_ = widenWhole<T>;
  real_ = widenReal<T>;
}

void NpyColumn::chooseType() {
  const bool bool_or_unsigned = field_.kind == 'b' || field_.kind == 'u', is_signed = field_.kind == 'i';
  const std::size_t bytes = field_.order == '>' ? 0 : field_.value_bytes;
  if (bool_or_unsigned && bytes == 1) return setType<std::uint8_t>();
  if (bool_or_unsigned && bytes == 2) return setType<std::uint16_t>();
  if (bool_or_unsigned && bytes == 4) return setType<std::uint32_t>();
  if (bool_or_unsigned && bytes == 8) return setType<std::uint64_t>();
  if (is_signed && bytes == 1) return setType<std::int8_t>();
  if (is_signed && bytes == 2) return setType<std::int16_t>();
  if (is_signed && bytes == 4) return setType<std::int32_t>();
  if (is_signed && bytes == 8) return setType<std::int64_t>();
  if (real() && bytes == 4) return setType<float>();
  if (real() && bytes == 8) return setType<double>();
  stream_.fail(std::string("is of type ") + field_.order + field_.kind + std::to_string(field_.value_bytes) +
               "; little-endian numbers of 1 to 8 bytes and bool can be read");
}

template <class Value>
void NpyColumn::widen(std::uint64_t count, Widen<Value> convert, std::vector<Value>& values) {
  bytes_.resize(count * stride_);
  stream_.read(bytes_.data(), bytes_.size());
  values.resize(count);
  convert(bytes_.data() + field_.offset, stride_, count, values.data());
  done_ += count;
  if (done_ == size() && to_end_) stream_.checkEnd();
}

void NpyColumn::read(std::uint64_t count, std::vector<std::int64_t>& values) {
  widen(count, whole_, values);
}

void NpyColumn::readReal(std::uint64_t count, std::vector<double>& values) {
  widen(count, real_, values);
}

}  // namespace saccade::client
