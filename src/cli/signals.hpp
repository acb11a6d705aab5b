#pragma once

namespace skylut::cli {

/// From now on a signal that ends the program first removes the files it was writing; the exit code is 128
/// plus the signal's number, as shells report it. A signal that was ignored when the program began stays so
/// (nohup).
void end_cleanly_on_signals();

}  // namespace skylut::cli
