#include "skylut/transfer/transfer_cost.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "sky_cases.hpp"
#include "skylut/core/errors.hpp"

namespace {

/// Memory in use through operator new, which this program counts. (Its tests are not run in parallel.)
std::atomic<long> live_bytes{0};
std::atomic<long> most_live_bytes{0};

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const long live = live_bytes += static_cast<long>(malloc_usable_size(memory));
  if (live > most_live_bytes) most_live_bytes = live;
  return memory;
}

void release(void* memory) {
  if (memory != nullptr) live_bytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto to = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(to, (size + to - 1) / to * to));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace skylut {
namespace {

const SkyRequest kRequest{{0.0}, {45.0}, {{0.0, 0.0}, {60.0, 90.0}}};

OpticalColumn cloud(double depth) {
  return {{depth}, {{std::make_shared<const HenyeyGreensteinPhaseFunction>(0.5), {0.9 * depth}}}, 0.2};
}
const Shells kOneLayer{{0.0, 10.0}, 6371.0};

TransferCost cost_of(const OpticalColumn& column, const TransferOptions& options = {}) {
  return estimate_cost(test::context, kOneLayer, std::span(&column, 1), kRequest.sights(), options);
}

/// The refusal's text, which must be one line; "" if it is solved.
std::string refusal(const Shells& shells, std::span<const OpticalColumn> columns, const SkyRequest& request,
                    const TransferOptions& options) {
  try {
    solve_sky_radiance(test::on_threads(1), shells, columns, request, options);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

void expect_says(const std::string& message, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << ": " << message;
}

// Thick layers are graded: a hundred times the depth takes some ten times the sublayers.
TEST(TransferCost, GrowsWithTheDepth) {
  const TransferCost thin = cost_of(cloud(1.0));
  const TransferCost thick = cost_of(cloud(100.0));
  const TransferCost opaque = cost_of(cloud(1e5));
  EXPECT_GT(thick.most_sublayers, 8.0 * thin.most_sublayers);
  EXPECT_LT(thick.most_sublayers, 20.0 * thin.most_sublayers);
  EXPECT_LT(opaque.most_sublayers, 6.0 * thick.most_sublayers);
  // What is kept near the horizon does not grow.
  EXPECT_GT(thick.largest_field_bytes, 5.0 * thin.largest_field_bytes);
  EXPECT_GT(thick.cpu_s, 8.0 * thin.cpu_s);
  EXPECT_EQ(thick.blocks, 1u);
}

// Depths that single precision does not hold are refused at once, in words: nothing of their size is made.
TEST(TransferCost, AbsurdDepthsAreRefusedFirst) {
  for (const double depth : {1e7, 1e12, 1e300}) {
    const OpticalColumn column = cloud(depth);
    expect_says(refusal(kOneLayer, std::span(&column, 1), kRequest, {}), {"optical depth", "at most 1e+06"});
  }
}

// The limit that the caller sets; what is named as fitting does fit.
TEST(TransferCost, NamesADepthThatFits) {
  TransferOptions options;
  options.discretisation = discretisation_of(Quality::draft);
  const OpticalColumn thick = cloud(200.0);
  options.most_memory_bytes = 0.5 * cost_of(thick, options).memory_bytes();
  const std::string message = refusal(kOneLayer, std::span(&thick, 1), kRequest, options);
  expect_says(message, {"optical depth 200", "MB may be used", "would fit"});
  const std::string before = "an optical depth of about ";
  const double fits = std::stod(message.substr(message.find(before) + before.size()));
  EXPECT_GT(fits, 2.0);
  EXPECT_LT(fits, 200.0);
  EXPECT_LE(cost_of(cloud(fits), options).memory_bytes(), options.most_memory_bytes);
}

// The same for the size of the request: a million results of 4 bytes, 100 MB of lines of sight.
TEST(TransferCost, NamesTheNumberOfResultsThatFit) {
  SkyRequest request = kRequest;
  request.views.assign(1'000'000, {30.0, 60.0});
  TransferOptions options;
  options.most_memory_bytes = 300e6;
  const OpticalColumn column = cloud(0.1);
  expect_says(refusal(kOneLayer, std::span(&column, 1), request, options),
              {"1 columns in 1000000 lines of sight", "300 MB may be used", "would fit"});
}

// Many levels need no limit of their own: their tables are part of the estimate.
TEST(TransferCost, ManyLevels) {
  Shells shells{{0.0}, 6371.0};
  OpticalColumn column;
  for (int level = 1; level <= 20'000; ++level) {
    shells.levels_km.push_back(0.005 * level);
    column.extinction_depth.push_back(1e-5);
  }
  TransferOptions options;
  options.most_memory_bytes = 4e9;
  expect_says(refusal(shells, std::span(&column, 1), kRequest, options),
              {"20001 levels", "4 GB may be used"});

  shells.levels_km.resize(401);
  column.extinction_depth.resize(400);
  EXPECT_EQ(refusal(shells, std::span(&column, 1), kRequest, {}), "");
}

// Half an hour for one block of columns: what is slow but small is refused, too.
TEST(TransferCost, TooSlow) {
  TransferOptions options;
  options.most_memory_bytes = 1e15;
  Shells shells{{0.0}, 6371.0};
  OpticalColumn column;
  column.scatterers = {{std::make_shared<const HenyeyGreensteinPhaseFunction>(0.92), {}}};
  for (int level = 1; level <= 2'000; ++level) {
    shells.levels_km.push_back(0.02 * level);
    column.extinction_depth.push_back(500.0);
    column.scatterers[0].scattering_depth.push_back(400.0);
  }
  options.discretisation = discretisation_of(Quality::reference);
  options.scattering_orders = 1'000;
  expect_says(refusal(shells, std::span(&column, 1), kRequest, options),
              {"optical depth 1e+06", "of CPU time, at most 30 min"});
}

// The estimate bounds what was taken, and not by more than a factor of two.
TEST(TransferCost, MemoryIsWhatIsTaken) {
  for (const double depth : {0.3, 20.0}) {
    TransferOptions options;
    options.discretisation = discretisation_of(Quality::draft);
    const OpticalColumn column = cloud(depth);
    const double need =
        estimate_cost(test::on_threads(1), kOneLayer, std::span(&column, 1), kRequest.sights(), options)
            .memory_bytes();
    const long before = live_bytes;
    most_live_bytes = before;
    solve_sky_radiance(test::on_threads(1), kOneLayer, std::span(&column, 1), kRequest.sights(), options);
    const auto taken = static_cast<double>(most_live_bytes - before);
    RecordProperty("estimated_over_taken", std::to_string(need / taken));
    EXPECT_LT(taken, need) << depth;
    EXPECT_GT(taken, need / 2.0) << depth;
  }
}

}  // namespace
}  // namespace skylut
