#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/base/result.h"

namespace palpate {

// A file that is read anywhere.
class InputFile {
 public:
  // Errors: kFileNotFound, kFileRead (also for what is no file, such as a folder).
  static Result<InputFile> open(const std::string& path);

  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&&) = delete;
  ~InputFile();

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  // Fills `bytes` from `offset` on, which lies with them within size(). Errors: kFileRead.
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const;

 private:
  InputFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;  // -1: moved from
  std::uint64_t size_ = 0;
};

}  // namespace palpate
