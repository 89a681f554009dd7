#include "engine/gltf/draco_mesh.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/mesh/mesh.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstdint>
#include <utility>

#include "engine/gltf/component_type.h"
#include "engine/gltf/load_error.h"

namespace palpate::gltf {
namespace {

constexpr std::uint16_t kBitstreamVersion =
    DRACO_BITSTREAM_VERSION(2, 2);  // the one that the extension names

[[noreturn]] void damaged() {
  fail(ErrorCode::kBadFormat, "the Draco stream is damaged");
}

void require(bool decoded) {
  if (!decoded) damaged();
}

void init(draco::DecoderBuffer& buffer, std::span<const std::byte> stream) {
  buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
}

struct StatedCounts {
  std::uint32_t faces = 0;
  std::uint32_t points = 0;
};

void skip_metadata(draco::DecoderBuffer& buffer, const draco::DracoHeader& header) {
  if ((header.flags & METADATA_FLAG_MASK) == 0) return;
  draco::GeometryMetadata metadata;
  require(draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata));
}

// The counts in the stream's own header (Draco bitstream specification 2.2, sections 4 to 8). The library
// takes memory for them before it can see that they are wrong.
StatedCounts read_counts(std::span<const std::byte> stream) {
  draco::DecoderBuffer buffer;
  init(buffer, stream);
  draco::DracoHeader header;
  require(draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok());
  const std::uint16_t version = DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor);
  if (version != kBitstreamVersion)
    fail(ErrorCode::kUnsupported, "Draco bitstream version ", int{header.version_major}, '.',
         int{header.version_minor}, " instead of 2.2");
  if (header.encoder_type != draco::TRIANGULAR_MESH)
    fail(ErrorCode::kBadFormat, "the Draco stream is not a mesh");
  buffer.set_bitstream_version(version);
  skip_metadata(buffer, header);

  StatedCounts counts;
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    std::uint8_t traversal = 0;
    require(buffer.Decode(&traversal));
    require(draco::DecodeVarint(&counts.points, &buffer));
    require(draco::DecodeVarint(&counts.faces, &buffer));
  } else {
    require(draco::DecodeVarint(&counts.faces, &buffer));
    require(draco::DecodeVarint(&counts.points, &buffer));
  }
  return counts;
}

std::unique_ptr<draco::Mesh> decode(std::span<const std::byte> stream) {
  draco::DecoderBuffer buffer;
  init(buffer, stream);
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  require(mesh.ok());
  return std::move(mesh).value();
}

// One row of an integer attribute. Draco's own flag for normalization is not glTF's, so raw integers are
// asked for.
bool read_integers(const draco::PointAttribute& attribute, draco::AttributeValueIndex index,
                   std::uint32_t width, const DracoFormat& format, double* row) {
  std::int64_t raw[4] = {};
  if (!attribute.ConvertValue<std::int64_t>(index, static_cast<std::int8_t>(width), raw)) return false;
  with_component_type(format.component_type, [&]<class T>(T) {
    for (std::uint32_t k = 0; k < width; ++k) row[k] = number_of(static_cast<T>(raw[k]), format.normalized);
  });
  return true;
}

bool is_float(const draco::PointAttribute& attribute) {
  return attribute.data_type() == draco::DT_FLOAT32 || attribute.data_type() == draco::DT_FLOAT64;
}

}  // namespace

DracoMesh::DracoMesh(std::span<const std::byte> stream, LoadBudget& budget) : budget_(&budget) {
  const StatedCounts counts = read_counts(stream);
  budget.require_triangles(counts.faces);
  budget.require_triangles(counts.points / 3);
  mesh_ = decode(stream);
  budget.require_triangles(mesh_->num_faces());
  budget.tally.decoded_bytes += stream.size();
}

DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

std::vector<TriangleIndices> DracoMesh::triangles() const {
  std::vector<TriangleIndices> triangles;
  triangles.reserve(mesh_->num_faces());
  for (std::uint32_t i = 0; i < mesh_->num_faces(); ++i) {
    const draco::Mesh::Face& face = mesh_->face(draco::FaceIndex(i));
    triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
  }
  return triangles;
}

AttributeTable DracoMesh::table(int unique_id, std::uint32_t width, const DracoFormat& format) const {
  const draco::PointAttribute* attribute =
      mesh_->GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
  if (attribute == nullptr) fail(ErrorCode::kBadFormat, "the Draco stream has no attribute ", unique_id);
  if (attribute->num_components() != static_cast<int>(width))
    fail(ErrorCode::kBadFormat, "Draco attribute ", unique_id, " has ", int{attribute->num_components()},
         " numbers instead of ", width);
  // glTF has none, and the library would load any byte as a bool.
  if (attribute->data_type() == draco::DT_BOOL)
    fail(ErrorCode::kBadFormat, "Draco attribute ", unique_id, " is of truth values");
  const std::uint32_t points = mesh_->num_points();
  if (!attribute->is_mapping_identity() && attribute->indices_map_size() < points) damaged();

  budget_->take_elements(points);
  AttributeTable table{width, std::vector<double>(std::size_t{points} * width)};
  for (std::uint32_t i = 0; i < points; ++i) {
    const draco::AttributeValueIndex index = attribute->mapped_index(draco::PointIndex(i));
    double* row = table.values.data() + std::size_t{i} * width;
    require(is_float(*attribute)
                ? attribute->ConvertValue<double>(index, static_cast<std::int8_t>(width), row)
                : read_integers(*attribute, index, width, format, row));
  }
  return table;
}

}  // namespace palpate::gltf
