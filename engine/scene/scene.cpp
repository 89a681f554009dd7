#include "engine/scene/scene.h"

#include <algorithm>
#include <limits>
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
  if (body) note_removal(id);
  return body;
}

void Scene::note_removal(BodyId id) {
  if (removed_ && (!fixed_ || removed_->size() < removed_->capacity())) removed_->push_back(id);
}

Body* Scene::body_against(BodyId tool, BodyId id) {
  return tool_ == tool ? bodies_.find(id) : nullptr;
}

void Scene::fix() {
  searches_.front().fix(Room{});
  near_.reserve(kMostNear);
  forces_.reserve(kMostListed.springs);
  law_springs_.reserve(kNearRoom);
  for (Contacts* contacts : {&contacts_, &next_}) contacts->fix(kMostListed);
  fixed_ = true;
}

void Scene::unfix() {
  fixed_ = false;
  searches_.front().unfix();
  for (Contacts* contacts : {&contacts_, &next_}) contacts->unfix();
  bodies_.for_each([](BodyId, Body& body) { body.against_tool.unfix(); });
}

bool Scene::set_pose(BodyId id, const Pose& pose) {
  return bodies_.set_pose(id, pose);
}

void Scene::step(double dt) {
  const Stopwatch watch;
  next_.clear();
  forces_.clear();
  time_step_ = dt;
  next_.step = steps_ + 1;
  if (const Body* tool = bodies_.find(tool_)) {
    find_near_bodies(*tool);
    share_budget();
    search_near_bodies(*tool);
    for (NearBody& near : near_) list(near, *tool);
    make_room_for_springs();
    for (const NearBody& near : near_) push(near, *tool);
    forces_.finish(stiffness_cap(), tool->pose() * tool->options().reference_point, next_);
  }
  next_.search_us = watch.elapsed_us();
  ++steps_;
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

void Scene::set_executor(Executor* executor) {
  executor_ = executor;
  if (executor && executor->workers() > searches_.size())
    searches_ = std::vector<LmdSearch>(executor->workers());
}

void Scene::find_near_bodies(const Body& tool) {
  near_.clear();
  next_.work.bodies = bodies_.size() - 1;
  if (!reach_.follow(tool.id, tool.sphere(), options_.cutoff)) bodies_.forget_far();
  bodies_.for_each_near(reach_.way(), [&](BodyId id, Body& body) {
    if (id == tool_) return 0.0;
    // What is intangible is out of reach wherever it is.
    const double far_until =
        body.options().intangible ? std::numeric_limits<double>::max() : reach_.far_until(body.sphere());
    far_until > 0.0 ? body.leave() : look_at(id, body, tool);
    return far_until;
  });
}

void Scene::look_at(BodyId id, Body& body, const Body& tool) {
  body.is_near = true;
  const bool ready = !fixed_ || body.against_tool.ready();
  if (!ready || (fixed_ && !has_room(near_, 1))) {
    next_.status |= ready ? kStatusCut : kStatusWaiting;
    return body.springs.forget();
  }
  const bool springs = fixed_ && !body.against_tool.ready_for_near_minima();
  const ForceLaw law = springs ? ForceLaw::kSprings : options_.law;
  near_.push_back(
      {id, &body, law,
       PairSituation{inverse(body.pose()) * tool.pose(), options_.cutoff, max_overlaps(), options_.mode,
                     options_.global_every, next_.step, law == ForceLaw::kSmooth}});
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

// Where memory is fixed, as on a servo, nobody is waited for.
void Scene::search_near_bodies(const Body& tool) {
  Searches searches(near_, tool, searches_);
  if (executor_ && !fixed_ && near_.size() > 1) return executor_->run(searches, near_.size());
  for (std::size_t piece = 0; piece < near_.size(); ++piece) searches.run(piece, 0);
}

ContactPair Scene::contact_pair(const NearBody& near, const Body& tool) const {
  const Body& body = *near.body;
  return {body.mesh(),
          tool.mesh(),
          near.id,
          tool_,
          body.pose(),
          spring_law_of(body.options()),
          std::min(options_.max_overlaps, max_overlaps())};
}

void Scene::list(NearBody& near, const Body& tool) {
  const PairSearch& pair = near.body->against_tool;
  if (pair.searched()) {
    ++next_.work.body_pairs;
    next_.work.search.node_pairs += pair.found().work.node_pairs;
    next_.work.search.triangle_pairs += pair.found().work.triangle_pairs;
    next_.work.add(pair.work());
  }
  if (pair.by_descent()) next_.status |= kStatusByDescent;
  near.first_set = next_.set_count;
  append_contacts(pair.found(), contact_pair(near, tool), next_);
}

// Springs go on from step to step, so that no step may be given up once the first of them has gone on.
void Scene::make_room_for_springs() {
  if (fixed_) return;
  std::size_t most = 0;
  for (const NearBody& near : near_) {
    const LmdSet& found = near.body->against_tool.found();
    const std::size_t present = near.law == ForceLaw::kSmooth ? found.near_minima.size() : found.lmds.size();
    most += near.body->springs.make_room(present);
  }
  if (most <= spring_room_) return;
  law_springs_.reserve(2 * most);
  forces_.reserve(2 * most);
  for (Contacts* contacts : {&contacts_, &next_}) contacts->springs.reserve(2 * most);
  spring_room_ = 2 * most;
}

void Scene::push(const NearBody& near, const Body& tool) {
  Body& body = *near.body;
  const PairSearch& pair = body.against_tool;
  body.springs.update(law_springs_.of(pair.found(), near.law, options_.cutoff),
                      {near.situation.body_from_tool, options_.cutoff, time_step_, options_.fade_time,
                       pair.found().overlapping(), options_.mode == SearchMode::kDescent});
  if (body.springs.is_walled()) next_.status |= kStatusWall;
  forces_.add(body.springs.list(), contact_pair(near, tool),
              near.law == ForceLaw::kSmooth ? kNoSet : near.first_set, next_);
}

double Scene::stiffness_cap() const {
  return options_.stiffness_cap == 0.0 ? device_stiffness_ : options_.stiffness_cap;
}

SpringLaw Scene::spring_law_of(const BodyOptions& body) const {
  const auto own_or = [](double own, double common) { return own > 0.0 ? own : common; };
  return {own_or(body.stiffness, options_.stiffness), options_.cutoff, own_or(body.damping, options_.damping),
          body.friction < 0.0 ? 0.0 : own_or(body.friction, options_.friction)};
}

}  // namespace palpate
