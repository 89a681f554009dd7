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
    find_near_bodies(*tool);
    share_budget();
    search_near_bodies(*tool);
    for (const NearBody& near : near_) collect(near, *tool);
  }
  next_.search_us = watch.elapsed_us();
  std::swap(contacts_, next_);
}

void Scene::forget_searches() {
  bodies_.for_each([](BodyId, Body& body) { body.against_tool.forget(); });
}

void Scene::set_executor(Executor* executor) {
  executor_ = executor;
  if (executor && executor->workers() > searches_.size())
    searches_ = std::vector<LmdSearch>(executor->workers());
}

void Scene::find_near_bodies(const Body& tool) {
  near_.clear();
  bodies_.for_each([&](BodyId id, Body& body) {
    if (id == tool_) return;
    ++next_.work.bodies;
    if (!within_reach(body.sphere(), tool.sphere(), options_.cutoff)) return body.against_tool.forget();
    // At least one overlap is asked for, because an empty list means that nothing overlaps.
    near_.push_back({id, &body,
                     PairSituation{inverse(body.pose()) * tool.pose(), options_.cutoff,
                                   std::max<std::size_t>(options_.max_overlaps, 1), options_.mode,
                                   options_.global_every}});
  });
}

// In equal parts, so that no part depends on what another left over.
void Scene::share_budget() {
  if (options_.tick_budget == 0) return;
  const auto searched = static_cast<std::uint64_t>(std::ranges::count_if(
      near_, [](const NearBody& near) { return near.body->against_tool.needs_search(near.situation); }));
  for (NearBody& near : near_)
    near.situation.budget = options_.tick_budget / std::max<std::uint64_t>(searched, 1);
}

// The searches of one step, a piece a body.
class Scene::Searches : public Pieces {
 public:
  Searches(std::vector<NearBody>& near, const Body& tool, std::vector<LmdSearch>& searches)
      : near_(near), tool_(*tool.options().model), searches_(searches) {}

  void run(std::size_t piece, std::size_t worker) override {
    const NearBody& near = near_[piece];
    near.body->against_tool.update(*near.body->options().model, tool_, near.situation, searches_[worker]);
  }

 private:
  std::vector<NearBody>& near_;
  const Model& tool_;
  std::vector<LmdSearch>& searches_;
};

void Scene::search_near_bodies(const Body& tool) {
  Searches searches(near_, tool, searches_);
  if (executor_ && near_.size() > 1) return executor_->run(searches, near_.size());
  for (std::size_t piece = 0; piece < near_.size(); ++piece) searches.run(piece, 0);
}

void Scene::collect(const NearBody& near, const Body& tool) {
  const Body& body = *near.body;
  const PairSearch& pair = body.against_tool;
  if (pair.searched()) {
    ++next_.work.body_pairs;
    next_.work.search.node_pairs += pair.found().work.node_pairs;
    next_.work.search.triangle_pairs += pair.found().work.triangle_pairs;
    next_.work.add(pair.work());
  }
  if (pair.by_descent()) next_.status |= kStatusByDescent;
  const double stiffness = body.options().stiffness > 0.0 ? body.options().stiffness : options_.stiffness;
  const DVec3 reference = tool.pose() * tool.options().reference_point;
  append_contacts(pair.found(),
                  {body.mesh(),
                   tool.mesh(),
                   near.id,
                   tool_,
                   body.pose(),
                   {stiffness, options_.cutoff},
                   reference,
                   options_.max_overlaps},
                  next_);
}

}  // namespace palpate
