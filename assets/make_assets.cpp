// palpate-make-assets OUT_DIR: writes every model of the catalogue as OUT_DIR/<name>.glb and prints what they
// are.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "assets/catalogue.h"
#include "assets/glb_writer.h"
#include "engine/math/box.h"

namespace {

bool write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file.good();
}

void print_row(const std::string& name, const palpate::TriangleSoup& soup) {
  palpate::Box bounds;
  for (const auto& position : soup.positions) bounds.grow(position);
  const auto size = bounds.size();
  std::printf("%-20s %9zu %9zu   %.4f x %.4f x %.4f\n", name.c_str(), soup.triangles.size(),
              soup.positions.size(), size.x, size.y, size.z);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: palpate-make-assets OUT_DIR\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.message().c_str());
    return 1;
  }
  std::printf("%-20s %9s %9s   %s\n", "name", "triangles", "vertices", "bounding box [m]");
  for (const palpate::Asset& asset : palpate::catalogue()) {
    const std::string name(asset.name);
    const palpate::TriangleSoup soup = asset.make();
    const auto path = folder / (name + ".glb");
    if (!write_file(path, palpate::glb_bytes(soup, name))) {
      std::fprintf(stderr, "%s: cannot be written\n", path.string().c_str());
      return 1;
    }
    print_row(name, soup);
  }
  return 0;
}
