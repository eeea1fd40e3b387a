// Where the reply of a request goes.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <utility>

#include "saccade/v1/control.pb.h"

namespace saccade {

class Answer {
 public:
  using Give = std::function<void(v1::Reply)>;
  using Expect = std::function<void(std::size_t)>;

  template <std::invocable<v1::Reply> F>
  Answer(
      F give, Expect expect = [](std::size_t) {})
      : give_(std::move(give)), expect_(std::move(expect)) {}

  // Gives the reply. Call it once, at any time, from any thread.
  void operator()(v1::Reply reply) const { give_(std::move(reply)); }
  // Tells that the reply will have so many bytes: they count until then. Before the reply, on the thread that
  // asks.
  void expect(std::size_t bytes) const { expect_(bytes); }

 private:
  Give give_;
  Expect expect_;
};

}  // namespace saccade
