#include <hwy/targets.h>

#include <string>
#include <vector>

#include "engine/base/clock.h"
#include "engine/kernel/triangle_batch.h"
#include "engine/snch/node_batch.h"
#include "tests/bench/benches.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate::bench {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kBatches = 64;
constexpr int kRepetitions = 500;

Triangle random_triangle(const DVec3& offset, Random& random) {
  Triangle triangle;
  for (DVec3& corner : triangle.corner)
    for (int axis = 0; axis < 3; ++axis) corner[axis] = offset[axis] + random.uniform(-1.0, 1.0);
  return triangle;
}

// Pairs of triangles, near and far, in both forms.
struct TrianglePairs {
  std::vector<Triangle> first, second;
  std::vector<TriangleBatch> batches = std::vector<TriangleBatch>(kBatches);

  explicit TrianglePairs(Random& random) {
    for (TriangleBatch& batch : batches) {
      for (std::size_t column = 0; column < TriangleBatch::kMost; ++column) {
        first.push_back(random_triangle(DVec3(0.0), random));
        second.push_back(random_triangle(random.uniform(0.0, 5.0) * random.direction(), random));
        batch.first.set(column, first.back(), first.back().corner[0]);
        batch.second.set(column, second.back(), first.back().corner[0]);
      }
    }
  }
};

// Nanoseconds a pair of something that is done with `pairs` of them at a time.
template <class Run>
Series ns_a_pair(std::size_t pairs, const Run& run) {
  Series series;
  for (int i = 0; i < kRepetitions; ++i) {
    const Stopwatch watch;
    run();
    series.add(1e3 * watch.elapsed_us() / static_cast<double>(pairs));
  }
  return series;
}

class Kernels {
 public:
  explicit Kernels(Table& table) : table_(table) {}

  void measure_triangles() {
    double sum = 0.0;  // so that nothing is left out
    TriangleBatch::Closest closest;
    add("triangle_batch", ns_a_pair(kBatches * TriangleBatch::kMost, [&] {
          for (const TriangleBatch& batch : triangles_.batches) {
            batch.measure(TriangleBatch::kMost, closest);
            sum += double{closest.squared_distance[0]};
          }
        }));
    sink_ = sum;
  }

  // Nodes of every depth, as a traversal meets them.
  void measure_nodes() {
    const Placement placement(model_->mesh().frame, model_->mesh().frame, Pose{});
    NodeBatch batch(model_->tree(), model_->tree(), placement, 0.02);
    std::vector<NodePair> pairs(kBatches * NodeBatch::kMost);
    const std::size_t nodes = model_->tree().node_count();
    for (NodePair& pair : pairs) pair = {random_.below(nodes), random_.below(nodes)};
    NodeBatch::Verdicts verdicts;
    NodeBatch::Certificates certificates;
    const auto for_each_batch = [&](const auto& run) {
      for (std::size_t first = 0; first < pairs.size(); first += NodeBatch::kMost)
        run(std::span<const NodePair>(pairs).subspan(first, NodeBatch::kMost));
    };
    add("node_judge",
        ns_a_pair(pairs.size(), [&] { for_each_batch([&](auto some) { batch.judge(some, verdicts); }); }));
    add("node_certify", ns_a_pair(pairs.size(), [&] {
          for_each_batch([&](auto some) { batch.certify(some, MotionRate(), 1.0, certificates); });
        }));
  }

  void measure_scalar() {
    simd_ = "none";
    double sum = 0.0;
    add("closest_points", ns_a_pair(triangles_.first.size(), [&] {
          for (std::size_t i = 0; i < triangles_.first.size(); ++i)
            sum += closest_points(triangles_.first[i], triangles_.second[i]).squared_distance;
        }));
    sink_ = sum;
  }

  void use(const char* simd) { simd_ = simd; }

 private:
  void add(const std::string& method, const Series& ns) {
    table_.say("kernels: " + method + ", " + simd_ + ": " + std::to_string(ns.percentile(0.5)) +
               " ns a pair");
    table_.add({"kernels", "random", method, "a pair's outcome", "target=" + simd_, "time_per_pair", "ns"},
               ns);
  }

  Table& table_;
  Random random_{kSeed};
  TrianglePairs triangles_{random_};
  std::shared_ptr<const Model> model_ = asset_model("organic_97k");
  std::string simd_;
  volatile double sink_ = 0.0;
};

}  // namespace

void bench_kernels(const Effort&, Table& table) {
  Kernels kernels(table);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    kernels.use(hwy::TargetName(target));
    kernels.measure_triangles();
    kernels.measure_nodes();
  }
  hwy::SetSupportedTargetsForTest(0);
  kernels.measure_scalar();
}

}  // namespace palpate::bench
