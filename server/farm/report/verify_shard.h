// The part of verify() for a shard: its table, its index, its failures and its sequences.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "farm/report/findings.h"

namespace saccade::farm {

// The number that is written in digits alone; nothing for other names.
std::optional<std::uint64_t> numberOf(const std::string& name);

// `step` hears of each sequence.
void verifyShard(const DataSet& set, std::uint32_t shard, Findings& findings,
                 const std::function<void(const Verified&)>& step);

}  // namespace saccade::farm
