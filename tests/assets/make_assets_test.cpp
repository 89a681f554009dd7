// What palpate-make-assets wrote in the build.
#include <gtest/gtest.h>

#include <string>

#include "assets/catalogue.h"
#include "assets/glb_writer.h"
#include "parsed_glb.h"

namespace palpate::test {
namespace {

// Another process made these files: equal bytes also show that no address or hash order leaks into a model.
TEST(MakeAssets, FilesOfTheBuildHoldTheCatalogue) {
  for (const Asset& asset : catalogue()) {
    const std::string name(asset.name);
    const std::string file = read_file(std::string(PALPATE_ASSETS_DIR) + "/" + name + ".glb");
    EXPECT_TRUE(file == glb_bytes(asset.make(), name)) << name;
  }
}

}  // namespace
}  // namespace palpate::test
