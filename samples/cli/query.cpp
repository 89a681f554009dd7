#include <algorithm>
#include <cstdio>
#include <iostream>

#include "samples/cli/commands.h"
#include "samples/cli/contacts.h"
#include "samples/cli/handles.h"
#include "samples/cli/json_writer.h"

namespace palpate::cli {
namespace {

plp_pose pose_of(const std::array<double, 7>& numbers) {
  plp_pose pose;
  std::copy_n(numbers.begin(), 3, pose.position);
  std::copy_n(numbers.begin() + 3, 4, pose.orientation);
  return pose;
}

const char* feature_text(std::uint8_t feature) {
  switch (feature) {
    case PLP_FEATURE_FACE:
      return "face";
    case PLP_FEATURE_EDGE:
      return "edge";
    default:
      return "vertex";
  }
}

void write_lmd(JsonWriter& json, const plp_lmd& lmd) {
  json.open_object()
      .field("a", std::span(lmd.point_a))
      .field("b", std::span(lmd.point_b))
      .field("distance", lmd.distance)
      .field("weight", lmd.weight)
      .field("set", lmd.set)
      .field("feature_a", feature_text(lmd.feature_a))
      .field("feature_b", feature_text(lmd.feature_b))
      .field("normal", std::span(lmd.normal))
      .field("force", std::span(lmd.force))
      .field("triangle_a", lmd.triangle_a)
      .field("triangle_b", lmd.triangle_b)
      .close();
}

void print_json(const plp_contacts& contacts) {
  JsonWriter json(std::cout);
  json.open_object().key("lmds").open_array();
  for (std::size_t i = 0; i < contacts.lmd_count; ++i) write_lmd(json, lmd_at(contacts, i));
  json.close().field("overlap", contacts.overlap != 0);
  json.key("wrench").open_object();
  json.field("force", std::span(contacts.wrench.force))
      .field("torque", std::span(contacts.wrench.torque))
      .close();
  json.field("search_us", contacts.search_us)
      .field("overlapping_pairs", contacts.overlap_count)
      .field("node_pairs", contacts.work.node_pairs)
      .field("triangle_pairs", contacts.work.triangle_pairs)
      .close();
  std::cout << '\n';
}

void print_table(const plp_contacts& contacts) {
  std::printf("%5s %12s %8s %-7s %-7s %-38s %s\n", "set", "distance", "weight", "on A", "on B", "point on A",
              "point on B");
  for (std::size_t i = 0; i < contacts.lmd_count; ++i) {
    const plp_lmd& lmd = lmd_at(contacts, i);
    std::printf("%5u %12.6g %8.4f %-7s %-7s %12.6g %12.6g %12.6g %12.6g %12.6g %12.6g\n", lmd.set,
                lmd.distance, lmd.weight, feature_text(lmd.feature_a), feature_text(lmd.feature_b),
                lmd.point_a[0], lmd.point_a[1], lmd.point_a[2], lmd.point_b[0], lmd.point_b[1],
                lmd.point_b[2]);
  }
  const plp_wrench& wrench = contacts.wrench;
  std::printf("\n%zu local minimum distances%s\n", contacts.set_count,
              contacts.overlap ? "; the models overlap" : "");
  std::printf("force on B  %g %g %g N\n", wrench.force[0], wrench.force[1], wrench.force[2]);
  std::printf("torque on B %g %g %g N m about its origin\n", wrench.torque[0], wrench.torque[1],
              wrench.torque[2]);
  std::printf("searched in %.0f us\n", contacts.search_us);
}

}  // namespace

void run_query(const QueryArguments& arguments) {
  if (std::all_of(arguments.pose.begin() + 3, arguments.pose.end(), [](double x) { return x == 0.0; }))
    throw Failure("--pose: its quaternion is zero");
  const OwnedModel a = load_model(arguments.a, arguments.scale_a);
  const OwnedModel b = load_model(arguments.b, arguments.scale_b);
  OwnedQueryResult result;
  check(plp_query_result_create(result.receive()));

  plp_query_options options;
  plp_query_options_init(&options, sizeof options);
  options.cutoff = arguments.cutoff;
  options.stiffness = arguments.stiffness;
  const plp_pose pose = pose_of(arguments.pose);
  check(plp_query(a.get(), b.get(), &pose, &options, result.get()));

  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  check(plp_query_result_get(result.get(), &contacts));
  if (arguments.json) {
    print_json(contacts);
  } else {
    print_table(contacts);
  }
}

}  // namespace palpate::cli
