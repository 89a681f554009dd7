#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace palpate::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Target = void (*)(std::span<const std::uint8_t>);

struct Named {
  const char* name;
  const char* corpus;  // that it shares with others of its kind
  Target target;
  int mutations;
  std::size_t random_length;  // of inputs from nothing; 0: there are none
};

constexpr Named kTargets[] = {
    {"gltf", "gltf", gltf, 3'000, 0},
    {"gltf_scene", "gltf", gltf_scene, 2'000, 0},
    {"triangles", "triangles", triangles, 300, 512},
    {"calls", "calls", calls, 300, 512},
    {"trace", "trace", trace, 1'500, 0},
#ifdef PALPATE_FUZZ_HID
    {"hid", "hid", hid, 150, 512},
#endif
};

// The inputs that tests/fuzz/corpus keeps: seeds, and every input that ever broke a promise.
std::vector<Bytes> corpus(const char* name) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PALPATE_FUZZ_CORPUS) / name))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> inputs;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return inputs;
}

Bytes random_bytes(std::mt19937& random, std::size_t most) {
  Bytes bytes(random() % (most + 1));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

void mutate(Bytes& bytes, std::mt19937& random) {
  for (std::uint32_t i = 0, count = 1 + random() % 4; i < count && !bytes.empty(); ++i) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes[at] ^= static_cast<std::uint8_t>(1u << random() % 8);
        break;
      case 2:
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      default:
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(random()));
    }
  }
}

void expect_kept(Target target, const Bytes& input, const std::string& which) {
  try {
    target(input);
  } catch (const std::exception& broken) {
    ADD_FAILURE() << which << ": not kept: " << broken.what() << "; " << input.size() << " bytes";
  }
}

class Fuzz : public testing::TestWithParam<Named> {};

TEST_P(Fuzz, TheCorpusBreaksNothing) {
  const std::vector<Bytes> inputs = corpus(GetParam().corpus);
  ASSERT_FALSE(inputs.empty());
  for (std::size_t i = 0; i < inputs.size(); ++i)
    expect_kept(GetParam().target, inputs[i], "input " + std::to_string(i));
}

// A short run of what tests/fuzz/run.sh does for long, with the same inputs every time.
TEST_P(Fuzz, MutationsBreakNothing) {
  std::vector<Bytes> seeds = corpus(GetParam().corpus);
  for (int i = 0; i < GetParam().mutations; ++i) {
    std::mt19937 random(static_cast<std::uint32_t>(i));
    Bytes input = GetParam().random_length > 0 && i % 2 ? random_bytes(random, GetParam().random_length)
                                                        : seeds[random() % seeds.size()];
    mutate(input, random);
    expect_kept(GetParam().target, input, "seed " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(kTargets),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate::fuzz
