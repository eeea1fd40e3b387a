#include "saccade/opened_check.h"

#include <string>

#include "saccade/stream_fault.h"
#include "saccade/stream_views.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw StreamFault("the server's reply to open_stream cannot be: " + what);
}

template <class T>
void checkRange(const std::string& what, double value, const Range<T>& range) {
  if (!(value >= range.min && value <= range.max)) fail(what + " is " + std::to_string(value));
}

void checkCount(const char* what, int opened, int asked) {
  if (opened == asked) return;
  fail(std::to_string(opened) + " " + what + " instead of " + std::to_string(asked));
}

void checkView(const v1::View& view, const v1::View& asked) {
  checkRange("view.width", view.width(), ranges::kViewSide);
  checkRange("view.height", view.height(), ranges::kViewSide);
  const bool same = view.width() == asked.width() && view.height() == asked.height();
  if (!same || view.width() * view.height() > ranges::kMaxViewPixels)
    fail("a view of " + std::to_string(view.width()) + "x" + std::to_string(view.height()) + " pixels");
}

template <class Channels>
void checkViewNumbers(const char* what, const Channels& channels, std::uint32_t views) {
  for (const auto& channel : channels)
    if (channel.view() >= views)
      fail(std::string(what) + " of view " + std::to_string(channel.view()) + " of " + std::to_string(views));
}

void checkDelivery(const v1::StreamOpened& opened, v1::Delivery asked) {
  const v1::Delivery delivery = opened.resolved().delivery();
  const bool known = delivery != v1::DELIVERY_UNSPECIFIED && v1::Delivery_IsValid(delivery);
  if (!known || (asked != v1::DELIVERY_UNSPECIFIED && delivery != asked))
    fail("delivery " + std::to_string(delivery));
  if (delivery == v1::DELIVERY_BROADCAST && opened.topics().empty()) fail("a broadcast without topics");
}

}  // namespace

void checkOpened(const v1::StreamOpened& opened, const v1::OpenStream& asked) {
  const v1::OpenStream& resolved = opened.resolved();
  if (opened.stream_id().empty()) fail("a stream without stream_id");
  checkCount("sensors", resolved.sensors_size(), asked.sensors_size());
  checkCount("truth channels", resolved.truth_size(), asked.truth_size());
  checkCount("further views", resolved.further_views_size(), asked.further_views_size());
  for (std::uint32_t view = 0; view < viewsOf(asked); ++view)
    checkView(viewOf(resolved, view), viewOf(asked, view));
  checkViewNumbers("a sensor", resolved.sensors(), viewsOf(asked));
  checkViewNumbers("truth", resolved.truth(), viewsOf(asked));
  checkRange("timing.frame_rate_hz", resolved.timing().frame_rate_hz(), ranges::kFrameRate);
  checkRange("timing.duration_s", resolved.timing().duration_s(), ranges::kDuration);
  checkDelivery(opened, asked.delivery());
}

}  // namespace saccade::client
