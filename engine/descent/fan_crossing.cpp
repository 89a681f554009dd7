#include "engine/descent/fan_crossing.h"

#include <algorithm>
#include <limits>

#include "engine/kernel/triangle_batch.h"

namespace palpate {
namespace {

// So many of a fan are looked at together. Fewer faces are crossed one by one.
constexpr std::size_t kSamples = TriangleBatch::kMost;

// The triangles around a vertex, or one alone, and which of them are looked at.
class Fan {
 public:
  explicit Fan(std::span<const std::uint32_t> triangles) : triangles_(triangles), end_(triangles.size()) {}

  bool is_wide() const { return triangles_.size() > 1; }
  std::size_t stride() const { return (end_ - begin_ + kSamples - 1) / kSamples; }
  std::size_t samples() const { return (end_ - begin_ + stride() - 1) / stride(); }
  std::uint32_t sample(std::size_t k) const { return triangles_[begin_ + k * stride()]; }

  // Leaves those between the samples beside sample k.
  void close_in(std::size_t k) {
    const std::size_t at = begin_ + k * stride(), reach = stride() - 1;
    begin_ = at - std::min(at, reach);
    end_ = std::min(triangles_.size(), at + reach + 1);
  }

 private:
  std::span<const std::uint32_t> triangles_;
  std::size_t begin_ = 0;
  std::size_t end_;
};

Fan widest_fan(const Mesh& mesh, const std::uint32_t& triangle) {
  std::span<const std::uint32_t> widest(&triangle, 1);
  for (std::uint32_t corner : mesh.triangles[triangle]) {
    const auto around = mesh.vertex_triangles[corner];
    if (around.size() > std::max(widest.size(), kSamples)) widest = around;
  }
  return Fan(widest);
}

// The samples of two fans, measured in single precision.
class FanPair {
 public:
  FanPair(const DescentPair& pair, Fan a, Fan b, const DVec3& origin)
      : pair_(pair), a_(a), b_(b), origin_(origin) {}

  TrianglePair closest(DescentWork& work) {
    for (;;) {
      const auto [in_a, in_b] = closest_samples(work);
      if (a_.stride() == 1 && b_.stride() == 1) return {a_.sample(in_a), b_.sample(in_b)};
      a_.close_in(in_a);
      b_.close_in(in_b);
    }
  }

 private:
  std::pair<std::size_t, std::size_t> closest_samples(DescentWork& work) {
    for (std::size_t i = 0; i < a_.samples(); ++i)
      in_a_.set(i, triangle_of(pair_.a(), a_.sample(i)), origin_);
    for (std::size_t k = 0; k < b_.samples(); ++k)
      in_b_.set(k, triangle_of(pair_.b(), b_.sample(k), pair_.placement()), origin_);
    const std::size_t columns = b_.samples(), count = a_.samples() * columns;
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t begin = 0; begin < count; begin += TriangleBatch::kMost) {
      const std::size_t end = std::min(count, begin + TriangleBatch::kMost);
      for (std::size_t i = begin; i < end; ++i) {
        batch_.first.copy(i - begin, in_a_, i / columns);
        batch_.second.copy(i - begin, in_b_, i % columns);
      }
      batch_.measure(end - begin, measured_);
      for (std::size_t i = begin; i < end; ++i)
        if (measured_.squared_distance[i - begin] < least)
          least = measured_.squared_distance[i - begin], best = i;
    }
    work.triangle_pairs += count;
    return {best / columns, best % columns};
  }

  const DescentPair& pair_;
  Fan a_;
  Fan b_;
  const DVec3 origin_;
  TriangleBatch::Triangles in_a_;
  TriangleBatch::Triangles in_b_;
  TriangleBatch batch_;
  TriangleBatch::Closest measured_;
};

}  // namespace

void cross_fans(const DescentPair& pair, DescentPoint& point, DescentWork& work) {
  const TrianglePair now = point.triangles;
  const Fan a = widest_fan(pair.a(), now.a), b = widest_fan(pair.b(), now.b);
  if (!a.is_wide() && !b.is_wide()) return;
  const TrianglePair closest = FanPair(pair, a, b, point.closest.on_first).closest(work);
  if (closest == now) return;
  const DescentPoint next = pair.measure(closest, work);
  if (is_closer(next, point)) point = next;
}

}  // namespace palpate
