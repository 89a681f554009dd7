// palpate-make-motion A B POSES.csv: a hand that slides model B over model A, as a trajectory for `palpate
// run`. The same arguments give the same poses.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate {
namespace {

constexpr double kTick = 1e-3;

struct Arguments {
  std::string a;
  std::string b;
  std::string out;
  double scale_a = 1.0;
  double scale_b = 1.0;
  double cutoff = 0.0;   // metres
  double speed = 0.1;    // metres a second
  double seconds = 5.0;  // a pose a millisecond
  std::uint64_t seed = 1;
};

Arguments parse(CLI::App& app, int argc, char** argv) {
  Arguments arguments;
  app.add_option("a", arguments.a, "The model that stands still")->required();
  app.add_option("b", arguments.b, "The model that moves")->required();
  app.add_option("poses", arguments.out, "The CSV file to write")->required();
  app.add_option("--scale-a", arguments.scale_a, "As of palpate run")->check(CLI::PositiveNumber);
  app.add_option("--scale-b", arguments.scale_b, "As of palpate run")->check(CLI::PositiveNumber);
  app.add_option("--cutoff", arguments.cutoff, "Metres: the gap swings between 5 and 70 % of it")
      ->required()
      ->check(CLI::PositiveNumber);
  app.add_option("--speed", arguments.speed, "Metres a second")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--seconds", arguments.seconds, "A pose a millisecond")
      ->capture_default_str()
      ->check(CLI::Range(kTick, 3600.0));
  app.add_option("--seed", arguments.seed, "Another one is another motion")->capture_default_str();
  app.parse(argc, argv);
  return arguments;
}

void write(const std::vector<Pose>& motion, const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) throw std::runtime_error(path + ": cannot be written");
  std::fputs("t,px,py,pz,qx,qy,qz,qw\n", file);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const DVec3& p = motion[i].translation;
    const DQuat q = glm::quat_cast(motion[i].rotation);
    std::fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", kTick * static_cast<double>(i),
                 p.x, p.y, p.z, q.x, q.y, q.z, q.w);
  }
  const bool written = !std::ferror(file);
  if (std::fclose(file) != 0 || !written) throw std::runtime_error(path + ": cannot be written");
}

// Of the centre of B's bounds from one pose to the next, metres a second in ascending order.
std::vector<double> speeds(const std::vector<Pose>& motion, const Model& b) {
  std::vector<double> ascending;
  for (std::size_t i = 1; i < motion.size(); ++i)
    ascending.push_back(glm::length(motion[i] * b.centre() - motion[i - 1] * b.centre()) / kTick);
  std::sort(ascending.begin(), ascending.end());
  return ascending;
}

void make_motion(const Arguments& arguments) {
  const auto a = file_model(arguments.a, arguments.scale_a);
  const auto b = file_model(arguments.b, arguments.scale_b);
  Random random(arguments.seed);
  const int ticks = static_cast<int>(arguments.seconds / kTick + 0.5);
  const auto motion = sliding_motion(*a, *b, arguments.cutoff, arguments.speed, ticks, random);
  write(motion, arguments.out);
  const std::vector<double> moved = speeds(motion, *b);
  std::printf("%zu poses", motion.size());
  if (!moved.empty())
    std::printf("; the middle of B moves at p50 %.3f, max %.3f m/s", moved[moved.size() / 2], moved.back());
  std::printf("\n");
}

int run(int argc, char** argv) {
  CLI::App app("Slides one model over another");
  app.name("palpate-make-motion");
  try {
    make_motion(parse(app, argc, argv));
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate-make-motion: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace palpate

int main(int argc, char** argv) {
  return palpate::run(argc, argv);
}
