// Wide tests of node pairs: every instruction set gives the same bits, and a pair's lane does not matter.
#include "engine/snch/node_batch.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdio>
#include <optional>
#include <vector>

#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 4711;

struct Outcome {
  std::vector<bool> minimum;
  std::vector<bool> contact;
  std::vector<float> distance;
  std::vector<float> angle;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

constexpr double kCutoff = 0.02;  // of the normalised frame

// The pairs that a search visits, and as many at random.
class NodeBatchTest : public testing::Test {
 protected:
  NodeBatchTest() {
    Random random(kSeed);
    const Pose pose = place_near(*a_, *b_, 0.3 * kCutoff * a_->mesh().frame.scale, random);
    placement_.emplace(a_->mesh().frame, b_->mesh().frame, pose);
    NodeBatch batch(a_->tree(), b_->tree(), *placement_, kCutoff);
    pairs_.push_back({0, 0});
    for (std::size_t next = 0; next < pairs_.size(); ++next) visit(batch, pairs_[next]);
    for (std::size_t visited = pairs_.size(); visited > 0; --visited)
      pairs_.push_back({random.below(a_->tree().node_count()), random.below(b_->tree().node_count())});
  }
  ~NodeBatchTest() override { hwy::SetSupportedTargetsForTest(0); }

  void visit(NodeBatch& batch, NodePair pair) {
    NodeBatch::Verdicts verdicts;
    batch.judge({&pair, 1}, verdicts);
    const PackedNode &a = a_->tree().packed(pair.a), &b = b_->tree().packed(pair.b);
    if ((!verdicts[0].minimum && !verdicts[0].contact) || (a.is_leaf() && b.is_leaf())) return;
    if (batch.opens_first(a, b)) {
      pairs_.insert(pairs_.end(), {{pair.a + 1, pair.b}, {a.second_child(), pair.b}});
    } else {
      pairs_.insert(pairs_.end(), {{pair.a, pair.b + 1}, {pair.a, b.second_child()}});
    }
  }

  // All pairs, `count` at a time.
  Outcome test_all(std::size_t count) const {
    NodeBatch batch(a_->tree(), b_->tree(), *placement_, kCutoff);
    const MotionRate rate{3e-4, 2e-4};
    Outcome outcome;
    for (std::size_t first = 0; first < pairs_.size(); first += count) {
      const std::size_t here = std::min(count, pairs_.size() - first);
      NodeBatch::Verdicts verdicts;
      NodeBatch::Certificates certificates;
      batch.judge({pairs_.data() + first, here}, verdicts);
      batch.certify({pairs_.data() + first, here}, rate, 0.7, certificates);
      for (std::size_t i = 0; i < here; ++i) {
        outcome.minimum.push_back(verdicts[i].minimum);
        outcome.contact.push_back(verdicts[i].contact);
        outcome.distance.push_back(certificates.distance[i]);
        outcome.angle.push_back(certificates.angle[i]);
      }
    }
    return outcome;
  }

  std::shared_ptr<const Model> a_ = asset_model("crankshaft_45k"), b_ = asset_model("gear_6k", 0.5);
  std::optional<Placement> placement_;
  std::vector<NodePair> pairs_;
};

TEST_F(NodeBatchTest, EveryInstructionSetGivesTheSameBits) {
  const Outcome reference = test_all(NodeBatch::kMost);
  int tested = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    EXPECT_EQ(test_all(NodeBatch::kMost), reference) << hwy::TargetName(target);
    std::printf("%s\n", hwy::TargetName(target));
    ++tested;
  }
  EXPECT_GE(tested, 1);
}

TEST_F(NodeBatchTest, ALaneKnowsNothingOfTheOthers) {
  const Outcome reference = test_all(NodeBatch::kMost);
  EXPECT_EQ(test_all(1), reference);
  EXPECT_EQ(test_all(5), reference);
}

// What may touch has no certificate.
TEST_F(NodeBatchTest, CertifiesNothingThatMayTouch) {
  const Outcome outcome = test_all(NodeBatch::kMost);
  std::size_t holding = 0, certified = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const bool certificate = outcome.distance[i] > 0 && outcome.angle[i] > 0;
    holding += outcome.minimum[i] || outcome.contact[i];
    certified += certificate;
    if (outcome.contact[i]) {
      EXPECT_FALSE(certificate);
    }
  }
  EXPECT_GT(holding, 100u);
  EXPECT_GT(certified, 1000u);
}

}  // namespace
}  // namespace palpate
