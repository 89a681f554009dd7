#pragma once

#include <cstdint>
#include <span>

namespace palpate::fuzz {

// Each takes any bytes, drives the C ABI with them, and throws Broken if it breaks a promise.
void gltf(std::span<const std::uint8_t> bytes);        // bytes of a .gltf or .glb file, as a model
void gltf_scene(std::span<const std::uint8_t> bytes);  // the same, as the bodies of a scene
void triangles(std::span<const std::uint8_t> bytes);   // arrays of a caller, and poses of what comes of them
void calls(std::span<const std::uint8_t> bytes);       // sequences of calls
void trace(std::span<const std::uint8_t> bytes);       // bytes of a trace
void hid(std::span<const std::uint8_t> bytes);         // what a device on the bus answers and reports

}  // namespace palpate::fuzz
