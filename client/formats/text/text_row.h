// A line of a text file of events.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "client/formats/common/column_names.h"
#include "client/formats/common/polarity.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

struct RowForm {
  char separator = ',';
  std::vector<std::optional<Role>> columns;  // without a role: passed over
  TimeUnit unit = TimeUnit::kUs;
  bool decimals = false;  // t may have some
};

class RowParser {
 public:
  explicit RowParser(const RowForm& form) : form_(form) {}

  // false: the line is not of this form.
  bool parse(std::string_view line, Event& event);

 private:
  bool takeField(std::string_view& text, const std::optional<Role>& role, Event& event);
  std::optional<std::uint8_t> takePolarity(std::string_view& text);

  const RowForm form_;
  PolarityScale polarities_;
};

}  // namespace saccade::client
