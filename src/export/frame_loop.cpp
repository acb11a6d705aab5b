#include "skylut/export/frame_loop.hpp"

#include <fmt/format.h>

#include <mutex>

#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"

namespace skylut {

void for_frames(const Context& context, std::size_t count, bool small,
                const std::function<void(const Context& context, std::size_t frame)>& draw) {
  const auto draw_unless_cancelled = [&](const Context& of_frame, std::size_t frame) {
    if (context.cancel.stop_requested()) throw Cancelled();
    draw(of_frame, frame);
  };
  Context of_frame = context;
  if (small && count >= static_cast<std::size_t>(thread_count(context.threads))) {
    of_frame.threads = 1;
    of_frame.progress = nullptr;
    std::mutex one_call;
    std::size_t done = 0;
    parallel_for(count, context.threads, [&](std::size_t frame) {
      draw_unless_cancelled(of_frame, frame);
      const std::lock_guard lock(one_call);
      ++done;
      if (context.progress) context.progress("frames", done, count);
    });
    return;
  }
  for (std::size_t frame = 0; frame < count; ++frame) {
    if (context.progress)
      of_frame.progress = [&](std::string_view stage, std::size_t done, std::size_t all) {
        context.progress(fmt::format("frame {} of {}, {}", frame + 1, count, stage), done, all);
      };
    draw_unless_cancelled(of_frame, frame);
  }
}

}  // namespace skylut
