#include "engine/trace/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace palpate {
namespace {

Error failure(ErrorCode code, const std::string& path, const std::string& reason) {
  return {code, path + ": cannot be read: " + reason};
}

Error failure(const std::string& path, int reason) {
  const ErrorCode code = reason == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileRead;
  return failure(code, path, std::generic_category().message(reason));
}

}  // namespace

Result<InputFile> InputFile::open(const std::string& path) {
  // Not to wait for whoever writes into a pipe.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return failure(path, errno);
  InputFile file(path, descriptor);
  struct stat status;
  if (::fstat(descriptor, &status) != 0) return failure(path, errno);
  if (!S_ISREG(status.st_mode)) return failure(ErrorCode::kFileRead, path, "it is no regular file");
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  return file;
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status InputFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure(path_, errno);
    if (got == 0) return failure(ErrorCode::kFileRead, path_, "it was made shorter meanwhile");
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
  return Done{};
}

}  // namespace palpate
