#pragma once

#include <cstddef>
#include <new>

// As in lanes.hpp, templates only: compiled once per instruction set.

namespace skylut::transfer {

/// Aligned array of lane registers (or structs of them), zero when made.
template <class V>
class LaneArray {
 public:
  explicit LaneArray(std::size_t size)
      : data_(static_cast<V*>(::operator new (size * sizeof(V), std::align_val_t{alignof(V)}))), size_(size) {
    fill(V{});
  }
  ~LaneArray() { ::operator delete (data_, std::align_val_t{alignof(V)}); }
  LaneArray(LaneArray&& from) noexcept : data_(from.data_), size_(from.size_) { from.data_ = nullptr; }
  LaneArray(const LaneArray&) = delete;
  LaneArray& operator=(const LaneArray&) = delete;
  LaneArray& operator=(LaneArray&&) = delete;

  V* data() { return data_; }
  const V* data() const { return data_; }
  std::size_t size() const { return size_; }
  void copy(const LaneArray& from) {
    for (std::size_t i = 0; i < size_; ++i) data_[i] = from.data_[i];
  }
  void fill(V value) {
    for (std::size_t i = 0; i < size_; ++i) data_[i] = value;
  }

 private:
  V* data_;
  std::size_t size_;
};

}  // namespace skylut::transfer
