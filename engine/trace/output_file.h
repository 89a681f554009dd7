#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/base/result.h"

namespace palpate {

// A file that is written from its beginning.
class OutputFile {
 public:
  // Makes or empties it. Errors: kFileNotFound (no such folder), kFileWrite.
  static Result<OutputFile> create(const std::string& path);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // Errors: kFileWrite.
  Status write(std::span<const std::byte> bytes);
  Status close();  // does nothing if it is closed

 private:
  OutputFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;  // -1: closed
};

}  // namespace palpate
