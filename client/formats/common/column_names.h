// Names of columns of events in files that others write.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/formats/common/time_unit.h"

namespace saccade::client {

enum class Role { kT, kX, kY, kP };

inline constexpr std::array<Role, 4> kRoles{Role::kT, Role::kX, Role::kY, Role::kP};
inline constexpr char kRoleLetters[] = "txyp";

struct ColumnName {
  Role role = Role::kT;
  std::optional<TimeUnit> unit;  // of t, where the name tells it: t_us, "t [ns]", time(s)
};

// Takes the spellings of t (ts, time, timestamp, ...), x, y and p (pol, polarity, on, ...), in any case.
// nullopt: the name is none of these.
std::optional<ColumnName> parseColumnName(std::string_view name);

// A user's words on the columns: --columns and --unit.
struct ColumnOptions {
  std::vector<std::string> columns;
  std::optional<TimeUnit> unit;

  // Whether all the columns have such names, with t, x, y and p once each, or are "-": any other column.
  bool inKnownWords() const;
};

std::string joined(const std::vector<std::string>& words, const char* separator = " ");

// Where t, x, y and p stand among some columns, in the order of kRoles.
struct RolePlaces {
  std::array<std::size_t, 4> at{};
  std::optional<TimeUnit> unit;
};

// Finds them by the names of the columns. nullopt: one of the four is absent. Throws FileFault if two columns
// have one role.
std::optional<RolePlaces> placesOf(const std::string& path, const std::vector<std::string>& names);

// The same, by what --columns says: its words are names among `names`. They are t, x, y and p in this order,
// unless they are in known words. nullopt: one of them is not there.
std::optional<RolePlaces> placesBy(const ColumnOptions& options, const std::vector<std::string>& names);

}  // namespace saccade::client
