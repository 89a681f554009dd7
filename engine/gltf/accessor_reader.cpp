#include "engine/gltf/accessor_reader.h"

#include <cstring>
#include <limits>
#include <string>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/component_type.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

// An accessor without a bufferView has no bytes that would bound its length.
constexpr std::uint64_t kMostZeros = 1ull << 24;

// Where the elements of an accessor, or of one part of a sparse accessor, lie.
struct Elements {
  ViewBytes view;
  std::uint64_t offset;
  std::uint64_t count;
  std::uint32_t width;
  int component_type;
  bool normalized;
};

template <class Out, class T>
Out converted(T value, bool normalized) {
  if constexpr (std::is_same_v<Out, double>) {
    return number_of(value, normalized);
  } else {
    return static_cast<Out>(value);
  }
}

std::uint64_t checked_stride(const Elements& source, std::uint64_t element_bytes) {
  const std::uint64_t stride = source.view.stride == 0 ? element_bytes : source.view.stride;
  if (stride < element_bytes)
    fail(ErrorCode::kBadFormat, "stride ", stride, " is shorter than an element of ", element_bytes,
         " bytes");
  const std::uint64_t last = saturated_product(source.count - 1, stride);
  const std::uint64_t size = source.view.bytes.size();
  if (!range_fits(source.offset, last, size) || !range_fits(source.offset + last, element_bytes, size))
    fail(ErrorCode::kBadFormat, source.count, " elements at byte ", source.offset, " reach past the ", size,
         " bytes of the bufferView");
  return stride;
}

template <class Out>
std::vector<Out> gather(const Elements& source, LoadTally& tally) {
  if (source.count == 0) return {};
  return with_component_type(source.component_type, [&]<class T>(T) {
    const std::uint64_t stride = checked_stride(source, sizeof(T) * source.width);
    std::vector<Out> values(source.count * source.width);
    tally.decoded_bytes += values.size() * sizeof(T);
    Out* out = values.data();
    for (std::uint64_t i = 0; i < source.count; ++i) {
      const std::byte* element = source.view.bytes.data() + source.offset + i * stride;
      for (std::uint32_t k = 0; k < source.width; ++k) {
        T value;  // by memcpy: a hostile offset need not be aligned
        std::memcpy(&value, element + k * sizeof(T), sizeof(T));
        *out++ = converted<Out>(value, source.normalized);
      }
    }
    return values;
  });
}

bool is_index_type(int type) {
  return type == kUint8 || type == kUint16 || type == kUint32;
}

void check_index_type(int type) {
  if (!is_index_type(type)) fail(ErrorCode::kBadFormat, "component type ", type, " cannot be an index");
}

void check_width(const tinygltf::Accessor& accessor, std::uint32_t width) {
  const int actual = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (actual != static_cast<int>(width))
    fail(ErrorCode::kBadFormat, "elements of ", actual, " numbers instead of ", width);
}

void check_index_values(const std::vector<std::uint32_t>& indices, int component_type) {
  const std::uint32_t restart = component_type == kUint8    ? std::numeric_limits<std::uint8_t>::max()
                                : component_type == kUint16 ? std::numeric_limits<std::uint16_t>::max()
                                                            : std::numeric_limits<std::uint32_t>::max();
  for (const std::uint32_t index : indices) {
    if (index == restart) fail(ErrorCode::kBadFormat, "index ", index, " is the primitive-restart value");
  }
}

}  // namespace

const tinygltf::Accessor& AccessorReader::accessor(int index) const {
  const std::vector<tinygltf::Accessor>& accessors = document_.model.accessors;
  if (index < 0 || static_cast<std::size_t>(index) >= accessors.size())
    fail(ErrorCode::kBadFormat, "accessor ", index, " does not exist");
  return accessors[static_cast<std::size_t>(index)];
}

AttributeTable AccessorReader::table(int index, std::uint32_t width) {
  const tinygltf::Accessor& source = accessor(index);
  return within("accessor", static_cast<std::size_t>(index), [&] {
    check_width(source, width);
    if (source.componentType == kUint32)
      fail(ErrorCode::kBadFormat, "32-bit integers cannot be a vertex attribute");
    return AttributeTable{width, read<double>(source, width)};
  });
}

std::shared_ptr<const AttributeTable> AccessorReader::positions(int index) {
  if (index != cached_index_ || !cached_) {
    cached_.reset();  // first, so that two of them are never held
    cached_ = std::make_shared<const AttributeTable>(table(index, 3));
    cached_index_ = index;
  }
  return cached_;
}

std::vector<std::uint32_t> AccessorReader::indices(int index) {
  const tinygltf::Accessor& source = accessor(index);
  return within("accessor", static_cast<std::size_t>(index), [&] {
    check_width(source, 1);
    check_index_type(source.componentType);
    std::vector<std::uint32_t> values = read<std::uint32_t>(source, 1);
    check_index_values(values, source.componentType);
    return values;
  });
}

template <class Out>
std::vector<Out> AccessorReader::read(const tinygltf::Accessor& accessor, std::uint32_t width) {
  budget_.take_elements(accessor.count);
  std::vector<Out> values;
  if (accessor.bufferView >= 0) {
    values = gather<Out>({buffers_.view(accessor.bufferView), accessor.byteOffset, accessor.count, width,
                          accessor.componentType, accessor.normalized},
                         budget_.tally);
  } else {
    if (accessor.count > kMostZeros)
      fail(ErrorCode::kLimit, accessor.count, " elements without a bufferView, at most ", kMostZeros,
           " are allowed");
    values.assign(accessor.count * width, Out{});
  }
  if (accessor.sparse.isSparse) patch(accessor, width, values);
  return values;
}

template <class Out>
void AccessorReader::patch(const tinygltf::Accessor& accessor, std::uint32_t width,
                           std::vector<Out>& values) {
  const auto& sparse = accessor.sparse;
  check_index_type(sparse.indices.componentType);
  const auto count = static_cast<std::uint64_t>(sparse.count);
  budget_.take_elements(count);
  const auto rows = gather<std::uint32_t>(
      {buffers_.view(sparse.indices.bufferView), static_cast<std::uint64_t>(sparse.indices.byteOffset), count,
       1, sparse.indices.componentType, false},
      budget_.tally);
  const auto changes = gather<Out>(
      {buffers_.view(sparse.values.bufferView), static_cast<std::uint64_t>(sparse.values.byteOffset), count,
       width, accessor.componentType, accessor.normalized},
      budget_.tally);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] >= accessor.count)
      fail(ErrorCode::kBadFormat, "sparse index ", rows[i], " is past the last element of ", accessor.count);
    std::copy_n(changes.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                values.begin() + static_cast<std::ptrdiff_t>(std::size_t{rows[i]} * width));
  }
}

}  // namespace palpate::gltf
