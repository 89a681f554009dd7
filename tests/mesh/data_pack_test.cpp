// The table of counts in MANIFEST.md of the data pack was made by other means; every row must be reproduced.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/mesh/soups.h"
#include "tests/support/simple_glb.h"

namespace palpate {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? ""
                                               : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return cells;
}

std::uint64_t number(std::string text) {
  std::erase(text, ',');
  return std::stoull(text);
}

// The rows of counts: file, triangles, vertices stored, welded, watertight, orientation, edges non-manifold,
// boundary, inconsistent, triangles degenerate, duplicate, components, …
std::vector<std::vector<std::string>> rows_of_counts(const std::string& folder) {
  std::ifstream manifest(folder + "/MANIFEST.md");
  std::vector<std::vector<std::string>> rows;
  bool in_table = false;
  for (std::string line; std::getline(manifest, line);) {
    if (line.starts_with("| file |")) in_table = line.find("vertices welded") != std::string::npos;
    if (!in_table || line.find(".glb |") == std::string::npos) continue;
    std::vector<std::string> cells = cells_of(line);
    cells.erase(cells.begin());
    rows.push_back(cells);
  }
  return rows;
}

std::string name_of(Orientation orientation) {
  switch (orientation) {
    case Orientation::kOutward:
      return "out";
    case Orientation::kInward:
      return "IN";
    case Orientation::kMixed:
      return "mixed";
    case Orientation::kOpen:
      break;
  }
  return "–";
}

void expect_row(const std::vector<std::string>& row, const MeshReport& report) {
  const SurfaceCounts& source = report.source;
  EXPECT_EQ(source.triangles, number(row[1]));
  EXPECT_EQ(report.stored_vertices, number(row[2]));
  EXPECT_EQ(source.vertices, number(row[3]));
  EXPECT_EQ(source.watertight() ? "yes" : "no", row[4]);
  EXPECT_EQ(name_of(source.orientation), row[5]);
  EXPECT_EQ(source.nonmanifold_edges, number(row[6]));
  EXPECT_EQ(source.boundary_edges, number(row[7]));
  EXPECT_EQ(source.inconsistent_edges, number(row[8]));
  EXPECT_EQ(report.degenerate_triangles, number(row[9]));
  EXPECT_EQ(report.duplicate_triangles, number(row[10]));
  EXPECT_EQ(source.components, number(row[11]));
}

void expect_clean(const MeshReport& report, const Cleaned& again) {
  EXPECT_EQ(report.final.inconsistent_edges, 0u);
  if (report.source.watertight()) {
    EXPECT_EQ(report.final.orientation, Orientation::kOutward);
  }
  EXPECT_EQ(again.report.degenerate_triangles, 0u);
  EXPECT_EQ(again.report.duplicate_triangles, 0u);
  EXPECT_EQ(again.report.reversed_triangles, 0u);
  EXPECT_EQ(again.report.final.edges, report.final.edges);
}

TriangleSoup soup_of(const CleanTriangles& surface) {
  TriangleSoup soup;
  for (const Vec3& position : surface.positions)
    soup.positions.push_back(surface.frame.metres(DVec3(position)));
  soup.triangles = surface.triangles;
  soup.double_sided = surface.double_sided;
  return soup;
}

TEST(DataPack, EveryRowOfCounts) {
  const char* folder = std::getenv("PALPATE_DATA");
  if (!folder) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const std::vector<std::vector<std::string>> rows = rows_of_counts(folder);
  EXPECT_EQ(rows.size(), 27u);
  for (const std::vector<std::string>& row : rows) {
    SCOPED_TRACE(row[0]);
    const Cleaned result = cleaned(SimpleGlb(std::string(folder) + "/" + row[0]).soup());
    expect_row(row, result.report);
    expect_clean(result.report, cleaned(soup_of(result.surface)));
  }
}

TEST(DataPack, ShuffledWindingOfAClosedSurfaceIsRepaired) {
  const char* folder = std::getenv("PALPATE_DATA");
  if (!folder) GTEST_SKIP() << "skipped: PALPATE_DATA";
  const TriangleSoup soup = SimpleGlb(std::string(folder) + "/oblong_inconsistent_winding.glb").soup();
  EXPECT_EQ(cleaned(soup).report.final.orientation, Orientation::kOutward);
}

}  // namespace
}  // namespace palpate
