#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/snch/front_cell.h"
#include "engine/snch/node_batch.h"
#include "engine/snch/until.h"

namespace palpate {

// Pairs of nodes, each with the reading until which it needs no test. In columns, so that scans are wide: one
// of all costs about a cycle a pair.
class FrontList {
 public:
  static constexpr std::size_t kBlock = 64;  // entries that are scanned together

  void clear() { size_ = 0; }
  void reserve(std::size_t room);
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return angle_.size(); }

  NodePair operator[](std::size_t i) const { return {a_[i], b_[i]}; }
  Until until(std::size_t i) const { return {distance_[i], angle_[i]}; }

  void add(const NodePair& pair, const Until& until);
  void set_until(std::size_t i, const Until& until) {
    distance_[i] = until.distance, angle_[i] = until.angle;
  }

  // The last takes its place.
  void remove(std::size_t i);

  // Fill `found` with the indices, ascending, of those that have passed, or that a cell holds.
  void find_passed(const Until& now, std::vector<std::uint32_t>& found);
  void find_held(const FrontCell& cell, std::vector<std::uint32_t>& found);
  std::size_t count_held(const FrontCell& cell);

  // The odometer is set back to 0.
  void set_back(const Readings& readings);

 private:
  std::size_t blocks() const { return (size_ + kBlock - 1) / kBlock; }
  void mark_held(const FrontCell& cell);
  void clear_marks_behind();
  void list_marked(std::vector<std::uint32_t>& found);

  // All of the same length: whole blocks.
  std::vector<std::uint32_t> a_;
  std::vector<std::uint32_t> b_;
  std::vector<float> distance_;
  std::vector<float> angle_;
  std::vector<std::uint64_t> marks_;  // a bit an entry
  std::size_t size_ = 0;
};

}  // namespace palpate
