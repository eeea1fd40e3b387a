// The fields name=value of the header of a record of a bag, read from a file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/formats/common/byte_reader.h"
#include "client/formats/ros/bag_record.h"

namespace saccade::client {

// Every call throws std::runtime_error for bytes that are no such fields.
class BagRecordFields {
 public:
  // Refers to `header`.
  explicit BagRecordFields(std::string_view header) {
    for (ByteReader bytes(header); !bytes.atEnd();) {
      const std::string_view field = bytes.sized();
      const std::size_t sign = field.find('=');
      if (sign == field.npos) throw std::runtime_error("has a field without '='");
      fields_.emplace_back(field.substr(0, sign), field.substr(sign + 1));
    }
  }

  std::string_view text(std::string_view name) const {
    for (const auto& [key, value] : fields_)
      if (key == name) return value;
    throw std::runtime_error("has no field '" + std::string(name) + "'");
  }
  template <class T>
  T number(std::string_view name) const {
    const std::string_view value = text(name);
    if (value.size() != sizeof(T)) throw std::runtime_error("has a bad field '" + std::string(name) + "'");
    return ByteReader(value).number<T>();
  }
  BagOp op() const { return static_cast<BagOp>(number<std::uint8_t>("op")); }

 private:
  std::vector<std::pair<std::string_view, std::string_view>> fields_;
};

}  // namespace saccade::client
