#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/snch/model.h"

namespace palpate {

// A model made from a soup; throws std::runtime_error with the reason if it cannot be.
std::shared_ptr<const Model> make_model(const TriangleSoup& soup, const MeshOptions& options = {});

// A generated model by its name in the catalogue, scaled about its origin.
std::shared_ptr<const Model> asset_model(const std::string& name, double scale = 1.0);

// The folder that PALPATE_DATA names.
std::optional<std::string> data_folder();

// A glTF file, scaled about its origin.
std::shared_ptr<const Model> file_model(const std::string& path, double scale = 1.0);

// A glTF file below PALPATE_DATA, scaled about its origin.
std::shared_ptr<const Model> data_model(const std::string& file, double scale = 1.0);

TriangleSoup scaled(TriangleSoup soup, double scale);

}  // namespace palpate
