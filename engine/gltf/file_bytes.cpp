#include "engine/gltf/file_bytes.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <system_error>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {

std::vector<std::byte> read_file_bytes(const std::filesystem::path& path, LoadBudget& budget) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::status_known(status)) fail(ErrorCode::kFileRead, error.message());
  if (!std::filesystem::exists(status)) fail(ErrorCode::kFileNotFound, "no such file");
  // Opening a pipe or a device could block forever.
  if (!std::filesystem::is_regular_file(status)) fail(ErrorCode::kFileRead, "not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) fail(ErrorCode::kFileRead, error.message());
  budget.take_bytes(size);

  // A stream of C++ would not tell a lack of memory from a file that cannot be opened.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file && errno == ENOMEM) throw std::bad_alloc();
  if (!file) fail(ErrorCode::kFileRead, "the file cannot be opened");
  std::vector<std::byte> bytes(size);
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
    fail(ErrorCode::kFileRead, "the file ended while it was read");
  budget.tally.read_bytes += size;
  return bytes;
}

}  // namespace palpate::gltf
