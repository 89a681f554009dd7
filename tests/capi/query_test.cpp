#include <algorithm>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

class QueryTest : public testing::Test {
 protected:
  plp_contacts run(const TestModel& a, const TestModel& b, const plp_pose& pose) {
    EXPECT_EQ(plp_query(a.handle, b.handle, &pose, &options_, query_.handle), PLP_OK) << plp_last_error();
    return query_.contacts();
  }

  void SetUp() override {
    plp_query_options_init(&options_, sizeof options_);
    options_.cutoff = 0.2;
  }

  TestModel box_{box(0.5f, 0.5f, 0.5f)};
  TestModel torus_{torus(1.0, 0.25, 32, 16)};
  TestQuery query_;
  plp_query_options options_;
};

TEST_F(QueryTest, ResultStartsEmpty) {
  const plp_contacts contacts = query_.contacts();
  EXPECT_EQ(contacts.lmd_count, 0u);
  EXPECT_EQ(contacts.overlap_count, 0u);
  EXPECT_EQ(contacts.lmd_stride, sizeof(plp_lmd));
  EXPECT_EQ(contacts.overlap_stride, sizeof(plp_overlap));
  EXPECT_TRUE(std::isinf(contacts.min_distance));
}

TEST_F(QueryTest, ParallelFacesAreOneSetThatPushesOnce) {
  const plp_contacts contacts = run(box_, box_, at(1.125, 0, 0));
  ASSERT_EQ(contacts.set_count, 1u);
  double weight = 0.0;
  for (std::size_t i = 0; i < contacts.lmd_count; ++i) {
    EXPECT_DOUBLE_EQ(contacts.lmds[i].distance, 0.125);
    EXPECT_DOUBLE_EQ(contacts.lmds[i].normal[0], 1.0);
    EXPECT_EQ(contacts.lmds[i].set, 0u);
    weight += contacts.lmds[i].weight;
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
  EXPECT_NEAR(contacts.wrench.force[0], 1000.0 * (0.2 - 0.125), 1e-9);
  for (const double torque : contacts.wrench.torque) EXPECT_NEAR(torque, 0.0, 1e-9);
}

TEST_F(QueryTest, TorqueIsAboutTheReferencePointOfB) {
  options_.reference_point[1] = 0.25;
  const plp_contacts contacts = run(box_, box_, at(1.125, 0, 0));
  // r × F with r = (−, −0.25, 0) from the reference to the middle of the face.
  EXPECT_NEAR(contacts.wrench.torque[2], 0.25 * contacts.wrench.force[0], 1e-9);
}

TEST_F(QueryTest, OutOfReachSearchesNothing) {
  const plp_contacts contacts = run(box_, box_, at(1e6, 0, 0));
  EXPECT_EQ(contacts.set_count, 0u);
  EXPECT_EQ(contacts.work.bodies, 1u);
  EXPECT_EQ(contacts.work.body_pairs, 0u);
  EXPECT_EQ(contacts.work.node_pairs, 0u);
}

TEST_F(QueryTest, OverlapIsReportedAndCut) {
  options_.max_overlaps = 3;
  plp_contacts contacts = run(box_, box_, at(0.5, 0.25, 0.125));
  EXPECT_EQ(contacts.overlap, 1);
  EXPECT_EQ(contacts.overlap_count, 3u);
  EXPECT_EQ(contacts.overlaps_cut, 1);
  for (std::size_t i = 0; i < contacts.overlap_count; ++i) EXPECT_LT(contacts.overlaps[i].triangle_a, 12u);
  options_.max_overlaps = 0;
  contacts = run(box_, box_, at(0.5, 0.25, 0.125));
  EXPECT_EQ(contacts.overlap, 1) << "known without a list, too";
  EXPECT_EQ(contacts.overlap_count, 0u);
}

TEST_F(QueryTest, SymmetricInAAndB) {
  options_.cutoff = 0.4;
  // B is turned a third about (1, 1, 1), which exchanges the axes and so is exact.
  const plp_pose a_from_b = {{0.9, 0.1, 0.2}, {0.5, 0.5, 0.5, 0.5}};
  // The inverse turn takes (x, y, z) to (y, z, x).
  const plp_pose b_from_a = {{-0.1, -0.2, -0.9}, {-0.5, -0.5, -0.5, 0.5}};
  const plp_contacts forward = run(box_, torus_, a_from_b);
  std::vector<double> distances;
  for (std::size_t i = 0; i < forward.lmd_count; ++i) distances.push_back(forward.lmds[i].distance);
  ASSERT_FALSE(distances.empty());
  const double force = std::hypot(forward.wrench.force[0], forward.wrench.force[1], forward.wrench.force[2]);
  const std::size_t sets = forward.set_count;

  const plp_contacts back = run(torus_, box_, b_from_a);
  EXPECT_EQ(back.set_count, sets);
  std::vector<double> back_distances;
  for (std::size_t i = 0; i < back.lmd_count; ++i) back_distances.push_back(back.lmds[i].distance);
  std::sort(distances.begin(), distances.end());
  std::sort(back_distances.begin(), back_distances.end());
  ASSERT_EQ(back_distances.size(), distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) EXPECT_NEAR(distances[i], back_distances[i], 1e-12);
  EXPECT_NEAR(std::hypot(back.wrench.force[0], back.wrench.force[1], back.wrench.force[2]), force, 1e-8);
}

TEST_F(QueryTest, FeaturesNameTheirPlace) {
  const plp_contacts contacts = run(box_, box_, at(1.0625, 1.0625, 1.0625));
  ASSERT_EQ(contacts.lmd_count, 1u);
  const plp_lmd& lmd = contacts.lmds[0];
  EXPECT_EQ(lmd.feature_a, PLP_FEATURE_VERTEX);
  EXPECT_EQ(lmd.feature_b, PLP_FEATURE_VERTEX);
  const Shape shape = box(0.5f, 0.5f, 0.5f);
  EXPECT_EQ(shape.triangles[lmd.triangle_a][lmd.corner_a], 7u);
  EXPECT_EQ(shape.triangles[lmd.triangle_b][lmd.corner_b], 0u);
  EXPECT_NEAR(lmd.distance, std::sqrt(3.0) * 0.0625, 1e-12);
  EXPECT_EQ(lmd.body_a, 0u);
}

}  // namespace
}  // namespace palpate::test
