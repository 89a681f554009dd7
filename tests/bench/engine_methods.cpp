#include "tests/bench/engine_methods.h"

#include <algorithm>

#include "engine/snch/kinetic_front.h"

namespace palpate::bench {
namespace {

SearchOptions options_of(const ModelPair& pair) {
  SearchOptions options;
  options.cutoff = pair.cutoff;
  return options;
}

// What the engine's methods have in common.
class EngineMethod : public Method {
 public:
  explicit EngineMethod(const ModelPair& pair)
      : a_(pair.a), b_(pair.b), options_(options_of(pair)), cutoff_(pair.cutoff) {}

  std::string returns() const override { return "complete set"; }

  Outcome outcome() const override {
    std::vector<SpringContact> contacts;
    for (const Lmd& lmd : found_.lmds)
      contacts.push_back({lmd.point_b, lmd.normal, lmd.distance, lmd.weight});
    Outcome outcome = outcome_of(contacts, cutoff_, reference_);
    outcome.lmds = found_.set_count;
    outcome.overlap = found_.overlapping();
    outcome.work = found_.work;
    return outcome;
  }

  void prepare(const Pose& a_from_b) override { reference_ = a_from_b * b_->centre(); }

 protected:
  std::shared_ptr<const Model> a_, b_;
  SearchOptions options_;
  double cutoff_;
  DVec3 reference_{0.0};
  LmdSet found_;
};

class Search : public EngineMethod {
 public:
  using EngineMethod::EngineMethod;
  std::string name() const override { return "search"; }
  void update(const Pose& a_from_b) override { search_.run(*a_, *b_, a_from_b, options_, found_); }

 private:
  LmdSearch search_;
};

class Front : public EngineMethod {
 public:
  using EngineMethod::EngineMethod;
  std::string name() const override { return "kinetic_front"; }
  void update(const Pose& a_from_b) override { front_.update(*a_, *b_, a_from_b, options_, found_); }
  void restart() override { front_.forget(); }

 private:
  KineticFront front_;
};

class Descent : public EngineMethod {
 public:
  Descent(const ModelPair& pair, DescentForm form) : EngineMethod(pair), form_(form), tracker_(form) {
    // As far beyond the cutoff as the tool can go until the next search.
    options_.cutoff += kPeriod * 1e-3 * kSpeed * a_->bounds().diagonal();
  }

  std::string name() const override {
    return form_ == DescentForm::kPolar ? "descent_polar" : "descent_neighbourhood";
  }
  std::string returns() const override { return "LMDs followed from the last search"; }

  void restart() override {
    tracker_.forget();
    age_ = 0;
  }
  void prepare(const Pose& a_from_b) override {
    EngineMethod::prepare(a_from_b);
    if (age_++ % kPeriod != 0) return;
    search_.run(*a_, *b_, a_from_b, options_, searched_);
    tracker_.adopt(a_->mesh(), b_->mesh(), searched_);
  }
  void update(const Pose& a_from_b) override {
    tracker_.follow(a_->mesh(), b_->mesh(), a_from_b, options_, cutoff_, found_);
  }
  Outcome outcome() const override {
    Outcome outcome = EngineMethod::outcome();
    outcome.followed = tracker_.work().descents;
    return outcome;
  }

 private:
  static constexpr int kPeriod = 10;  // poses from one search to the next

  DescentForm form_;
  LmdTracker tracker_;
  LmdSearch search_;
  LmdSet searched_;
  int age_ = 0;
};

}  // namespace

std::unique_ptr<Method> search_method(const ModelPair& pair) {
  return std::make_unique<Search>(pair);
}

std::unique_ptr<Method> front_method(const ModelPair& pair) {
  return std::make_unique<Front>(pair);
}

std::unique_ptr<Method> descent_method(const ModelPair& pair, DescentForm form) {
  return std::make_unique<Descent>(pair, form);
}

}  // namespace palpate::bench
