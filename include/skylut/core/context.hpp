#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace skylut {

/// Instruction set of the transfer solver's kernels.
enum class Simd {
  best,       ///< the widest that this machine can run
  portable,   ///< 4 lanes without machine-specific instructions; the same bytes on every machine of a kind
  avx2,       ///< 8 lanes (x86-64 with FMA)
  avx512,     ///< 16 lanes; the same bytes as avx2
  reference,  ///< one column at a time in double precision: what the others are judged by; slow
};

/// What a computation needs of the world around it. Passed in by the caller: the library reads no environment
/// variable and keeps nothing for the whole process, so that two contexts may be at work side by side.
struct Context {
  /// Folder with the profiles and data tables that come with skylut.
  std::filesystem::path data_folder = default_data_folder();
  /// Where results of Mie's theory are kept from run to run; empty: nowhere.
  std::filesystem::path cache_folder;
  Simd simd = Simd::best;
  int threads = 0;  ///< 0: one per core. No result depends on it.
  /// Called with what is being done, how much of it is done and how much there is; from any thread, one call
  /// at a time; may be empty.
  std::function<void(std::string_view stage, std::size_t done, std::size_t all)> progress;
  std::stop_token cancel;  ///< a request to stop ends long work with Cancelled

  /// Path of one file below the data folder. @throws WorkError if it does not exist
  std::filesystem::path data_file(const std::string& relative_path) const;

  /// The data of the installed library; where that was never installed, of the source tree it was built from.
  static std::filesystem::path default_data_folder();
};

}  // namespace skylut
