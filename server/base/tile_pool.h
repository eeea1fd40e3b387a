// A pool of threads that works through numbered pieces of a picture: tiles, or bands of rows.
//
// Any number of callers may submit at once; each waits for its own job. Workers take pieces from the open
// jobs in turn, so two feeds share the cores fairly; those of urgent jobs before all others, and between the
// steps of a long piece that says yieldToHighPriority(). What a piece writes must not depend on who runs it:
// results are then the same for any number of threads. All workers flush denormals to zero (the filter is
// twice as slow without).
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <stop_token>
#include <utility>

namespace saccade {

// A job was stopped before its end.
struct Cancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

// Denormals are zero, in and out, for the calling thread.
void flushDenormalsToZero();

int hardwareThreads();  // that this process may run at once

struct Tile {
  int x0, y0, x1, y1;  // [x0, x1) x [y0, y1)
};
inline constexpr int kBandRows = 8;

class TilePool {
 public:
  explicit TilePool(int threads);  // >= 1
  // A copy has the same workers. They take pieces of urgent jobs first: for who has to be done by a certain
  // time. At first none is.
  void setUrgent(bool urgent) { urgent_ = urgent; }

  // run() of this handle drops the pieces that are left and throws Cancelled, once `stop` says so.
  void setStop(std::stop_token stop) { stop_ = std::move(stop); }

  int threads() const;
  // Which share of the time of a CPU a worker gets that has a piece, of late: (0, 1], 1 on an idle machine.
  double receivedShare() const;
  // What the jobs of the calling thread would have taken so far, each with all workers to itself: no less
  // than its longest piece.
  static std::chrono::nanoseconds chainTime();

  // For a piece that may take longer than a few milliseconds, between its steps, where it holds no lock:
  // unless it is urgent itself, the worker works through the urgent pieces there are before it goes on.
  static void yieldToHighPriority();

  // Calls f(i) for i in [0, count), in any order, on the workers. Returns the CPU time that took. Throws what
  // a call threw, after all others.
  template <class F>
  std::chrono::nanoseconds run(int count, const F& f) {
    Job job{count, urgent_, stop_, &f,
            [](const void* context, int i) { (*static_cast<const F*>(context))(i); }};
    return runJob(job);
  }

  // Calls f(Tile) for every tile of a width x height picture.
  template <class F>
  std::chrono::nanoseconds forEachTile(int width, int height, int edge, const F& f) {
    const int across = (width + edge - 1) / edge, down = (height + edge - 1) / edge;
    return run(across * down, [&](int i) {
      const int x = i % across * edge, y = i / across * edge;
      f(Tile{x, y, std::min(x + edge, width), std::min(y + edge, height)});
    });
  }

  // Calls f(y) for every row, a band of rows per piece.
  template <class F>
  std::chrono::nanoseconds forEachRow(int height, const F& f) {
    return run((height + kBandRows - 1) / kBandRows, [&](int band) {
      for (int y = band * kBandRows; y < std::min((band + 1) * kBandRows, height); ++y) f(y);
    });
  }

 private:
  struct Job {
    int count;
    bool urgent;
    const std::stop_token& stop;
    const void* context;
    void (*piece)(const void*, int);
    int next = 0;                                 // first piece not yet taken
    int running = 0;                              // pieces taken and not finished
    std::chrono::nanoseconds cpu{0}, longest{0};  // of all pieces, of one
    std::exception_ptr fault{};
    std::condition_variable done{};  // its own: what one caller waits for wakes no other
  };
  struct Workers;

  std::chrono::nanoseconds runJob(Job& job);

  std::shared_ptr<Workers> workers_;
  bool urgent_ = false;
  std::stop_token stop_;
};

}  // namespace saccade
