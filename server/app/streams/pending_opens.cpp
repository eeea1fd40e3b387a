#include "app/streams/pending_opens.h"

#include "base/cancelled.h"
#include "base/text_cut.h"

namespace saccade {

std::shared_ptr<PendingOpen> PendingOpens::add(const Peer& peer, std::uint64_t request_id) {
  std::shared_ptr<PendingOpen> one(new PendingOpen{peer, request_id}, [this](PendingOpen* gone) {
    std::unique_lock lock(mutex_);
    all_.erase(gone);
    lock.unlock();
    delete gone;
  });
  std::lock_guard lock(mutex_);
  all_.insert(one.get());
  return one;
}

void PendingOpens::setScene(PendingOpen& opening, const std::string& scene) {
  std::lock_guard lock(mutex_);
  opening.scene = cutText(scene, kMaxEcho);
}

void PendingOpens::begin(PendingOpen& opening, const char* doing) {
  throwIfStopped(opening.stop.get_token());
  std::lock_guard lock(mutex_);
  opening.doing = doing, opening.done = 0;
}

void PendingOpens::setDone(PendingOpen& opening, double share) {
  std::lock_guard lock(mutex_);
  opening.done = share;
}

std::vector<v1::OpeningInfo> PendingOpens::list(const Peer& peer, bool all, const ClientLog& names) const {
  std::vector<v1::OpeningInfo> infos;
  const auto now = ChangeNotifier::Clock::now();
  std::lock_guard lock(mutex_);
  for (const PendingOpen* opening : all_) {
    if (!peer.sees(opening->peer.user, all)) continue;
    v1::OpeningInfo& info = infos.emplace_back();
    info.set_request_id(opening->request_id);
    info.set_scene(opening->scene);
    info.set_elapsed_s(std::chrono::duration<double>(now - opening->began).count());
    info.set_doing(opening->doing);
    info.set_done(opening->done);
    info.set_client(names.nameOf(opening->peer.user));
  }
  return infos;
}

template <class Mine>
bool PendingOpens::cancelWhere(Mine mine) {
  bool any = false;
  std::lock_guard lock(mutex_);
  for (PendingOpen* opening : all_) {
    if (mine(*opening)) any |= opening->stop.request_stop();
  }
  return any;
}

bool PendingOpens::cancel(const Peer& peer, std::uint64_t request_id) {
  return cancelWhere([&](const PendingOpen& opening) {
    const bool same_user = !peer.user.empty() && opening.peer.user == peer.user;
    return opening.request_id == request_id && (same_user || opening.peer.connection == peer.connection);
  });
}

void PendingOpens::cancelAllOf(const std::string& connection) {
  cancelWhere([&](const PendingOpen& opening) { return opening.peer.connection == connection; });
}

void PendingOpens::cancelAll() {
  cancelWhere([](const PendingOpen&) { return true; });
}

}  // namespace saccade
