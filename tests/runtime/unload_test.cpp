// A program that loads the library, starts a servo and closes the library: what still runs must not be gone.
#include <dlfcn.h>

#include <gtest/gtest.h>

#include "palpate/palpate.h"
#include "tests/runtime/threads.h"

namespace palpate::test {
namespace {

template <class Function>
Function* function_of(void* library, const char* name, Function*) {
  void* const found = dlsym(library, name);
  EXPECT_NE(found, nullptr) << name;
  return reinterpret_cast<Function*>(found);
}
#define FUNCTION_OF(library, name) function_of(library, #name, static_cast<decltype(&name)>(nullptr))

TEST(Unload, LeavesTheServoItsCode) {
  const std::size_t before = thread_count();
  for (int round = 0; round < 3; ++round) {
    void* const library = dlopen(PALPATE_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    plp_scene_options options;
    plp_scene scene = nullptr;
    FUNCTION_OF(library, plp_scene_options_init)(&options, sizeof options);
    options.cutoff = 0.1;
    ASSERT_EQ(FUNCTION_OF(library, plp_scene_create)(&options, &scene), PLP_OK);
    ASSERT_EQ(FUNCTION_OF(library, plp_scene_start)(scene, nullptr), PLP_OK);
    EXPECT_EQ(settled_thread_count(before + 2), before + 2);
    const auto shut_down = FUNCTION_OF(library, plp_shutdown_all);
    ASSERT_EQ(dlclose(library), 0);
    EXPECT_EQ(settled_thread_count(before + 2), before + 2);
    shut_down();
    EXPECT_EQ(settled_thread_count(before), before);
  }
}

}  // namespace
}  // namespace palpate::test
