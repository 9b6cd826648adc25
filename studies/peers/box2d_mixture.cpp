#include <box2d/box2d.h>

#include "stepped_run.h"

namespace
{

using namespace ratchet_sieve::peers;

/// A millimetre is a unit, so that disks have sizes of 1 and 2 units: Box2D is designed for 0.1 to 10. Its
/// time unit is scaled by the square root, so that gravity keeps its value and speeds stay in the expected
/// range.
constexpr double PER_METRE = 1000.0;
const double PER_SECOND = std::sqrt(PER_METRE);

/// As the manual advises.
constexpr int VELOCITY_ITERATIONS = 8;
constexpr int POSITION_ITERATIONS = 3;

class World : public b2ContactListener
{
public:
  World(const Mixture& mixture, double step, bool continuous)
      : mixture_(mixture), step_(step), world_(b2Vec2(0.0F, static_cast<float>(-mixture.gravity)))
  {
    world_.SetAllowSleeping(false);
    world_.SetContinuousPhysics(continuous);
    world_.SetContactListener(this);
    addBase();
    for (const Disk& disk : mixture.disks)
      addDisk(disk);
  }

  void step(long long k)
  {
    // Moves the base to its position at the end of the step.
    const double y = mixture_.displacement(static_cast<double>(k + 1) * step_) * PER_METRE;
    const double dt = step_ * PER_SECOND;
    const double speed = (y - static_cast<double>(base_->GetPosition().y)) / dt;
    base_->SetLinearVelocity(b2Vec2(0.0F, static_cast<float>(speed)));
    world_.Step(static_cast<float>(dt), VELOCITY_ITERATIONS, POSITION_ITERATIONS);
  }

  Point place(std::size_t i) const
  {
    const b2Vec2 at = disks_[i]->GetPosition();
    return {static_cast<double>(at.x) / PER_METRE, static_cast<double>(at.y) / PER_METRE};
  }

  void moveTo(std::size_t i, const Point& to, bool stop)
  {
    disks_[i]->SetTransform(inUnits(to), disks_[i]->GetAngle());
    if (stop)
      disks_[i]->SetLinearVelocity(b2Vec2_zero);
  }

  std::uint64_t contacts() const { return contacts_; }

  void BeginContact(b2Contact*) override { ++contacts_; }

private:
  static b2Vec2 inUnits(const Point& point)
  {
    return {static_cast<float>(point.x * PER_METRE), static_cast<float>(point.y * PER_METRE)};
  }

  /// Box2D uses the larger e of two and the geometric mean of two mu: both are the scene's.
  b2FixtureDef fixture(const b2Shape& shape) const
  {
    b2FixtureDef definition;
    definition.shape = &shape;
    definition.friction = static_cast<float>(mixture_.friction);
    definition.restitution = static_cast<float>(mixture_.restitution);
    definition.restitutionThreshold = 0.0F;  // The default, 1 unit/s, is 0.03 m/s here.
    return definition;
  }

  /// A chain is solid on one side, with smooth joints between its edges.
  void addBase()
  {
    b2BodyDef definition;
    definition.type = b2_kinematicBody;
    base_ = world_.CreateBody(&definition);
    std::vector<b2Vec2> points;
    for (auto point = mixture_.outline.rbegin(); point != mixture_.outline.rend(); ++point)
      points.push_back(inUnits(*point));  // From right to left, so that the free side is on the right.
    b2ChainShape chain;
    chain.CreateChain(points.data(), static_cast<int32>(points.size()), points.front() + b2Vec2(1.0F, 0.0F),
                      points.back() - b2Vec2(1.0F, 0.0F));
    const b2FixtureDef definition_of_chain = fixture(chain);
    base_->CreateFixture(&definition_of_chain);
  }

  void addDisk(const Disk& disk)
  {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = inUnits({disk.x, disk.y});
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(disk.radius * PER_METRE);
    b2FixtureDef definition_of_circle = fixture(circle);
    const auto mass = static_cast<float>(disk.mass * 1000.0);  // in grams
    definition_of_circle.density = mass / (b2_pi * circle.m_radius * circle.m_radius);
    disks_.push_back(world_.CreateBody(&definition));
    disks_.back()->CreateFixture(&definition_of_circle);
  }

  const Mixture& mixture_;
  double step_;
  b2World world_;
  b2Body* base_ = nullptr;
  std::vector<b2Body*> disks_;
  std::uint64_t contacts_ = 0;
};

}  // namespace

int main(int argc, char** argv)
{
  const nlohmann::json run = readRun(argc, argv);
  const Mixture mixture = run["mixture"];
  World world(mixture, run["step"], run["continuous"]);
  SteppedRun<World>(world, mixture, run)
      .run(std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
           std::to_string(b2_version.revision));
}
