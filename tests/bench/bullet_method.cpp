#include "tests/bench/bullet_method.h"

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

namespace palpate::bench {
namespace {

// Bullet is made for bodies of some metres, with tolerances that are not relative.
constexpr double kBulletDiagonal = 10.0;

btVector3 bullet_vector(const DVec3& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

DVec3 vector_of(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

struct Body {
  btTriangleMesh mesh;
  std::unique_ptr<btGImpactMeshShape> shape;
  btCollisionObject object;

  Body(const Mesh& source, double scale, double margin) {
    for (const TriangleIndices& triangle : source.triangles) {
      btVector3 corner[3];
      for (int k = 0; k < 3; ++k)
        corner[k] = bullet_vector(scale * source.frame.metres(source.position(triangle[k])));
      mesh.addTriangle(corner[0], corner[1], corner[2]);
    }
    shape = std::make_unique<btGImpactMeshShape>(&mesh);
    shape->setMargin(static_cast<btScalar>(margin));
    shape->updateBound();
    object.setCollisionShape(shape.get());
  }
};

// Keeps the deepest contact.
struct Deepest : btCollisionWorld::ContactResultCallback {
  std::size_t count = 0;
  btScalar depth = 0;
  DVec3 point{0.0};
  DVec3 towards_tool{0.0};

  btScalar addSingleResult(btManifoldPoint& contact, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    ++count;
    if (-contact.getDistance() > depth) {
      depth = -contact.getDistance();
      point = vector_of(contact.getPositionWorldOnB());
      towards_tool = -vector_of(contact.m_normalWorldOnB);
    }
    return 0;
  }
};

class BulletContact : public Method {
 public:
  explicit BulletContact(const ModelPair& pair)
      : scale_(kBulletDiagonal / pair.a->bounds().diagonal()),
        cutoff_(pair.cutoff),
        centre_(pair.b->centre()),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_),
        a_(pair.a->mesh(), scale_, 0.5 * scale_ * pair.cutoff),
        b_(pair.b->mesh(), scale_, 0.5 * scale_ * pair.cutoff) {
    dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, GIMPACT_SHAPE_PROXYTYPE, &gimpact_);
  }

  std::string name() const override { return "bullet_gimpact"; }
  std::string returns() const override { return "the deepest of clipped triangle pairs"; }
  std::size_t every() const override { return 10; }

  void update(const Pose& a_from_b) override {
    const DMat3& r = a_from_b.rotation;
    const btMatrix3x3 rotation(
        static_cast<btScalar>(r[0][0]), static_cast<btScalar>(r[1][0]), static_cast<btScalar>(r[2][0]),
        static_cast<btScalar>(r[0][1]), static_cast<btScalar>(r[1][1]), static_cast<btScalar>(r[2][1]),
        static_cast<btScalar>(r[0][2]), static_cast<btScalar>(r[1][2]), static_cast<btScalar>(r[2][2]));
    b_.object.setWorldTransform(btTransform(rotation, bullet_vector(scale_ * a_from_b.translation)));
    reference_ = a_from_b * centre_;
    deepest_ = {};
    world_.contactPairTest(&a_.object, &b_.object, deepest_);
  }

  Outcome outcome() const override {
    std::vector<SpringContact> contacts;
    if (deepest_.count > 0)
      contacts.push_back({deepest_.point / scale_, deepest_.towards_tool,
                          std::max(0.0, cutoff_ - deepest_.depth / scale_), 1.0});
    return outcome_of(contacts, cutoff_, reference_);
  }

 private:
  double scale_;
  double cutoff_;
  DVec3 centre_;
  DVec3 reference_{0.0};
  btDefaultCollisionConfiguration configuration_;
  btGImpactCollisionAlgorithm::CreateFunc gimpact_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  Body a_, b_;
  Deepest deepest_;
};

}  // namespace

std::unique_ptr<Method> bullet_method(const ModelPair& pair) {
  return std::make_unique<BulletContact>(pair);
}

}  // namespace palpate::bench
