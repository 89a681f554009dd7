#include "engine/snch/front_list.h"

// Compiled once for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/snch/front_list.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using Words = hn::RebindToUnsigned<Lanes>;

std::uint64_t bits_of(hn::Mask<Words> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Words(), mask, bytes);
  return bytes[0] | std::uint64_t{bytes[1]} << 8;
}

// A bit for each of `blocks` blocks of entries: whether its certificate has passed.
void mark_passed(const float* distance, const float* angle, std::size_t blocks, float now_distance,
                 float now_angle, std::uint64_t* marks) {
  const auto distance_now = hn::Set(Lanes(), now_distance), angle_now = hn::Set(Lanes(), now_angle);
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < FrontList::kBlock; lane += hn::Lanes(Lanes())) {
      const std::size_t i = block * FrontList::kBlock + lane;
      const auto holds = hn::And(hn::Lt(distance_now, hn::LoadU(Lanes(), distance + i)),
                                 hn::Lt(angle_now, hn::LoadU(Lanes(), angle + i)));
      bits |= bits_of(hn::RebindMask(Words(), holds)) << lane;
    }
    marks[block] = ~bits;
  }
}

// The same: whether a cell holds it.
void mark_held(const std::uint32_t* a, const std::uint32_t* b, std::size_t blocks, const FrontCell& cell,
               std::uint64_t* marks) {
  const auto nodes = hn::Set(Words(), FeatureNode::kMostNodes - 1);
  const auto root_a = hn::Set(Words(), cell.root.a), root_b = hn::Set(Words(), cell.root.b);
  const auto size_a = hn::Set(Words(), cell.end_a - cell.root.a),
             size_b = hn::Set(Words(), cell.end_b - cell.root.b);
  for (std::size_t block = 0; block < blocks; ++block) {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < FrontList::kBlock; lane += hn::Lanes(Words())) {
      const std::size_t i = block * FrontList::kBlock + lane;
      const auto in_a = hn::Sub(hn::And(hn::LoadU(Words(), a + i), nodes), root_a);
      const auto in_b = hn::Sub(hn::And(hn::LoadU(Words(), b + i), nodes), root_b);
      bits |= bits_of(hn::And(hn::Lt(in_a, size_a), hn::Lt(in_b, size_b))) << lane;
    }
    marks[block] = bits;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <bit>

namespace palpate {
namespace {

HWY_EXPORT(mark_passed);
HWY_EXPORT(mark_held);

}  // namespace

void FrontList::reserve(std::size_t room) {
  if (room <= capacity()) return;
  const std::size_t blocks = room / kBlock + 1;
  marks_.resize(blocks);
  for (auto* nodes : {&a_, &b_}) nodes->resize(blocks * kBlock);
  for (auto* until : {&distance_, &angle_}) until->resize(blocks * kBlock);
}

void FrontList::add(const NodePair& pair, const Until& until) {
  if (size_ == capacity()) reserve(std::max<std::size_t>(2 * size_, 64));
  a_[size_] = pair.a;
  b_[size_] = pair.b;
  set_until(size_++, until);
}

void FrontList::remove(std::size_t i) {
  --size_;
  a_[i] = a_[size_];
  b_[i] = b_[size_];
  set_until(i, until(size_));
}

void FrontList::find_passed(const Until& now, std::vector<std::uint32_t>& found) {
  HWY_DYNAMIC_DISPATCH(mark_passed)
  (distance_.data(), angle_.data(), blocks(), now.distance, now.angle, marks_.data());
  list_marked(found);
}

void FrontList::find_held(const FrontCell& cell, std::vector<std::uint32_t>& found) {
  mark_held(cell);
  list_marked(found);
}

std::size_t FrontList::count_held(const FrontCell& cell) {
  mark_held(cell);
  clear_marks_behind();
  std::size_t count = 0;
  for (std::size_t block = 0; block < blocks(); ++block)
    count += static_cast<std::size_t>(std::popcount(marks_[block]));
  return count;
}

void FrontList::mark_held(const FrontCell& cell) {
  HWY_DYNAMIC_DISPATCH(mark_held)(a_.data(), b_.data(), blocks(), cell, marks_.data());
}

// The last block is not full.
void FrontList::clear_marks_behind() {
  if (size_ % kBlock != 0) marks_[blocks() - 1] &= (std::uint64_t{1} << size_ % kBlock) - 1;
}

void FrontList::list_marked(std::vector<std::uint32_t>& found) {
  found.clear();
  clear_marks_behind();
  for (std::size_t block = 0; block < blocks(); ++block)
    for (std::uint64_t left = marks_[block]; left != 0; left &= left - 1)
      found.push_back(static_cast<std::uint32_t>(block * kBlock) +
                      static_cast<std::uint32_t>(std::countr_zero(left)));
}

void FrontList::set_back(const Readings& readings) {
  for (std::size_t i = 0; i < size_; ++i) set_until(i, readings.set_back(until(i)));
}

}  // namespace palpate
#endif
