// LAYOUT_COLUMNS, 9 bytes an event: u32 dt[n] | u16 x[n] | u16 y[n] | u8 p[n], little-endian, without
// padding. dt counts units of dt_unit_ns since t0_ns.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "saccade/v1/events.pb.h"
#include "wire/event.h"

namespace saccade {

inline constexpr std::size_t kColumnsBytesPerEvent = 9;

// Times are floored to dt_unit_ns. Throws std::out_of_range where an event lies before t0_ns or 2^32 units or
// more behind it.
std::string encodeColumns(std::span<const Event> events, std::int64_t t0_ns, std::uint32_t dt_unit_ns);

// The events of a payload, as its header describes them; `payload` may hold anything. Returns what is wrong,
// or an empty text: the size is not that of `count` events, a pixel lies outside width x height, p is neither
// 0 nor 1, times decrease or leave [t0_ns, t1_ns) (t0_ns alone where t0_ns = t1_ns). `out` is overwritten.
std::string decodeColumns(const v1::PacketHeader& header, std::string_view payload, Events& out);

}  // namespace saccade
