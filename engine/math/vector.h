#pragma once

#define GLM_FORCE_XYZW_ONLY
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace palpate {

// Geometry is stored in single precision and decided in double precision.
using Vec3 = glm::vec3;
using DVec3 = glm::dvec3;
using DVec4 = glm::dvec4;
using DMat3 = glm::dmat3;
using DMat4 = glm::dmat4;
using DQuat = glm::dquat;

}  // namespace palpate
