// Bodies are skipped in groups, and none that may be near is skipped with its group.
#include <gtest/gtest.h>

#include <map>

#include "engine/scene/body_table.h"
#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 811;

// A table, and beside it until where each of its bodies is far.
class BodyTableTest : public testing::Test {
 protected:
  void add() {
    BodyOptions options;
    options.model = model_;
    const BodyId id = table_.add(Body(std::move(options)));
    ASSERT_NE(id, 0u);
    far_until_[id] = 0.0;
  }

  BodyId any() { return std::next(far_until_.begin(), random_.below(far_until_.size()))->first; }

  void remove_any() {
    const BodyId id = any();
    ASSERT_TRUE(table_.remove(id));
    far_until_.erase(id);
  }

  void move_any() {
    const BodyId id = any();
    ASSERT_TRUE(table_.set_pose(id, Pose{}));
    far_until_[id] = 0.0;
  }

  void forget_far() {
    table_.forget_far();
    for (auto& [id, until] : far_until_) until = 0.0;
  }

  // Each body that may be near is visited once, and no other.
  void visit_near() {
    std::size_t may_be_near = 0, visited = 0;
    for (const auto& [id, until] : far_until_) may_be_near += until <= way_;
    table_.for_each_near(way_, [&](BodyId id, Body&) {
      double& until = far_until_.at(id);
      EXPECT_LE(until, way_) << "seed " << kSeed;
      until = random_.below(20) == 0 ? 0.0 : way_ + random_.uniform(0.0, 30.0);
      ++visited;
      return until;
    });
    ASSERT_EQ(visited, may_be_near) << "seed " << kSeed;
  }

  std::shared_ptr<const Model> model_ = asset_model("tetrahedron");
  Random random_{kSeed};
  BodyTable table_;
  std::map<BodyId, double> far_until_;
  double way_ = 0.0;
};

TEST_F(BodyTableTest, VisitsThoseThatMayBeNear) {
  for (int i = 0; i < 500; ++i) add();
  for (int tick = 0; tick < 5000; ++tick) {
    way_ += random_.uniform(0.0, 0.2);
    switch (random_.below(40)) {
      case 0:
        add();
        break;
      case 1:
        remove_any();
        break;
      case 2:
        move_any();
        break;
      case 3:
        if (random_.below(20) == 0) forget_far();
        break;
      default:
        break;
    }
    visit_near();
  }
}

}  // namespace
}  // namespace palpate
