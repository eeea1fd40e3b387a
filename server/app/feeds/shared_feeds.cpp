#include "app/feeds/shared_feeds.h"

namespace saccade {
namespace {

// A paced stream that may drop packets never waits for its client, so such streams cannot hold each other up.
bool mayShare(const v1::OpenStream& request) {
  return isPaced(request) && request.delivery() != v1::DELIVERY_LOSSLESS && !request.timing().steerable();
}

}  // namespace

bool isPaced(const v1::OpenStream& request) {
  return request.timing().clock() == v1::CLOCK_PACED;
}

std::shared_ptr<void> SharedFeeds::takeTurn(const ResolvedStream& stream, const std::stop_token& stop) {
  return mayShare(stream.request) ? turns_.take(stream.feedKeyOfAnySpeed(), stop) : nullptr;
}

std::shared_ptr<FeedRunner> SharedFeeds::find(const ResolvedStream& stream) {
  if (!mayShare(stream.request)) return nullptr;
  std::lock_guard lock(mutex_);
  std::erase_if(feeds_, [](const auto& entry) { return entry.second.expired(); });
  const auto found = feeds_.find(stream.feedKey());
  const auto feed = found == feeds_.end() ? nullptr : found->second.lock();
  return feed && !feed->ending() ? feed : nullptr;
}

void SharedFeeds::add(const ResolvedStream& stream, const std::shared_ptr<FeedRunner>& feed) {
  if (!mayShare(stream.request)) return;
  std::lock_guard lock(mutex_);
  feeds_[stream.feedKey()] = feed;
}

}  // namespace saccade
