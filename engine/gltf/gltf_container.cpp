#include "engine/gltf/gltf_container.h"

#include <cstdint>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/load_error.h"

// glTF 2.0 specification, section 4: the GLB container. All of its numbers are little-endian.

namespace palpate::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[offset + i]);
  return value;
}

struct Chunk {
  std::uint32_t type;
  std::span<const std::byte> data;
};

// Takes the first chunk off `bytes`.
Chunk take_chunk(std::span<const std::byte>& bytes) {
  if (bytes.size() < kChunkHeaderBytes)
    fail(ErrorCode::kBadFormat, "the GLB container ends inside a chunk header");
  const std::uint32_t length = little_endian(bytes, 0);
  if (!range_fits(kChunkHeaderBytes, length, bytes.size()))
    fail(ErrorCode::kBadFormat, "the GLB container ends inside a chunk of ", length, " bytes");
  const Chunk chunk{little_endian(bytes, 4), bytes.subspan(kChunkHeaderBytes, length)};
  bytes = bytes.subspan(kChunkHeaderBytes + length);
  return chunk;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);  // a common wrong padding
  return text;
}

Container open_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes) fail(ErrorCode::kBadFormat, "the GLB container ends inside its header");
  const std::uint32_t version = little_endian(bytes, 4);
  if (version != 2) fail(ErrorCode::kUnsupported, "GLB container version ", version, " instead of 2");
  const std::uint32_t length = little_endian(bytes, 8);
  if (length < kHeaderBytes || length > bytes.size())
    fail(ErrorCode::kBadFormat, "the GLB header says ", length, " bytes, the file has ", bytes.size());

  std::span<const std::byte> rest = bytes.subspan(kHeaderBytes, length - kHeaderBytes);
  const Chunk first = take_chunk(rest);
  if (first.type != kJsonChunk)
    fail(ErrorCode::kBadFormat, "the first chunk of the GLB container is not JSON");
  Container container{text_of(first.data), false, {}};
  while (!rest.empty() && !container.has_chunk) {
    const Chunk chunk = take_chunk(rest);
    if (chunk.type != kBinChunk) continue;  // extensions may add chunks
    container.has_chunk = true;
    container.chunk = chunk.data;
  }
  return container;
}

}  // namespace

Container open_container(std::span<const std::byte> bytes) {
  if (bytes.empty()) fail(ErrorCode::kBadFormat, "the file is empty");
  if (bytes.size() >= 4 && little_endian(bytes, 0) == kMagic) return open_glb(bytes);
  return {text_of(bytes), false, {}};
}

}  // namespace palpate::gltf
