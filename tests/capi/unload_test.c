/* unload LIBRARY: a host may close the library while a worker of Embree's scheduler, which a build wakes,
 * still runs. */
#include <dlfcn.h>
#include <palpate/palpate.h>
#include <stdio.h>
#include <string.h>

#define SIDE 200

static int fail(const char* what) {
  fprintf(stderr, "unload: %s\n", what);
  return 1;
}

/* ISO C has no cast from an object to a function. */
#define FIND(library, name)                           \
  do {                                                \
    void* address = dlsym(library, #name);            \
    if (!address) return fail("no " #name);           \
    memcpy(&name##_found, &address, sizeof(address)); \
  } while (0)

static float positions[SIDE * SIDE * 9];

/* Many small triangles. */
static void fill(void) {
  for (int i = 0; i < SIDE * SIDE; ++i) {
    const float x = (float)(i % SIDE), y = (float)(i / SIDE);
    const float corners[9] = {x, y, 0, x + 0.9f, y, 0, x, y + 0.9f, 0};
    memcpy(positions + 9 * i, corners, sizeof corners);
  }
}

static int build(void* library) {
  void (*plp_triangles_init_found)(plp_triangles*, size_t);
  plp_result (*plp_model_create_from_triangles_found)(const plp_triangles*, const plp_model_options*,
                                                      plp_model*);
  plp_result (*plp_model_prepare_found)(plp_model);
  plp_result (*plp_model_release_found)(plp_model);
  plp_triangles triangles;
  plp_model model;
  FIND(library, plp_triangles_init);
  FIND(library, plp_model_create_from_triangles);
  FIND(library, plp_model_prepare);
  FIND(library, plp_model_release);
  fill();
  plp_triangles_init_found(&triangles, sizeof triangles);
  triangles.positions = positions;
  triangles.vertex_count = 3 * SIDE * SIDE;
  if (plp_model_create_from_triangles_found(&triangles, NULL, &model) != PLP_OK) return fail("no model");
  if (plp_model_prepare_found(model) != PLP_OK) return fail("no hierarchy");
  return plp_model_release_found(model) == PLP_OK ? 0 : fail("no release");
}

int main(int argc, char** argv) {
  void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!library) return fail("cannot open the library");
  if (build(library) != 0 || dlclose(library) != 0) return 1;
  return dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD) ? 0
                                                 : fail("the library has left the memory under its threads");
}
