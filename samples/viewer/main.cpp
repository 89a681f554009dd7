#include <algorithm>
#include <iostream>
#include <string>

#include "samples/viewer/film.h"
#include "samples/viewer/window.h"

namespace palpate::viewer {
namespace {

int complain(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  std::cerr << "palpate-viewer: " << sentence << '\n';
  return 1;
}

int run(int argc, char** argv) {
  try {
    const std::optional<Arguments> arguments = parse_arguments(argc, argv);
    if (!arguments) return 0;
    if (arguments->headless) {
      run_film(*arguments);
    } else {
      run_window(*arguments);
    }
    return 0;
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace
}  // namespace palpate::viewer

int main(int argc, char** argv) {
  return palpate::viewer::run(argc, argv);
}
