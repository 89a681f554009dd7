#pragma once

#include <future>
#include <mutex>
#include <optional>
#include <string>

#include "samples/viewer/content.h"

namespace palpate::viewer {

// Loads content in a thread of its own, so that a window stays alive meanwhile.
class Loading {
 public:
  // What `before` has already is kept if the arguments name no other file.
  Loading(const Arguments& arguments, const Content& before);

  std::string stage() const;  // what is being done, for people

  // Empty while it goes on. Throws cli::Failure if it failed.
  std::optional<Content> finished();
  Content wait() { return future_.get(); }

 private:
  Content load(Arguments arguments, const Content& before);
  std::shared_ptr<const ModelFile> file(const std::string& path, double scale, const char* role);
  void enter(std::string stage);

  mutable std::mutex mutex_;
  std::string stage_;            // under the mutex
  std::future<Content> future_;  // ends first: it uses all else
};

}  // namespace palpate::viewer
