#include "samples/viewer/loading.h"

#include <chrono>
#include <utility>

namespace palpate::viewer {
namespace {

constexpr double kCutoffShare = 0.02;  // of the scene's diagonal, if no cutoff is asked for

}  // namespace

Loading::Loading(const Arguments& arguments, const Content& before)
    : future_(std::async(std::launch::async, [this, arguments, before] { return load(arguments, before); })) {
}

std::string Loading::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

std::optional<Content> Loading::finished() {
  if (future_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return future_.get();
}

Content Loading::load(Arguments arguments, const Content& before) {
  Content content;
  const Arguments& had = before.arguments;
  content.scene = had.scene == arguments.scene ? before.scene : nullptr;
  if (!content.scene) content.scene = file(arguments.scene, 1.0, "scene");
  const bool same_tool = had.tool == arguments.tool && had.tool_scale == arguments.tool_scale;
  content.tool = same_tool ? before.tool : nullptr;
  if (!content.tool) content.tool = file(arguments.tool, arguments.tool_scale, "tool");
  if (content.scene && arguments.settings.cutoff == 0.0)
    arguments.settings.cutoff = kCutoffShare * content.scene->diagonal();
  if (arguments.replay && !arguments.pose)
    arguments.pose = placement_of(arguments.replay->poses().front().pose);
  if (content.complete()) {
    enter("Bringing the tool to the scene");
    content.place = find_workplace(arguments, *content.scene, *content.tool);
  }
  content.arguments = std::move(arguments);
  return content;
}

std::shared_ptr<const ModelFile> Loading::file(const std::string& path, double scale, const char* role) {
  if (path.empty()) return nullptr;
  enter("Reading the " + std::string(role) + " " + path + " and building its hierarchies");
  return std::make_shared<const ModelFile>(load_model_file(path, scale));
}

void Loading::enter(std::string stage) {
  const std::lock_guard lock(mutex_);
  stage_ = std::move(stage);
}

}  // namespace palpate::viewer
