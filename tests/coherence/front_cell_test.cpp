// Cells of a traversal: the way from the whole to a pair of nodes, and what each on it holds.
#include "engine/snch/front_cell.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/models.h"
#include "tests/support/random_poses.h"

namespace palpate {
namespace {

constexpr std::uint64_t kSeed = 9;

class FrontCells : public testing::Test {
 protected:
  std::shared_ptr<const Model> a_ = asset_model("torus"), b_ = asset_model("teapot_5600", 0.3);
  Placement placement_{a_->mesh().frame, b_->mesh().frame, Pose{DMat3(1.0), DVec3(0.0)}};
  NodeBatch batch_{a_->tree(), b_->tree(), placement_, 0.01};
  Random random_{kSeed};

  // Beneath it there are no cells: two leaves, or a leaf that is opened into its features.
  bool is_lowest(const NodePair& pair) const {
    const PackedNode &a = a_->tree().packed(pair.a), &b = b_->tree().packed(pair.b);
    return (a.is_leaf() && b.is_leaf()) || batch_.opens_features(a, b);
  }

  std::vector<NodePair> children(const NodePair& pair) const {
    const PackedNode &a = a_->tree().packed(pair.a), &b = b_->tree().packed(pair.b);
    if (batch_.opens_first(a, b)) return {{pair.a + 1, pair.b}, {a.second_child(), pair.b}};
    return {{pair.a, pair.b + 1}, {pair.a, b.second_child()}};
  }

  // Pairs that a traversal opens one after another, down to the lowest.
  std::vector<NodePair> way_down() {
    std::vector<NodePair> way{{0, 0}};
    while (!is_lowest(way.back())) way.push_back(children(way.back())[random_.below(2)]);
    return way;
  }

  CellsAbove above(const NodePair& pair) const { return {batch_, a_->tree(), b_->tree(), pair}; }
};

bool same(const NodePair& one, const NodePair& other) {
  return one.a == other.a && one.b == other.b;
}

TEST_F(FrontCells, AreThoseOnTheWayFromTheWhole) {
  for (int i = 0; i < 200; ++i) {
    const std::vector<NodePair> way = way_down();
    const CellsAbove cells = above(way.back());
    ASSERT_EQ(cells.levels(), std::min(way.size(), CellsAbove::kMostLevels));
    for (std::size_t up = 0; up < cells.levels(); ++up)
      ASSERT_TRUE(same(cells[up].root, way[way.size() - 1 - up])) << "seed " << kSeed << " way " << i;
  }
}

// A pair is in the cell of another if the traversal comes to it by that one.
TEST_F(FrontCells, HoldWhatIsOpenedBeneathThem) {
  for (int i = 0; i < 200; ++i) {
    const std::vector<NodePair> way = way_down(), other = way_down();
    const CellsAbove cells = above(way.back());
    for (std::size_t up = 0; up < cells.levels(); ++up) {
      const std::size_t level = way.size() - 1 - up;
      for (std::size_t k = 0; k < other.size(); ++k) {
        const bool beneath = k >= level && level < other.size() && same(other[level], way[level]);
        ASSERT_EQ(cells[up].holds(other[k]), beneath) << "seed " << kSeed << " ways " << i;
      }
    }
  }
}

}  // namespace
}  // namespace palpate
