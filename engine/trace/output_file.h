#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/base/result.h"

namespace palpate {

// A file that is written from its beginning.
class OutputFile {
 public:
  // Makes it or opens it as it is. One that was made is removed again if it never begins. Errors:
  // kFileNotFound (no such folder), kFileWrite.
  static Result<OutputFile> create(const std::string& path);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // In place of all that it held; then more may be written. After an error it is as it was, if its file
  // system can set room aside. Errors: kFileWrite.
  Status begin(std::span<const std::byte> bytes);

  // Errors: kFileWrite.
  Status write(std::span<const std::byte> bytes);
  Status close();  // does nothing if it is closed

 private:
  OutputFile(std::string path, int descriptor, bool is_new)
      : path_(std::move(path)), descriptor_(descriptor), is_needless_(is_new) {}

  std::string path_;
  int descriptor_;    // -1: closed
  bool is_needless_;  // it was made, and did not begin
};

}  // namespace palpate
