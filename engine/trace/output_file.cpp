#include "engine/trace/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace palpate {
namespace {

Error failure(ErrorCode code, const std::string& path, int reason) {
  return {code, path + ": cannot be written: " + std::generic_category().message(reason)};
}

// Why the system refuses room for the first `size` bytes, 0 if it has it. Not every file system can tell, and
// what is no regular file, such as a pipe, has no room.
int set_aside(int descriptor, std::size_t size) {
  if (::fallocate(descriptor, 0, 0, static_cast<off_t>(size)) == 0) return 0;
  const bool is_full = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  return is_full ? errno : 0;
}

// A pipe has nothing to be rid of.
int cut(int descriptor, std::size_t size) {
  return ::ftruncate(descriptor, static_cast<off_t>(size)) == 0 || errno == EINVAL ? 0 : errno;
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::string& path) {
  constexpr int kHow = O_WRONLY | O_CLOEXEC;
  std::string name = path;  // before there is anything that would be left open
  bool is_new = true;
  int descriptor = ::open(path.c_str(), kHow | O_CREAT | O_EXCL, 0666);
  if (descriptor < 0 && errno == EEXIST) {
    is_new = false;
    descriptor = ::open(path.c_str(), kHow | O_CREAT, 0666);
  }
  if (descriptor < 0)
    return failure(errno == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileWrite, path, errno);
  return OutputFile(std::move(name), descriptor, is_new);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_needless_(std::exchange(other.is_needless_, false)) {}

OutputFile::~OutputFile() {
  if (is_needless_) ::unlink(path_.c_str());
  static_cast<void>(close());
}

// Room is taken before what was there is given up: on a full disk that stays as it was.
Status OutputFile::begin(std::span<const std::byte> bytes) {
  if (const int refused = set_aside(descriptor_, bytes.size()))
    return failure(ErrorCode::kFileWrite, path_, refused);
  if (Status written = write(bytes); !written) return written;
  if (const int refused = cut(descriptor_, bytes.size()))
    return failure(ErrorCode::kFileWrite, path_, refused);
  is_needless_ = false;
  return Done{};
}

Status OutputFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure(ErrorCode::kFileWrite, path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return Done{};
}

// Some file systems tell only here that a disk is full.
Status OutputFile::close() {
  if (descriptor_ < 0) return Done{};
  if (::close(std::exchange(descriptor_, -1)) != 0) return failure(ErrorCode::kFileWrite, path_, errno);
  return Done{};
}

}  // namespace palpate
