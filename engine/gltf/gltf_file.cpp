#include "engine/gltf/gltf_file.h"

#include <exception>
#include <new>
#include <vector>

#include "engine/base/memory_reserve.h"
#include "engine/gltf/buffer_store.h"
#include "engine/gltf/file_bytes.h"
#include "engine/gltf/gltf_container.h"
#include "engine/gltf/gltf_document.h"
#include "engine/gltf/load_budget.h"
#include "engine/gltf/load_error.h"
#include "engine/gltf/scene_reader.h"

namespace palpate {
namespace {

// nlohmann::json, and with it tinygltf, requests memory in its destructors, at most for the longest array at
// a time, and ends the program where it is refused.
std::size_t reserve_for(std::string_view json) {
  constexpr std::size_t kLeast = 1u << 17;
  return kLeast + 4 * json.size();
}

GltfScene read_scene(std::span<const std::byte> bytes, const std::filesystem::path& folder,
                     const GltfOptions& options, gltf::LoadBudget& budget) {
  const gltf::Container container = gltf::open_container(bytes);
  const MemoryReserve reserve(reserve_for(container.json), MemoryReserve::For::kThisThread);
  const gltf::GltfDocument document = gltf::read_document(container.json, options);
  gltf::BufferStore buffers(document, container, folder, budget);
  GltfScene scene = gltf::SceneReader(document, buffers, budget, options).read();
  scene.tally = budget.tally;
  if (reserve.is_touched()) throw std::bad_alloc();
  return scene;
}

// Nothing that is thrown while a file is read gets past here.
template <class Work>
Result<GltfScene> guarded(const std::string& name, Work&& work) {
  try {
    return work();
  } catch (const gltf::LoadError& error) {
    return Error{error.code(), name + ": " + error.what()};
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::kOutOfMemory, name + ": there is not enough memory to read it"};
  } catch (const std::exception& error) {
    return Error{ErrorCode::kBadFormat, name + ": " + error.what()};
  }
}

}  // namespace

Result<GltfScene> read_gltf_file(const std::filesystem::path& path, const GltfOptions& options) {
  return guarded(path.string(), [&] {
    gltf::LoadBudget budget(options.limits);
    const std::vector<std::byte> bytes = gltf::read_file_bytes(path, budget);
    const std::filesystem::path folder =
        path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    return read_scene(bytes, folder, options, budget);
  });
}

Result<GltfScene> read_gltf_bytes(std::span<const std::byte> bytes, const std::string& name,
                                  const std::filesystem::path& folder, const GltfOptions& options) {
  return guarded(name, [&] {
    gltf::LoadBudget budget(options.limits);
    budget.take_bytes(bytes.size());
    budget.tally.read_bytes += bytes.size();
    return read_scene(bytes, folder, options, budget);
  });
}

}  // namespace palpate
