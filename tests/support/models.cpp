#include "tests/support/models.h"

#include <cstdlib>
#include <stdexcept>

#include "assets/catalogue.h"
#include "engine/gltf/gltf_file.h"

namespace palpate {

std::shared_ptr<const Model> make_model(const TriangleSoup& soup, const MeshOptions& options) {
  Result<Mesh> mesh = build_mesh(soup, options);
  if (!mesh) throw std::runtime_error(mesh.error().message);
  return std::make_shared<const Model>(std::move(mesh.value()));
}

std::shared_ptr<const Model> asset_model(const std::string& name, double scale) {
  const Asset* asset = find_asset(name);
  if (!asset) throw std::runtime_error("no asset " + name);
  return make_model(scaled(asset->make(), scale));
}

std::optional<std::string> data_folder() {
  const char* folder = std::getenv("PALPATE_DATA");
  if (!folder || !*folder) return std::nullopt;
  return folder;
}

std::shared_ptr<const Model> data_model(const std::string& file, double scale) {
  return file_model(*data_folder() + "/" + file, scale);
}

std::shared_ptr<const Model> file_model(const std::string& path, double scale) {
  const Result<GltfScene> scene = read_gltf_file(path, {});
  if (!scene) throw std::runtime_error(scene.error().message);
  return make_model(scaled(bake(scene.value()), scale));
}

TriangleSoup scaled(TriangleSoup soup, double scale) {
  for (DVec3& position : soup.positions) position *= scale;
  return soup;
}

}  // namespace palpate
