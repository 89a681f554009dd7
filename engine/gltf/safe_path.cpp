#include "engine/gltf/safe_path.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(std::string_view uri, const char* why) {
  fail(ErrorCode::kUnsafePath, "URI ", quoted(uri), ' ', why);
}

// RFC 3986, section 2.1.
std::string decode_percent(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* first = uri.data() + i + 1;
    const bool encoded =
        uri[i] == '%' && i + 2 < uri.size() && std::from_chars(first, first + 2, byte, 16).ptr == first + 2;
    text += encoded ? static_cast<char>(byte) : uri[i];
    if (encoded) i += 2;
  }
  return text;
}

void check_text(std::string_view uri, std::string_view text) {
  if (text.empty()) refuse(uri, "names no file");
  if (text.find('\0') != text.npos) refuse(uri, "holds a zero byte");
  if (text.find('\\') != text.npos) refuse(uri, "holds a backslash");
  if (text.front() == '/') refuse(uri, "is an absolute path");
  // A colon before the first slash ends a scheme or a drive letter.
  if (text.substr(0, text.find('/')).find(':') != text.npos) refuse(uri, "has a scheme or a drive letter");
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end() && rest != path.end();
}

}  // namespace

fs::path resolve_uri(std::string_view uri, const fs::path& folder) {
  const std::string text = decode_percent(uri);
  check_text(uri, text);
  const fs::path relative(std::u8string(text.begin(), text.end()));
  if (std::find(relative.begin(), relative.end(), "..") != relative.end())
    refuse(uri, "leads out of the folder");

  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) fail(ErrorCode::kFileNotFound, "folder ", quoted(folder.string()), ": ", error.message());
  fs::path path = fs::weakly_canonical(root / relative, error);
  if (error) fail(ErrorCode::kFileRead, "URI ", quoted(uri), ": ", error.message());
  if (!is_inside(path, root)) refuse(uri, "leads out of the folder");
  return path;
}

}  // namespace palpate::gltf
