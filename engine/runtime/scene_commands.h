#pragma once

#include <utility>

#include "engine/runtime/body_record.h"
#include "engine/runtime/command.h"

namespace palpate {

class AddBody : public Command {
 public:
  // `slots` is empty, or larger than the scene's and to take their place.
  AddBody(std::unique_ptr<Body> body, BodyTable::Slots slots)
      : body_(std::move(body)), slots_(std::move(slots)) {}

  void execute(Scene& scene) noexcept override {
    if (slots_.capacity() > 0) scene.move_to(slots_);
    scene.place(std::move(body_));
  }

 private:
  std::unique_ptr<Body> body_;
  BodyTable::Slots slots_;
};

class RemoveBody : public Command {
 public:
  explicit RemoveBody(std::unique_ptr<BodyRecord> record) : record_(std::move(record)) {}

  void execute(Scene& scene) noexcept override { body_ = scene.take(record_->id); }

 private:
  std::unique_ptr<BodyRecord> record_;  // whose post may still lie in the mailbox before
  std::unique_ptr<Body> body_;
};

// Gives a pair a search that is ready and room for its springs, or ones that are not in order to get their
// memory back.
class ExchangeSearch : public Command {
 public:
  ExchangeSearch(BodyId body, BodyId tool) : body_(body), tool_(tool) {}

  PairSearch search;
  PairSprings springs;

  void execute(Scene& scene) noexcept override {
    Body* const body = scene.body_against(tool_, body_);
    if (!body) return;
    body->against_tool.take(search);
    if (!body->against_tool.ready()) body->springs.forget();
    body->springs.move_to(springs);
  }

 private:
  const BodyId body_;
  const BodyId tool_;
};

// Whatever `change` does to the scene.
template <class Change>
class ChangeScene : public Command {
 public:
  explicit ChangeScene(Change change) : change_(std::move(change)) {}

  void execute(Scene& scene) noexcept override { change_(scene); }

 private:
  Change change_;
};

}  // namespace palpate
