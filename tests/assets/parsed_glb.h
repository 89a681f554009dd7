#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/mesh/triangle_soup.h"

namespace palpate::test {

// A GLB file read back word by word, for files with tightly packed positions and uint32 indices only.
struct ParsedGlb {
  nlohmann::json document;
  std::string binary;
  TriangleSoup soup;
};

// Throws std::runtime_error on the first thing that is not as the GLB specification has it.
ParsedGlb parse_glb(const std::string& bytes);

std::string read_file(const std::string& path);

}  // namespace palpate::test
