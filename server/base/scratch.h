// Memory that a piece of work needs until it ends. A thread keeps it for its next piece.
#pragma once

#include <memory>
#include <vector>

namespace saccade {

// A piece may run within another one of the same thread (TilePool::yieldToHighPriority), so each takes its
// own. The memory is not cleared: it keeps the values of earlier pieces.
template <class T>
class Scratch {
 public:
  Scratch() {
    if (used_ == kept_.size()) kept_.push_back(std::make_unique_for_overwrite<T>());
    memory_ = kept_[used_++].get();
  }
  ~Scratch() { --used_; }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  T& operator*() const { return *memory_; }
  T* operator->() const { return memory_; }

 private:
  inline static thread_local std::vector<std::unique_ptr<T>> kept_;
  inline static thread_local std::size_t used_ = 0;
  T* memory_;
};

}  // namespace saccade
