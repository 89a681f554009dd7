#include "samples/viewer/workplace.h"

#include <algorithm>
#include <cmath>

namespace palpate::viewer {
namespace {

using cli::check;

// How far beyond the contact a hand wants to go, in cutoffs. A face under the cap of a device gives way like
// a spring of at most half of what the device can, which a firm hand that wanted further would push through.
constexpr double kDepth = 0.3;

// How near the tool is at a place; negative where surfaces overlap.
class Feeler {
 public:
  Feeler(const ModelFile& scene, const ModelFile& tool, double cutoff) : scene_(scene), tool_(tool) {
    plp_query_options_init(&options_, sizeof options_);
    options_.cutoff = cutoff;
    options_.max_overlaps = 1;
    check(plp_query_result_create(result_.receive()));
  }

  double distance(const Placement& tool) {
    const plp_pose pose = pose_of(tool);
    check(plp_query(scene_.model.get(), tool_.model.get(), &pose, &options_, result_.get()));
    plp_contacts found;
    plp_contacts_init(&found, sizeof found);
    check(plp_query_result_get(result_.get(), &found));
    return found.overlap ? -1.0 : found.min_distance;
  }

 private:
  const ModelFile& scene_;
  const ModelFile& tool_;
  plp_query_options options_;
  cli::OwnedQueryResult result_;
};

int longest_axis(const Vec3& extent, const Vec3& except) {
  int longest = -1;
  for (int i = 0; i < 3; ++i)
    if (std::abs(except[i]) < 0.5 && (longest < 0 || extent[i] > extent[longest])) longest = i;
  return longest;
}

// Goes from `high` in steps of half the cutoff until the tool is within `gap`, and halves the last step. A
// tool that touches nothing on its way ends where it would be through.
Placement let_down(Feeler& feeler, const Placement& high, const Vec3& into, double reach, double gap) {
  const auto lowered = [&](double way) { return Placement{high.position + way * into, high.orientation}; };
  const double step = 0.5 * gap;
  double clear = 0.0;
  while (clear < reach && feeler.distance(lowered(clear + step)) > gap) clear += step;
  double near = clear + step;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (clear + near);
    (feeler.distance(lowered(middle)) > gap ? clear : near) = middle;
  }
  return lowered(clear);
}

}  // namespace

Workplace find_workplace(const Arguments& arguments, const ModelFile& scene, const ModelFile& tool) {
  const double cutoff = arguments.settings.cutoff;
  const Vec3 extent = scene.high - scene.low;
  const int longest = longest_axis(extent, arguments.up);
  Workplace place;
  place.into = -arguments.up;
  place.along = Vec3(0.0);
  place.along[longest] = 1.0;
  place.centre = scene.centre();
  place.depth = kDepth * cutoff;
  place.travel = 0.12 * extent[longest];
  if (arguments.pose) {
    place.start = *arguments.pose;
    place.contact = place.start;
    place.depth = 0.0;
    return place;
  }
  const double clearance = 0.5 * (std::abs(glm::dot(extent, arguments.up)) + tool.diagonal()) + cutoff;
  Placement high = arguments.tool_turn;
  high.position = place.centre + clearance * arguments.up +
                  0.5 * arguments.aside * extent[longest] * place.along - high.orientation * tool.centre();
  Feeler feeler(scene, tool, cutoff);
  place.contact = let_down(feeler, high, place.into, 2.0 * clearance, 0.5 * cutoff);
  place.start = {place.contact.position - 1.5 * cutoff * place.into, place.contact.orientation};
  return place;
}

}  // namespace palpate::viewer
