#include "app/streams/openings.h"

#include "base/cancelled.h"
#include "base/text_cut.h"

namespace saccade {

std::shared_ptr<Opening> Openings::add(const Peer& peer, std::uint64_t request_id) {
  std::shared_ptr<Opening> one(new Opening{peer, request_id}, [this](Opening* gone) {
    std::unique_lock lock(mutex_);
    all_.erase(gone);
    lock.unlock();
    delete gone;
  });
  std::lock_guard lock(mutex_);
  all_.insert(one.get());
  return one;
}

void Openings::setScene(Opening& opening, const std::string& scene) {
  std::lock_guard lock(mutex_);
  opening.scene = cutText(scene, kMaxEcho);
}

void Openings::begin(Opening& opening, const char* doing) {
  throwIfStopped(opening.stop.get_token());
  std::lock_guard lock(mutex_);
  opening.doing = doing, opening.done = 0;
}

void Openings::setDone(Opening& opening, double share) {
  std::lock_guard lock(mutex_);
  opening.done = share;
}

std::vector<v1::OpeningInfo> Openings::list(const std::string& user) const {
  std::vector<v1::OpeningInfo> infos;
  const auto now = ChangeNotifier::Clock::now();
  std::lock_guard lock(mutex_);
  for (const Opening* opening : all_) {
    if (opening->peer.user != user) continue;
    v1::OpeningInfo& info = infos.emplace_back();
    info.set_request_id(opening->request_id);
    info.set_scene(opening->scene);
    info.set_elapsed_s(std::chrono::duration<double>(now - opening->began).count());
    info.set_doing(opening->doing);
    info.set_done(opening->done);
  }
  return infos;
}

template <class Mine>
bool Openings::cancelWhere(Mine mine) {
  bool any = false;
  std::lock_guard lock(mutex_);
  for (Opening* opening : all_) {
    if (mine(*opening)) any |= opening->stop.request_stop();
  }
  return any;
}

bool Openings::cancel(const Peer& peer, std::uint64_t request_id) {
  return cancelWhere([&](const Opening& opening) {
    const bool same_user = !peer.user.empty() && opening.peer.user == peer.user;
    return opening.request_id == request_id && (same_user || opening.peer.connection == peer.connection);
  });
}

void Openings::cancelAllOf(const std::string& connection) {
  cancelWhere([&](const Opening& opening) { return opening.peer.connection == connection; });
}

void Openings::cancelAll() {
  cancelWhere([](const Opening&) { return true; });
}

}  // namespace saccade
