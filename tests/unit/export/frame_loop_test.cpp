#include "skylut/export/frame_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Whether frames are small and many or not, each is drawn once, and no more at a time than there are threads.
TEST(FrameLoop, DrawsEveryFrameOnce) {
  for (const bool small : {false, true})
    for (const std::size_t count : {1u, 2u, 50u}) {
      std::vector<std::atomic<int>> drawn(count);
      std::atomic<int> at_a_time = 0;
      std::atomic<int> most = 0;
      for_frames(test::on_threads(3), count, small, [&](const Context& context, std::size_t frame) {
        most = std::max(most.load(), ++at_a_time);
        EXPECT_EQ(context.threads, small && count == 50 ? 1 : 3);
        ++drawn[frame];
        --at_a_time;
      });
      EXPECT_TRUE(std::all_of(drawn.begin(), drawn.end(), [](const auto& times) { return times == 1; }));
      EXPECT_LE(most, small ? 3 : 1);
    }
}

TEST(FrameLoop, ProgressSaysWhichFrame) {
  Context context = test::on_threads(1);
  std::vector<std::string> seen;
  context.progress = [&](std::string_view stage, std::size_t done, std::size_t all) {
    seen.push_back(std::string(stage) + " " + std::to_string(done) + "/" + std::to_string(all));
  };
  for_frames(context, 2, false,
             [](const Context& of_frame, std::size_t) { of_frame.progress("picture", 3, 4); });
  EXPECT_EQ(seen, (std::vector<std::string>{"frame 1 of 2, picture 3/4", "frame 2 of 2, picture 3/4"}));
  seen.clear();
  for_frames(context, 2, true, [](const Context& of_frame, std::size_t) { EXPECT_FALSE(of_frame.progress); });
  EXPECT_EQ(seen, (std::vector<std::string>{"frames 1/2", "frames 2/2"}));
}

TEST(FrameLoop, StopsWhenAskedTo) {
  std::stop_source stop;
  for (const bool small : {false, true}) {
    Context context = test::on_threads(1);
    context.cancel = stop.get_token();
    std::size_t drawn = 0;
    const auto draw = [&](const Context&, std::size_t) {
      if (++drawn == 2) stop.request_stop();
    };
    EXPECT_THROW(for_frames(context, 5, small, draw), Cancelled);
    EXPECT_EQ(drawn, 2u);
    stop = {};
  }
}

}  // namespace
}  // namespace skylut
