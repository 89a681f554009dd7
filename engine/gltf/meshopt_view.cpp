#include "engine/gltf/meshopt_view.h"

#include <meshoptimizer.h>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

// The densest a stream can be: version 1 of the vertex codec spends 2 bits on 256 equal bytes, version 0
// on 16.
constexpr std::uint64_t kHighestRatio = 1024;

// meshoptimizer asserts these; they are the extension's own rules.
void check_stride(const MeshoptBlock& block) {
  const std::uint64_t stride = block.byte_stride;
  const bool valid = block.mode == MeshoptMode::kAttributes ? stride >= 4 && stride <= 256 && stride % 4 == 0
                                                            : stride == 2 || stride == 4;
  if (!valid) fail(ErrorCode::kBadFormat, "meshopt stride ", stride, " is not allowed");
  if (block.mode == MeshoptMode::kTriangles && block.count % 3 != 0)
    fail(ErrorCode::kBadFormat, block.count, " meshopt indices are not whole triangles");
}

int decode_stream(const MeshoptBlock& block, std::span<const std::byte> compressed,
                  std::vector<std::byte>& out) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(compressed.data());
  switch (block.mode) {
    case MeshoptMode::kAttributes:
      return meshopt_decodeVertexBuffer(out.data(), block.count, block.byte_stride, bytes, compressed.size());
    case MeshoptMode::kTriangles:
      return meshopt_decodeIndexBuffer(out.data(), block.count, block.byte_stride, bytes, compressed.size());
    case MeshoptMode::kIndices:
      return meshopt_decodeIndexSequence(out.data(), block.count, block.byte_stride, bytes,
                                         compressed.size());
  }
  return -1;
}

void apply_filter(const MeshoptBlock& block, std::vector<std::byte>& out) {
  const std::uint64_t stride = block.byte_stride;
  if (block.filter == "NONE") return;
  if (block.mode != MeshoptMode::kAttributes) fail(ErrorCode::kBadFormat, "indices have a meshopt filter");
  if (block.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(out.data(), block.count, stride);
  } else if (block.filter == "QUATERNION") {
    if (stride != 8)
      fail(ErrorCode::kBadFormat, "the quaternion filter has stride ", stride, " instead of 8");
    meshopt_decodeFilterQuat(out.data(), block.count, stride);
  } else if (block.filter == "OCTAHEDRAL") {
    if (stride != 4 && stride != 8) fail(ErrorCode::kBadFormat, "the octahedral filter has stride ", stride);
    meshopt_decodeFilterOct(out.data(), block.count, stride);
  } else {
    fail(ErrorCode::kUnsupported, "meshopt filter ", quoted(block.filter), " is not supported");
  }
}

// The low four bits of the first byte are the codec's version; the library refuses those it does not know.
bool is_newer_version(std::span<const std::byte> compressed) {
  return !compressed.empty() && (compressed[0] & std::byte{0x0f}) != std::byte{0};
}

}  // namespace

std::vector<std::byte> decode_meshopt(const MeshoptBlock& block, std::span<const std::byte> compressed,
                                      LoadBudget& budget) {
  check_stride(block);
  const std::uint64_t size = saturated_product(block.count, block.byte_stride);
  if (size > saturated_product(compressed.size(), kHighestRatio))
    fail(ErrorCode::kBadFormat, compressed.size(), " meshopt bytes cannot hold ", block.count, " elements");
  budget.take_bytes(size);
  std::vector<std::byte> out(size);
  if (decode_stream(block, compressed, out) != 0) {
    if (is_newer_version(compressed))
      fail(ErrorCode::kUnsupported, "the meshopt stream has an unknown version");
    fail(ErrorCode::kBadFormat, "the meshopt stream is damaged");
  }
  apply_filter(block, out);
  return out;
}

}  // namespace palpate::gltf
