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
  if (id == tool_) {
    tool_ = 0;
    forget_searches();
  }
  return true;
}

bool Scene::set_pose(BodyId id, const Pose& pose) {
  Body* body = bodies_.find(id);
  if (body) body->set_pose(pose);
  return body != nullptr;
}

void Scene::step() {
  const Stopwatch watch;
  next_.clear();
  if (const Body* tool = bodies_.find(tool_)) {
    bodies_.for_each([&](BodyId id, Body& body) {
      if (id != tool_) touch(id, body, *tool);
    });
  }
  next_.search_us = watch.elapsed_us();
  std::swap(contacts_, next_);
}

void Scene::forget_searches() {
  bodies_.for_each([](BodyId, Body& body) { body.against_tool.forget(); });
}

void Scene::touch(BodyId id, Body& body, const Body& tool) {
  ++next_.work.bodies;
  if (!within_reach(body.sphere(), tool.sphere(), options_.cutoff)) {
    body.against_tool.forget();
    return;
  }
  // At least one overlap is asked for, because an empty list means that nothing overlaps.
  const PairSituation situation{inverse(body.pose()) * tool.pose(),
                                options_.cutoff,
                                std::max<std::size_t>(options_.max_overlaps, 1),
                                options_.mode,
                                options_.global_every,
                                options_.law == ForceLaw::kSmooth};
  PairSearch& pair = body.against_tool;
  pair.update(*body.options().model, *tool.options().model, situation, search_);
  if (pair.searched()) {
    ++next_.work.body_pairs;
    next_.work.search.node_pairs += pair.found().work.node_pairs;
    next_.work.search.triangle_pairs += pair.found().work.triangle_pairs;
    next_.work.add(pair.work());
  }
  const double stiffness = body.options().stiffness > 0.0 ? body.options().stiffness : options_.stiffness;
  const DVec3 reference = tool.pose() * tool.options().reference_point;
  maker_.append(pair.found(),
                {body.mesh(),
                 tool.mesh(),
                 id,
                 tool_,
                 body.pose(),
                 {stiffness, options_.cutoff},
                 reference,
                 options_.max_overlaps,
                 options_.law},
                next_);
}

}  // namespace palpate
