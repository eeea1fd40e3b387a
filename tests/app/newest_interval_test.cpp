#include "app/streams/newest_interval.h"

#include <gtest/gtest.h>

#include "app/interval_of.h"
#include "base/counting_new.h"

namespace saccade {
namespace {

class Newest : public testing::Test {
 protected:
  // Keeps what it is told.
  NewestInterval::Answer keep() {
    return [this](const NewestInterval::Copy& copy) { answers_.push_back(copy); };
  }
  void render(FrameIndex frame) {
    newest_.beginFrame();
    change_ = intervalOf(frame, 1, 0.5f);
    feed_.copyFrom(*change_);
    newest_.endFrame(feed_);
  }

  std::unique_ptr<IntensityChange> change_;
  IntensityChange feed_{kWidth, kHeight};
  NewestInterval newest_;
  std::vector<NewestInterval::Copy> answers_;
};

TEST_F(Newest, IsNothingBeforeTheFirstFrame) {
  newest_.ask(keep());
  ASSERT_EQ(answers_.size(), 1u);
  EXPECT_EQ(answers_[0], nullptr);
}

TEST_F(Newest, IsACopyThatLaterFramesLeaveAlone) {
  render(1);
  newest_.ask(keep());
  render(2);
  newest_.ask(keep());
  ASSERT_EQ(answers_.size(), 2u);
  EXPECT_EQ(answers_[0]->frame, 1u);
  EXPECT_EQ(answers_[0]->I_now.at(3, 2), change_->I_now.at(3, 2));
  EXPECT_EQ(answers_[1]->frame, 2u);
}

TEST_F(Newest, IsTheFrameThatIsRenderedNow) {
  render(1);
  newest_.beginFrame();
  newest_.ask(keep());
  newest_.ask(keep());
  EXPECT_TRUE(answers_.empty());
  feed_.frame = 2;
  newest_.endFrame(feed_);
  ASSERT_EQ(answers_.size(), 2u);
  EXPECT_EQ(answers_[0]->frame, 2u);
  EXPECT_EQ(answers_[0], answers_[1]);  // one copy serves both
}

TEST_F(Newest, IsNothingWhereTheFeedEndsAmidAFrame) {
  render(1);
  newest_.beginFrame();
  newest_.ask(keep());
  newest_.endFeed();
  newest_.ask(keep());
  EXPECT_EQ(answers_, (std::vector<NewestInterval::Copy>{nullptr, nullptr}));
}

TEST_F(Newest, OutlivesAFeedThatEndsBetweenFrames) {
  render(1);
  newest_.endFeed();
  newest_.ask(keep());
  ASSERT_EQ(answers_.size(), 1u);
  EXPECT_EQ(answers_[0]->frame, 1u);
}

TEST_F(Newest, IsNotCopiedUnlessSomebodyAsks) {
  const int before = test::allocations();
  newest_.beginFrame();
  newest_.endFrame(feed_);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace saccade
