#include "samples/cli/trajectory.h"

#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "samples/cli/failure.h"
#include "samples/cli/numbers.h"

namespace palpate::cli {
namespace {

constexpr std::string_view kHeader = "t,px,py,pz,qx,qy,qz,qw";
constexpr std::size_t kColumns = 8;

using Row = std::array<double, kColumns>;

// False unless `line` is eight finite numbers between commas.
bool parse_row(std::string_view line, Row& row) {
  for (std::size_t column = 0; column < kColumns; ++column) {
    const std::size_t comma = line.find(',');
    const bool last = column + 1 == kColumns;
    if ((comma == std::string_view::npos) != last) return false;
    const std::optional<double> number = parse_number(line.substr(0, comma));
    if (!number || !std::isfinite(*number)) return false;
    row[column] = *number;
    if (!last) line.remove_prefix(comma + 1);
  }
  return true;
}

TimedPose pose_of(const Row& row) {
  return {row[0], {{row[1], row[2], row[3]}, {row[4], row[5], row[6], row[7]}}};
}

bool read_line(std::istream& file, std::string& line) {
  if (!std::getline(file, line)) return false;
  if (line.ends_with('\r')) line.pop_back();
  return true;
}

}  // namespace

std::vector<TimedPose> read_trajectory(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Failure(path + ": cannot be read");
  std::string line;
  if (!read_line(file, line) || line != kHeader) {
    throw Failure(path + ":1: the header is not " + std::string(kHeader));
  }
  std::vector<TimedPose> poses;
  for (std::size_t number = 2; read_line(file, line); ++number) {
    if (line.empty()) continue;
    Row row;
    if (!parse_row(line, row))
      throw Failure(path + ":" + std::to_string(number) + ": not eight finite numbers");
    poses.push_back(pose_of(row));
  }
  if (file.bad()) throw Failure(path + ": cannot be read to its end");
  if (poses.empty()) throw Failure(path + ": has no poses");
  return poses;
}

}  // namespace palpate::cli
