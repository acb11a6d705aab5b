#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "skylut/transfer/transfer_cost.hpp"

namespace skylut {

double machine_memory_bytes() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  // Containers: version 2 and version 1 of Linux's control groups. "max" is no number: no limit.
  for (const char* path : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::ifstream file(path);
    double limit = 0.0;
    if (file >> limit && limit > 0.0) bytes = std::min(bytes, limit);
  }
  return bytes;
}

}  // namespace skylut
