#pragma once

#include <cstddef>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace palpate::gltf {

// Why a file cannot be read. Thrown inside this folder only: the JSON library throws too, so that
// gltf_file.cpp has to catch anyhow, and turns both into an Error.
class LoadError : public std::runtime_error {
 public:
  LoadError(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  (text << ... << parts);
  return text.str();
}

template <class... Parts>
[[noreturn]] void fail(ErrorCode code, const Parts&... parts) {
  throw LoadError(code, sentence(parts...));
}

// Does `work`; an error in it is told to be in `noun` number `index`.
template <class Work>
decltype(auto) within(const char* noun, std::size_t index, Work&& work) {
  try {
    return work();
  } catch (const LoadError& error) {
    fail(error.code(), noun, ' ', index, ": ", error.what());
  }
}

// Text of the file as a message may show it: in quotes, printable and short.
std::string quoted(std::string_view text);

}  // namespace palpate::gltf
