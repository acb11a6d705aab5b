#pragma once

#include <cstddef>
#include <functional>

#include "skylut/core/context.hpp"

namespace skylut {

/// Draws the frames of a series. Where frames are many and small, several are drawn at a time, one on each
/// thread; else one after the other, each on all threads. No more frames are under way than there are
/// threads: memory does not grow with their number. Progress says "frames", or which frame with what is being
/// done for it.
/// @param small  whether a frame has too little work for all threads, and memory has room for one on each
/// @param draw   called once with every index from 0 to count - 1 and the context to draw in; may be called
/// from
///               several threads
/// @throws       what draw throws first; Cancelled if context.cancel was asked
void for_frames(const Context& context, std::size_t count, bool small,
                const std::function<void(const Context& context, std::size_t frame)>& draw);

}  // namespace skylut
