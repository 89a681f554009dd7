#include <stdexcept>
#include <string>

#include "engine/base/clock.h"
#include "tests/bench/benches.h"
#include "tests/bench/fcl_methods.h"
#include "tests/bench/peak_memory.h"
#include "tests/bench/point_shell_method.h"
#include "tests/bench/sized_shape.h"

namespace palpate::bench {
namespace {

constexpr int kRepetitions = 5;
constexpr int kRepetitionsLarge = 2;  // from ten million triangles on

struct BuildSeries {
  Series mesh_us, tree_us, total_us, bytes, peak_bytes;
  Series embree_us, embree_bytes, fcl_us, fcl_bytes;
};

void build_once(const TriangleSoup& soup, bool peers, BuildSeries& series) {
  reset_peak_memory();
  const Stopwatch watch;
  Result<Mesh> built = build_mesh(soup, {});
  if (!built) throw std::runtime_error(built.error().message);
  const double mesh_us = watch.elapsed_us();
  const Model model(std::move(built.value()));
  const Stopwatch tree_watch;
  const Tree& tree = model.tree();
  series.mesh_us.add(mesh_us);
  series.tree_us.add(tree_watch.elapsed_us());
  series.total_us.add(watch.elapsed_us());
  const double triangles = static_cast<double>(model.mesh().triangles.size());
  series.bytes.add(static_cast<double>(model.mesh().bytes() + tree.bytes()) / triangles);
  series.peak_bytes.add(peak_memory() / triangles);
  if (!peers) return;
  const HierarchyCost embree = embree_hierarchy_cost(model.mesh());
  series.embree_us.add(embree.build_us);
  series.embree_bytes.add(embree.bytes / triangles);
  const HierarchyCost fcl = fcl_hierarchy_cost(model.mesh());
  series.fcl_us.add(fcl.build_us);
  series.fcl_bytes.add(fcl.bytes / triangles);
}

}  // namespace

void bench_build(const Effort& effort, Table& table) {
  for (double size : sizes_from(1e3, effort)) {
    const TriangleSoup soup = sized_shape(size);
    const std::string parameters = "triangles=" + std::to_string(soup.triangles.size());
    table.say("build: " + parameters);
    const bool large = size >= 10e6;
    BuildSeries series;
    for (int i = 0; i < (large ? kRepetitionsLarge : kRepetitions); ++i) build_once(soup, !large, series);
    const auto add = [&](const char* method, const char* quantity, const char* unit, const Series& values) {
      table.add({"build", "organic", method, "hierarchy", parameters, quantity, unit}, values);
    };
    add("palpate", "mesh", "us", series.mesh_us);
    add("palpate", "tree", "us", series.tree_us);
    add("palpate", "time", "us", series.total_us);
    add("palpate", "memory", "bytes/triangle", series.bytes);
    add("palpate", "peak_memory", "bytes/triangle", series.peak_bytes);  // the soup in it
    add("embree", "time", "us", series.embree_us);
    add("embree", "memory", "bytes/triangle", series.embree_bytes);
    add("fcl_obbrss", "time", "us", series.fcl_us);
    add("fcl_obbrss", "memory", "bytes/triangle", series.fcl_bytes);
  }
}

}  // namespace palpate::bench
