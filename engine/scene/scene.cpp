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

PairSearch* Scene::search_of(BodyId id) {
  Body* const body = bodies_.find(id);
  return body ? &body->against_tool : nullptr;
}

void Scene::fix() {
  search_.fix(Room{});
  for (Contacts* contacts : {&contacts_, &next_}) contacts->fix(kMostContacts, kMostOverlaps);
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

void Scene::step() {
  const Stopwatch watch;
  next_.clear();
  next_.step = ++steps_;
  if (const Body* tool = bodies_.find(tool_)) {
    bodies_.for_each([&](BodyId id, Body& body) {
      if (id != tool_) touch(id, body, *tool);
    });
  }
  next_.search_us = watch.elapsed_us();
  std::swap(contacts_, next_);
}

// At least one overlap is asked for, because an empty list means that nothing overlaps.
std::size_t Scene::max_overlaps() const {
  return std::clamp<std::size_t>(options_.max_overlaps, 1, fixed_ ? kMostOverlaps : SIZE_MAX);
}

void Scene::lose_tool() {
  tool_ = 0;
  bodies_.for_each([](BodyId, Body& body) { body.against_tool.retire(); });
}

void Scene::touch(BodyId id, Body& body, const Body& tool) {
  ++next_.work.bodies;
  PairSearch& pair = body.against_tool;
  if (!within_reach(body.sphere(), tool.sphere(), options_.cutoff)) {
    pair.ready() ? pair.rest() : pair.forget();
    return;
  }
  if (fixed_ && !pair.ready()) {
    next_.status |= kStatusWaiting;
    return;
  }
  const PairSituation situation{inverse(body.pose()) * tool.pose(),
                                options_.cutoff,
                                max_overlaps(),
                                options_.mode,
                                options_.global_every,
                                steps_};
  pair.update(*body.options().model, *tool.options().model, situation, search_);
  if (pair.searched()) {
    ++next_.work.body_pairs;
    next_.work.search.node_pairs += pair.found().work.node_pairs;
    next_.work.search.triangle_pairs += pair.found().work.triangle_pairs;
    next_.work.add(pair.work());
  }
  const double stiffness = body.options().stiffness > 0.0 ? body.options().stiffness : options_.stiffness;
  const DVec3 reference = tool.pose() * tool.options().reference_point;
  append_contacts(pair.found(),
                  {body.mesh(),
                   tool.mesh(),
                   id,
                   tool_,
                   body.pose(),
                   {stiffness, options_.cutoff},
                   reference,
                   std::min(options_.max_overlaps, max_overlaps())},
                  next_);
}

}  // namespace palpate
