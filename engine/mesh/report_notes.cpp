#include "engine/mesh/report_notes.h"

namespace palpate {

std::string counted(std::uint64_t count, const std::string& singular, const std::string& plural) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  text += ' ';
  return text += count == 1 ? singular : plural;
}

namespace {

void note_repairs(MeshReport& report) {
  std::vector<std::string>& notes = report.notes;
  if (report.degenerate_triangles > 0)
    notes.push_back("Dropped " + counted(report.degenerate_triangles, "triangle", "triangles") +
                    " without area.");
  if (report.split_triangles > 0)
    notes.push_back("Split " + counted(report.split_triangles, "triangle", "triangles") +
                    " beside those without area, so that no seam opens.");
  if (report.duplicate_triangles > 0)
    notes.push_back("Dropped " + counted(report.duplicate_triangles, "triangle", "triangles") +
                    " with the same vertices as an earlier one.");
  if (report.reversed_triangles > 0)
    notes.push_back("Reversed " + counted(report.reversed_triangles, "triangle", "triangles") +
                    " to agree with their neighbours or to face outward.");
  if (report.flipped_components > 0)
    notes.push_back("Turned " + counted(report.flipped_components, "closed component", "closed components") +
                    " that faced the wrong way.");
}

void note_defects(MeshReport& report) {
  const SurfaceCounts& surface = report.final;
  std::vector<std::string>& notes = report.notes;
  if (surface.boundary_edges > 0)
    notes.push_back(counted(surface.boundary_edges, "boundary edge", "boundary edges") +
                    ": the surface is open there and is touched from both sides along them.");
  if (surface.nonmanifold_edges > 0)
    notes.push_back(counted(surface.nonmanifold_edges, "edge has", "edges have") +
                    " more than two triangles.");
  if (surface.inconsistent_edges > 0)
    notes.push_back("The triangles at " + counted(surface.inconsistent_edges, "edge", "edges") +
                    " are wound against each other.");
}

}  // namespace

void add_notes(MeshReport& report) {
  note_repairs(report);
  note_defects(report);
}

}  // namespace palpate
