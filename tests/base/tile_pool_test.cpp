#include "base/pool_handle.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <limits>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace saccade {
namespace {

const std::thread::id main_thread = std::this_thread::get_id();

TEST(TilePool, RunsEveryPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    TilePool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    const PoolHandle handle(pool);
    for (const int count : {0, 1, 2, 1000}) {
      std::vector<std::atomic<int>> runs(count);
      handle.run(count, [&](int i) { ++runs[i]; });
      for (const auto& n : runs) ASSERT_EQ(n, 1);
    }
  }
}

TEST(TilePool, ThrowsWhatAPieceThrewOnceAllAreDone) {
  TilePool workers(2);
  const PoolHandle pool(workers);
  std::atomic<int> runs = 0;
  const auto piece = [&](int i) {
    ++runs;
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(pool.run(100, piece), std::runtime_error);
  EXPECT_EQ(runs, 100);
  pool.run(3, piece);  // the workers live
}

TEST(TilePool, TheCallingThreadDoesAllByItself) {
  TilePool own{CallingThread{}};
  EXPECT_EQ(own.threads(), 1);
  const PoolHandle pool(own);
  std::vector<int> order;
  pool.run(5, [&](int i) {
    EXPECT_EQ(std::this_thread::get_id(), main_thread);
    order.push_back(i);
    if (i == 1) pool.run(1, [&](int) { order.push_back(-1); });  // which another pool could not
  });
  EXPECT_EQ(order, (std::vector<int>{0, 1, -1, 2, 3, 4}));
  int runs = 0;
  const auto piece = [&](int i) {
    ++runs;
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(pool.run(10, piece), std::runtime_error);
  EXPECT_EQ(runs, 10);
  std::stop_source stop;
  runs = 0;
  EXPECT_THROW(PoolHandle(own, Priority::kNormal, stop.get_token())
                   .run(10,
                        [&](int) {
                          ++runs;
                          stop.request_stop();
                        }),
               Cancelled);
  EXPECT_EQ(runs, 1);
}

TEST(TilePool, TilesCoverThePictureOnce) {
  TilePool workers(2);
  const PoolHandle pool(workers);
  for (const auto& [width, height] : {std::pair(1, 1), {32, 32}, {33, 64}, {100, 31}}) {
    std::vector<std::atomic<int>> hits(width * height);
    pool.forEachTile(width, height, 32, [&hits, width = width](Tile t) {
      for (int y = t.y0; y < t.y1; ++y) {
        for (int x = t.x0; x < t.x1; ++x) ++hits[y * width + x];
      }
    });
    for (const auto& n : hits) ASSERT_EQ(n, 1) << width << "x" << height;
  }
}

TEST(TilePool, RowsAreEachVisitedOnce) {
  TilePool workers(2);
  const PoolHandle pool(workers);
  std::vector<std::atomic<int>> hits(29);
  pool.forEachRow(29, [&](int y) { ++hits[y]; });
  for (const auto& n : hits) EXPECT_EQ(n, 1);
}

// A job whose pieces wait for another job to begin: a pool that worked through one job before the next would
// hang.
TEST(TilePool, OpenJobsShareTheWorkers) {
  TilePool workers(2);
  const PoolHandle pool(workers);
  std::latch both(2);
  auto meet = [&](int) { both.arrive_and_wait(); };
  std::thread other([&] { pool.run(1, meet); });
  pool.run(1, meet);
  other.join();
}

// While others keep the only worker busy: pieces taken in turn would stand between the urgent ones.
TEST(TilePool, UrgentJobsGoFirst) {
  TilePool workers(1);
  const PoolHandle pool(workers), urgent(workers, Priority::kUrgent);
  std::latch begun(1);
  std::atomic<bool> done = false;
  std::string order;  // the worker's alone
  const auto keepBusy = [&] {
    while (!done) {
      pool.run(100, [&](int) {
        if (!begun.try_wait()) begun.count_down();
        order += '.';
      });
    }
  };
  std::thread one(keepBusy), other(keepBusy);
  begun.wait();
  urgent.run(5, [&](int) { order += 'u'; });
  done = true;
  one.join(), other.join();
  EXPECT_NE(order.find("uuuuu"), std::string::npos);
}

// The only worker is at a piece that ends once the urgent ones are done.
TEST(TilePool, UrgentJobsGoBetweenTheStepsOfALongPiece) {
  TilePool workers(1);
  const PoolHandle pool(workers), urgent(workers, Priority::kUrgent);
  std::atomic<int> done = 0;
  std::latch begun(1);
  const auto work = [] {
    volatile double sum = 0;
    for (int i = 0; i < 200'000; ++i) sum = sum + i;
  };
  std::chrono::nanoseconds long_piece, urgent_pieces;
  std::thread other([&] {
    long_piece = pool.run(1, [&](int) {
      begun.count_down();
      while (done < 30) {
        std::this_thread::sleep_for(std::chrono::microseconds(100));  // it takes hardly any time itself
        TilePool::yieldToHighPriority();
      }
    });
  });
  begun.wait();
  EXPECT_THROW(urgent.run(1, [](int) { throw std::runtime_error("one"); }), std::runtime_error);
  urgent_pieces = urgent.run(30, [&](int) {
    TilePool::yieldToHighPriority();  // is one: nothing goes before it
    work();
    ++done;
  });
  other.join();
  EXPECT_GT(urgent_pieces.count(), 0);
  EXPECT_LT(long_piece, urgent_pieces);  // each is charged its own time
}

TEST(TilePool, AStoppedJobDropsThePiecesThatAreLeft) {
  TilePool workers(2);
  std::stop_source stop;
  const PoolHandle pool(workers), stoppable(workers, Priority::kNormal, stop.get_token());
  std::atomic<int> pieces = 0;
  const auto stop_at_once = [&](int) {
    ++pieces;
    stop.request_stop();
  };
  EXPECT_THROW(stoppable.run(1000, stop_at_once), Cancelled);
  EXPECT_LE(pieces, 3);  // two that were in work, and the one that found out
  EXPECT_THROW(stoppable.run(1000, [&](int) { ++pieces; }), Cancelled);
  EXPECT_LE(pieces, 4);
  pool.run(10, [&](int) { pieces += 10; });
  EXPECT_GE(pieces, 100);
}

TEST(TilePool, ManyCallersEachGetTheirOwnResult) {
  TilePool workers(3);
  const PoolHandle pool(workers);
  std::vector<std::thread> callers;
  std::vector<long> sums(8);
  for (int c = 0; c < 8; ++c) {
    callers.emplace_back([&, c] {
      for (int round = 0; round < 50; ++round) {
        std::atomic<long> sum = 0;
        pool.run(20, [&](int i) { sum += i * c; });
        sums[c] += sum;
      }
    });
  }
  for (auto& caller : callers) caller.join();
  for (int c = 0; c < 8; ++c) EXPECT_EQ(sums[c], 50L * 190 * c);
}

TEST(TilePool, CountsCpuTimeOfAllWorkers) {
  TilePool workers(2);
  const PoolHandle pool(workers);
  std::atomic<long> steps = 0;
  auto work = [&](int) {
    for (int i = 0; i < 200'000; ++i) steps.fetch_add(1, std::memory_order_relaxed);
  };
  const auto one = pool.run(1, work), many = pool.run(64, work);
  EXPECT_GT(one.count(), 0);
  EXPECT_GT(many, 8 * one);
}

TEST(TilePool, WorkersFlushDenormals) {
  TilePool workers(1);
  const PoolHandle pool(workers);
  volatile float tiny = std::numeric_limits<float>::min();
  float half = 1;
  pool.run(1, [&](int) { half = tiny * 0.5f; });
  EXPECT_EQ(half, 0);
}

}  // namespace
}  // namespace saccade
