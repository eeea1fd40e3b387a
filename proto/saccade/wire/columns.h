// LAYOUT_COLUMNS, 9 bytes an event: u32 dt[n] | u16 x[n] | u16 y[n] | u8 p[n], little-endian, without
// padding. dt counts units of dt_unit_ns since t0_ns. LAYOUT_LABELLED_COLUMNS, 11 bytes an event: with u8
// source[n] | u8 artefact[n] behind them. LAYOUT_OBJECT_COLUMNS and LAYOUT_LABELLED_OBJECT_COLUMNS, 13 and 15
// bytes: with u32 object[n] behind those.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "saccade/v1/events.pb.h"
#include "saccade/wire/event.h"

namespace saccade {

constexpr bool hasLabels(v1::Layout layout) {
  return layout == v1::LAYOUT_LABELLED_COLUMNS || layout == v1::LAYOUT_LABELLED_OBJECT_COLUMNS;
}
constexpr bool hasObjects(v1::Layout layout) {
  return layout == v1::LAYOUT_OBJECT_COLUMNS || layout == v1::LAYOUT_LABELLED_OBJECT_COLUMNS;
}
// Of a layout of events; 0 of others.
constexpr std::size_t bytesPerEvent(v1::Layout layout) {
  if (layout != v1::LAYOUT_COLUMNS && !hasLabels(layout) && !hasObjects(layout)) return 0;
  return 9 + (hasLabels(layout) ? 2u : 0u) + (hasObjects(layout) ? 4u : 0u);
}

// Encodes `events` with a dt_unit_ns of kTimeUnitNs, to which their times are floored. Throws
// std::out_of_range where an event lies before t0_ns, or 2^32 units or more after it.
std::string encodeColumns(std::span<const Event> events, std::int64_t t0_ns,
                          v1::Layout layout = v1::LAYOUT_COLUMNS);

// Decodes a payload of any content, in a layout of events, into `out`, as its header describes it. Returns an
// empty text, or what is wrong:
// - the size is not that of `count` events;
// - a pixel lies outside width x height, p is neither 0 nor 1, or a label or object is none of Event's;
// - times decrease, or leave [t0_ns, t1_ns), or differ from t0_ns where t0_ns = t1_ns.
std::string decodeColumns(const v1::PacketHeader& header, std::string_view payload, Events& out);

}  // namespace saccade
