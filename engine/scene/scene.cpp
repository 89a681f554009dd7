#include "engine/scene/scene.h"

#include <algorithm>
#include <utility>

#include "engine/base/clock.h"

namespace palpate {

Result<BodyId> Scene::add(BodyOptions options) {
  const bool is_tool = options.kind == BodyKind::kTool;
  if (is_tool && tool_ != 0) return Error{ErrorCode::kInvalidArgument, "the scene has a tool already"};
  const BodyId id = bodies_.add(Body(std::move(options)));
  if (id == 0) return Error{ErrorCode::kLimit, "the scene is full"};
  if (is_tool) tool_ = id;
  return id;
}

bool Scene::remove(BodyId id) {
  if (!bodies_.remove(id)) return false;
  if (id == tool_) lose_tool();
  return true;
}

void Scene::place(std::unique_ptr<Body> body) {
  if (body->options().kind == BodyKind::kTool) tool_ = body->id;
  bodies_.place(std::move(body));
}

std::unique_ptr<Body> Scene::take(BodyId id) {
  std::unique_ptr<Body> body = bodies_.take(id);
  if (body && id == tool_) lose_tool();
  return body;
}

Body* Scene::body_against(BodyId tool, BodyId id) {
  return tool_ == tool ? bodies_.find(id) : nullptr;
}

void Scene::fix() {
  search_.fix(Room{});
  forces_.reserve(kMostListed.springs);
  law_springs_.reserve(kNearRoom);
  for (Contacts* contacts : {&contacts_, &next_}) contacts->fix(kMostListed);
  fixed_ = true;
}

void Scene::unfix() {
  fixed_ = false;
  search_.unfix();
  for (Contacts* contacts : {&contacts_, &next_}) contacts->unfix();
  bodies_.for_each([](BodyId, Body& body) { body.against_tool.unfix(); });
}

bool Scene::set_pose(BodyId id, const Pose& pose) {
  Body* body = bodies_.find(id);
  if (body) body->set_pose(pose);
  return body != nullptr;
}

void Scene::step(double dt) {
  const Stopwatch watch;
  next_.clear();
  forces_.clear();
  time_step_ = dt;
  next_.step = ++steps_;
  if (const Body* tool = bodies_.find(tool_)) {
    bodies_.for_each([&](BodyId id, Body& body) {
      if (id != tool_) touch(id, body, *tool);
    });
    forces_.finish(options_.stiffness_cap, tool->pose() * tool->options().reference_point, next_);
  }
  next_.search_us = watch.elapsed_us();
  std::swap(contacts_, next_);
}

// At least one overlap is asked for, because an empty list means that nothing overlaps.
std::size_t Scene::max_overlaps() const {
  return std::clamp<std::size_t>(options_.max_overlaps, 1, fixed_ ? kMostListed.overlaps : SIZE_MAX);
}

void Scene::lose_tool() {
  tool_ = 0;
  bodies_.for_each([](BodyId, Body& body) {
    body.against_tool.retire();
    body.springs.forget();
  });
}

void Scene::touch(BodyId id, Body& body, const Body& tool) {
  ++next_.work.bodies;
  PairSearch& pair = body.against_tool;
  if (!within_reach(body.sphere(), tool.sphere(), options_.cutoff)) {
    body.leave();
    return;
  }
  body.is_near = true;
  if (fixed_ && !pair.ready()) {
    next_.status |= kStatusWaiting;
    body.springs.forget();
    return;
  }
  const ForceLaw law = fixed_ && !pair.ready_for_near_minima() ? ForceLaw::kSprings : options_.law;
  const PairSituation situation{inverse(body.pose()) * tool.pose(),
                                options_.cutoff,
                                max_overlaps(),
                                options_.mode,
                                options_.global_every,
                                steps_,
                                law == ForceLaw::kSmooth};
  pair.update(*body.options().model, *tool.options().model, situation, search_);
  if (pair.searched()) {
    ++next_.work.body_pairs;
    next_.work.search.node_pairs += pair.found().work.node_pairs;
    next_.work.search.triangle_pairs += pair.found().work.triangle_pairs;
    next_.work.add(pair.work());
  }
  const ContactPair contacts{body.mesh(),
                             tool.mesh(),
                             id,
                             tool_,
                             body.pose(),
                             spring_law_of(body.options()),
                             std::min(options_.max_overlaps, max_overlaps())};
  const std::uint32_t first_set = next_.set_count;
  append_contacts(pair.found(), contacts, next_);
  body.springs.update(law_springs_.of(pair.found(), law, options_.cutoff),
                      {situation.body_from_tool, options_.cutoff, time_step_, options_.fade_time,
                       pair.found().overlapping(), options_.mode == SearchMode::kDescent});
  if (body.springs.is_walled()) next_.status |= kStatusWall;
  forces_.add(body.springs.list(), contacts, law == ForceLaw::kSmooth ? kNoSet : first_set, next_);
}

SpringLaw Scene::spring_law_of(const BodyOptions& body) const {
  const auto own_or = [](double own, double common) { return own > 0.0 ? own : common; };
  return {own_or(body.stiffness, options_.stiffness), options_.cutoff, own_or(body.damping, options_.damping),
          body.friction < 0.0 ? 0.0 : own_or(body.friction, options_.friction)};
}

}  // namespace palpate
