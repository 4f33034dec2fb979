#include "striate/platform/simulator/physics.hpp"

#include <box2d/box2d.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "striate/platform/simulator/low_shapes.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::simulator {
namespace {

// What a fixture is for: touched by the robot, seen by range finders, or both.
/// Bit of what the robot touches; Box2D's filter categories
constexpr std::uint16_t kTouchable = 1;
constexpr std::uint16_t kSeen = 2;    ///< bit of what range finders see
constexpr std::uint16_t kSmooth = 4;  ///< bit of what sends sound back like a mirror
constexpr std::uint16_t kRobot = 8;   ///< bit of the robot itself
constexpr std::uint16_t kGlass = 16;  ///< bit of what sound alone is thrown back by
/// Of everything that can be pushed against: rubber and furniture on a smooth floor (ours).
constexpr float kFriction = 0.3F;
/// kg: a P3-DX of 9 kg, three batteries, mast, cameras and computer (ours).
constexpr float kMassKg = 25.0F;
/// kg m2: that mass as a disc of 0.35 m radius; the mast's foot is narrow, the base is not (ours).
constexpr float kInertia_kg_m2 = 1.5F;
/// Faster than this a thing moves: below a person's shifting of weight, above rounding (ours).
constexpr float kMoves_m_s = 0.05F;
/// Box2D keeps 1 cm of skin round polygons; so thin, touching means touching to 2 mm.
constexpr float kSkin_m = 0.001F;
/// What the range finders see of a person: legs, not arms.
constexpr double kLegsRadius_m = 0.17;

b2Vec2 vec(Point2 p) {
  return {static_cast<float>(p.x_m), static_cast<float>(p.y_m)};
}

class NearestHit : public b2RayCastCallback {
 public:
  explicit NearestHit(Beam beam)
      : seen_(beam == Beam::sound ? kSeen | kGlass : static_cast<int>(kSeen)) {}
  float ReportFixture(b2Fixture* fixture, const b2Vec2& /*point*/, const b2Vec2& normal_in,
                      float fraction_in) override {
    const std::uint16_t category = fixture->GetFilterData().categoryBits;
    if ((category & seen_) == 0) return -1.0F;  // look through
    fraction = fraction_in;
    normal = normal_in;
    smooth = (category & kSmooth) != 0;
    return fraction_in;
  }
  float fraction = 2.0F;
  b2Vec2 normal{0.0F, 0.0F};
  bool smooth = false;

 private:
  int seen_;
};

}  // namespace

struct Physics::Parts {
  b2World world{b2Vec2(0.0F, 0.0F)};
  b2Body* robot = nullptr;
  std::vector<b2Body*> people;
  std::vector<std::string> names;  ///< a body's user data is an index into these

  void add_fixture(b2Body* body, const ConvexShape& shape, std::uint16_t category,
                   std::uint16_t meets) {
    b2FixtureDef def;
    def.filter.categoryBits = category;
    def.filter.maskBits = meets;
    def.friction = kFriction;
    def.density = 1.0F;
    b2CircleShape circle;
    b2EdgeShape edge;
    b2PolygonShape polygon;
    if (shape.corners.size() == 1) {
      circle.m_p = vec(shape.corners[0]);
      circle.m_radius = static_cast<float>(shape.radius_m);
      def.shape = &circle;
    } else if (shape.corners.size() == 2) {
      edge.SetTwoSided(vec(shape.corners[0]), vec(shape.corners[1]));
      edge.m_radius = kSkin_m;
      def.shape = &edge;
    } else {
      std::vector<b2Vec2> corners;
      for (const Point2& corner : shape.corners) corners.push_back(vec(corner));
      polygon.Set(corners.data(), static_cast<int>(corners.size()));
      polygon.m_radius = kSkin_m;
      def.shape = &polygon;
    }
    body->CreateFixture(&def);
  }

  b2Body* add_body(b2BodyType type, const std::string& name, Pose2 pose) {
    b2BodyDef def;
    def.type = type;
    def.position = vec({pose.x_m, pose.y_m});
    def.angle = static_cast<float>(pose.heading_rad);
    def.allowSleep = false;
    def.userData.pointer = names.size();
    names.push_back(name);
    return world.CreateBody(&def);
  }

  void add_static(const StaticShape& thing, std::uint16_t category) {
    add_fixture(add_body(b2_staticBody, thing.name, {}), thing.shape, category, kRobot);
  }
};

Physics::Physics(const World& world, const FloorPlan& plan, const RobotDescription& robot,
                 Pose2 start, std::size_t people)
    : parts_(std::make_unique<Parts>()) {
  for (const StaticShape& wall : wall_shapes(plan)) {
    parts_->add_static(wall, kTouchable | kSeen | kSmooth);
  }
  add_obstacles(world, plan);
  for (std::size_t i = 0; i < people; ++i) {
    b2Body* body = parts_->add_body(b2_kinematicBody, fmt::format("person_{}", i + 1), {});
    parts_->add_fixture(body, disc({}, kPersonRadius_m), kTouchable, kRobot);
    parts_->add_fixture(body, disc({}, kLegsRadius_m), kSeen, 0);
    body->SetEnabled(false);
    parts_->people.push_back(body);
  }
  parts_->robot = parts_->add_body(b2_dynamicBody, "robot", start);
  parts_->add_fixture(parts_->robot, robot_footprint(robot), kRobot, kTouchable);
  // The axle is the origin, and the wheels turn the base about it.
  b2MassData mass;
  mass.mass = kMassKg;
  mass.center.SetZero();
  mass.I = kInertia_kg_m2;
  parts_->robot->SetMassData(&mass);
}

Physics::~Physics() = default;

void Physics::add_obstacles(const World& new_ones, const FloorPlan& plan) {
  for (const StaticShape& thing : solid_shapes(new_ones, plan)) {
    parts_->add_static(thing, kTouchable);
  }
  const auto is_wall = [](const WorldObstacle& thing) { return thing.kind == ObstacleKind::wall; };
  const World rough = with_obstacles(new_ones, [&](const auto& thing) { return !is_wall(thing); });
  for (const StaticShape& thing : low_shapes(rough, plan)) parts_->add_static(thing, kSeen);
  World walls = with_obstacles(new_ones, is_wall);
  walls.pillars.clear();
  for (const StaticShape& wall : low_shapes(walls, plan)) {
    parts_->add_static(wall, kSeen | kSmooth);
  }
  for (const StaticShape& pane : glass_shapes(new_ones, plan)) {
    parts_->add_static(pane, kGlass | kSmooth);
  }
}

void Physics::step(double dt_s, double forward_m_s, double turn_rad_s,
                   const std::vector<PersonBody>& people) {
  for (std::size_t i = 0; i < parts_->people.size() && i < people.size(); ++i) {
    b2Body* body = parts_->people[i];
    if (body->IsEnabled() != people[i].present) body->SetEnabled(people[i].present);
    if (!people[i].present) continue;
    body->SetTransform(vec(people[i].at), 0.0F);
    body->SetLinearVelocity(vec({people[i].velocity_x_m_s, people[i].velocity_y_m_s}));
  }
  const double heading = parts_->robot->GetAngle() + turn_rad_s * dt_s / 2;
  parts_->robot->SetLinearVelocity(
      vec({forward_m_s * std::cos(heading), forward_m_s * std::sin(heading)}));
  parts_->robot->SetAngularVelocity(static_cast<float>(turn_rad_s));
  parts_->world.Step(static_cast<float>(dt_s), 8, 3);
}

void Physics::put_robot(const Pose2& pose) {
  parts_->robot->SetTransform(vec({pose.x_m, pose.y_m}), static_cast<float>(pose.heading_rad));
}

Pose2 Physics::robot() const {
  const b2Vec2& at = parts_->robot->GetPosition();
  return {at.x, at.y, wrap_angle(parts_->robot->GetAngle())};
}

double Physics::forward_m_s() const {
  const b2Vec2& v = parts_->robot->GetLinearVelocity();
  const double heading = parts_->robot->GetAngle();
  return v.x * std::cos(heading) + v.y * std::sin(heading);
}

double Physics::turn_rad_s() const {
  return parts_->robot->GetAngularVelocity();
}

std::vector<Touch> Physics::touches() const {
  std::vector<Touch> touches;
  for (const b2ContactEdge* edge = parts_->robot->GetContactList(); edge != nullptr;
       edge = edge->next) {
    if (!edge->contact->IsTouching()) continue;
    b2Body* other = edge->other;
    touches.push_back({parts_->names[other->GetUserData().pointer],
                       other->GetLinearVelocity().Length() > kMoves_m_s});
  }
  return touches;
}

RayHit Physics::ray(Point2 from, double heading_rad, double range_m, Beam beam) const {
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  const b2Vec2 start = vec(from);
  const b2Vec2 end = vec({from.x_m + range_m * c, from.y_m + range_m * s});
  NearestHit nearest(beam);
  parts_->world.RayCast(&nearest, start, end);
  if (nearest.fraction > 1.0F) return {std::numeric_limits<double>::infinity(), 1.0, false};
  return {range_m * static_cast<double>(nearest.fraction),
          std::abs(nearest.normal.x * c + nearest.normal.y * s), nearest.smooth};
}

}  // namespace striate::simulator
