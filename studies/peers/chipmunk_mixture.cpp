#include <chipmunk/chipmunk.h>

#include "stepped_run.h"

namespace
{

using namespace ratchet_sieve::peers;

/// Millimetres, so that the disks are larger than the library's length tolerances (1e-5).
constexpr double PER_METRE = 1000.0;

/// Penetration that the solver does not correct: a hundredth of the smallest radius. The default, 0.1, would
/// be a tenth.
constexpr double SLOP = 0.01;

/// Width and number of the cells: of 2, 3, 4 and 6 mm, the largest diameter was the fastest; ten cells per
/// disk.
constexpr double HASH_CELL = 4.0;
constexpr int HASH_CELLS = 5240;

/// Depth of a tooth's foot, where teeth are solid [mm].
constexpr double SOLID_DEPTH = 20.0;

class World
{
public:
  World(const Mixture& mixture, double step, bool solid)
      : mixture_(mixture), step_(step), space_(cpSpaceNew())
  {
    cpSpaceSetGravity(space_, cpv(0.0, -mixture.gravity * PER_METRE));
    cpSpaceSetCollisionSlop(space_, SLOP);
    cpSpaceUseSpatialHash(space_, HASH_CELL, HASH_CELLS);
    addBase(solid);
    for (const Disk& disk : mixture.disks)
      addDisk(disk);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_);
    handler->beginFunc = &World::onBegin;
    handler->userData = this;
  }

  ~World() { cpSpaceFree(space_); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void step(long long k)
  {
    const double end = static_cast<double>(k + 1) * step_;
    next_y_ = mixture_.displacement(end);
    cpBodySetVelocity(base_, cpv(0.0, mixture_.velocity(end) * PER_METRE));
    cpSpaceStep(space_, step_);
  }

  Point place(std::size_t i) const
  {
    const cpVect at = cpBodyGetPosition(disks_[i]);
    return {at.x / PER_METRE, at.y / PER_METRE};
  }

  void moveTo(std::size_t i, const Point& to, bool stop)
  {
    cpBodySetPosition(disks_[i], cpv(to.x * PER_METRE, to.y * PER_METRE));
    if (stop)
      cpBodySetVelocity(disks_[i], cpvzero);
  }

  std::uint64_t contacts() const { return contacts_; }

private:
  /// The library multiplies the two coefficients: each side gets the square root.
  void setContact(cpShape* shape) const
  {
    cpShapeSetElasticity(shape, std::sqrt(mixture_.restitution));
    cpShapeSetFriction(shape, std::sqrt(mixture_.friction));
    cpSpaceAddShape(space_, shape);
  }

  void addBase(bool solid)
  {
    base_ = cpSpaceAddBody(space_, cpBodyNewKinematic());
    cpBodySetUserData(base_, this);
    cpBodySetPositionUpdateFunc(base_, &World::followDrive);
    std::vector<cpVect> points;
    for (const Point& point : mixture_.outline)
      points.push_back(cpv(point.x * PER_METRE, point.y * PER_METRE));
    if (solid)
      addTeeth(points);
    else
      addSegments(points);
  }

  void addSegments(const std::vector<cpVect>& points)
  {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      cpShape* segment = cpSegmentShapeNew(base_, points[i], points[i + 1], 0.0);
      cpSegmentShapeSetNeighbors(segment, points[i == 0 ? 0 : i - 1],
                                 points[std::min(i + 2, points.size() - 1)]);
      setContact(segment);
    }
  }

  void addTeeth(const std::vector<cpVect>& points)
  {
    for (std::size_t i = 0; i + 2 < points.size(); i += 2)
    {
      const cpVect corners[] = {points[i], cpv(points[i].x, -SOLID_DEPTH), cpv(points[i + 2].x, -SOLID_DEPTH),
                                points[i + 2], points[i + 1]};
      setContact(cpPolyShapeNewRaw(base_, 5, corners, 0.0));
    }
  }

  void addDisk(const Disk& disk)
  {
    const double radius = disk.radius * PER_METRE;
    cpBody* body =
        cpSpaceAddBody(space_, cpBodyNew(disk.mass, cpMomentForCircle(disk.mass, 0.0, radius, cpvzero)));
    cpBodySetPosition(body, cpv(disk.x * PER_METRE, disk.y * PER_METRE));
    setContact(cpCircleShapeNew(body, radius, cpvzero));
    disks_.push_back(body);
  }

  /// Sets the base's position exactly from the drive instead of integrating its velocity.
  static void followDrive(cpBody* body, cpFloat)
  {
    const World& world = *static_cast<World*>(cpBodyGetUserData(body));
    cpBodySetPosition(body, cpv(0.0, world.next_y_ * PER_METRE));
  }

  static cpBool onBegin(cpArbiter*, cpSpace*, cpDataPointer data)
  {
    ++static_cast<World*>(data)->contacts_;
    return cpTrue;
  }

  const Mixture& mixture_;
  double step_;
  cpSpace* space_;
  cpBody* base_ = nullptr;
  std::vector<cpBody*> disks_;
  double next_y_ = 0.0;  ///< of the base at the end of the step [m]
  std::uint64_t contacts_ = 0;
};

}  // namespace

int main(int argc, char** argv)
{
  const nlohmann::json run = readRun(argc, argv);
  const Mixture mixture = run["mixture"];
  World world(mixture, run["step"], run["solid"]);
  SteppedRun<World>(world, mixture, run).run(cpVersionString);
}
