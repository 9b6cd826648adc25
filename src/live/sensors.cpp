#include "ratchet_sieve/live/sensors.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
constexpr double SECONDS_PER_HOUR = 3600.0;

/// Distinguishes the random numbers of the sensors: 2^64 over the golden ratio.
constexpr std::uint64_t SEED_STEP = 0x9e3779b97f4a7c15;
}  // namespace

Sensor::Sensor(std::size_t index, const SensorSettings& settings, const SceneDefinition& scene,
               double start_time)
    : info_(SENSOR_LIST[index]),
      settings_(settings),
      start_time_(start_time),
      impact_time_(scene.gravity > 0.0 ? std::sqrt(2.0 * settings.drop_height / scene.gravity) : 0.0),
      random_(scene.seed + SEED_STEP * (index + 1)),
      lag_{settings.time_constant, start_time},
      counts_(scene.species.size())
{
  if (info_.kind != SensorKind::COUNT)
    value_names_.emplace_back(info_.name);
  else
    for (const SpeciesDefinition& species : scene.species)
      value_names_.push_back(std::string(info_.name) + "." + species.name);
  sent_.values.resize(value_names_.size());
}

double Sensor::measureTime() const
{
  return start_time_ + static_cast<double>(measurements_) / settings_.rate;
}

double Sensor::nextTime() const
{
  return under_way_.empty() ? measureTime()
                            : std::min(measureTime(), under_way_.front().time + settings_.delay);
}

void Sensor::take(const ExitRecord& exit)
{
  if (exit.side != info_.side || info_.kind == SensorKind::LEVEL)
    return;
  if (info_.kind == SensorKind::COUNT)
    return count(exit);
  lag_.advanceTo(exit.time);
  lag_.input += exit.mass;
  // The impulse m sqrt(2 g h), over g, through the lag.
  if (settings_.time_constant > 0.0)
    lag_.output += exit.mass * impact_time_ / settings_.time_constant;
}

/// A counter whose dead time is not extended by what it misses (non-paralysable).
void Sensor::count(const ExitRecord& exit)
{
  const bool missed = uniform() < settings_.miss;
  const bool confused = uniform() < settings_.confusion;
  const double which = uniform();
  if (missed || exit.time < counted_until_)
    return;
  counted_until_ = exit.time + settings_.dead_time;
  std::size_t species = exit.species;
  if (const std::size_t others = counts_.size() - 1; confused && others > 0)
    species = (species + 1 + static_cast<std::size_t>(which * static_cast<double>(others))) % counts_.size();
  counts_[species] += 1.0;
}

double Sensor::noise()
{
  if (settings_.noise == 0.0)
    return 0.0;
  // Twelve uniform numbers less six: normal within 6 standard deviations, and without a function of the C
  // library, the same on every machine.
  double normal = -6.0;
  for (int k = 0; k < 12; ++k)
    normal += uniform();
  return settings_.noise * normal;
}

std::vector<double> Sensor::measured(const Simulation& simulation)
{
  if (info_.kind == SensorKind::COUNT)
    return counts_;
  if (info_.kind == SensorKind::LEVEL)
  {
    lag_.input = 0.0;
    simulation.forEachDisk(
        [&, base = simulation.base()](const DiskState& disk)
        {
          const double s = placeAlong(base, disk);
          lag_.input += s >= settings_.from && s <= settings_.to ? 1.0 : 0.0;
        });
  }
  lag_.advanceTo(measureTime());
  return {inSteps(undisturbed() - tare_ + noise(), settings_.resolution)};
}

/// What a scale or a level would show without noise and tare.
double Sensor::undisturbed() const
{
  return lag_.output + settings_.drift * (lag_.time - start_time_) / SECONDS_PER_HOUR;
}

void Sensor::read(const Simulation& simulation, const SensorObserver& send)
{
  const double now = simulation.time();
  for (; measureTime() <= now; ++measurements_)
  {
    Reading reading{measureTime(), measured(simulation)};
    if (fault_ == "stuck" && !last_.empty())
      reading.values = last_;
    last_ = reading.values;
    if (fault_ == "nan")
      reading.values = {std::numeric_limits<double>::quiet_NaN()};
    if (fault_ != "dropout")
      under_way_.push_back(std::move(reading));
  }
  for (; !under_way_.empty() && under_way_.front().time + settings_.delay <= now; under_way_.pop_front())
  {
    sent_ = under_way_.front();
    if (send)
      send(*this, sent_);
  }
}

std::vector<std::string> Sensor::faults() const
{
  if (info_.kind == SensorKind::COUNT)
    return {"none", "stuck", "dropout"};
  return {"none", "stuck", "dropout", "nan"};
}

std::vector<Sensor> makeSensors(const SensorParameters& parameters, const SceneDefinition& scene,
                                double start_time)
{
  std::vector<Sensor> sensors;
  for (std::size_t k = 0; k < SENSOR_LIST.size(); ++k)
    if (const auto settings = parameters.find(SENSOR_LIST[k].kind); settings != parameters.end())
      sensors.emplace_back(k, settings->second, scene, start_time);
  return sensors;
}

double nextTime(const std::vector<Sensor>& sensors)
{
  double next = std::numeric_limits<double>::infinity();
  for (const Sensor& sensor : sensors)
    next = std::min(next, sensor.nextTime());
  return next;
}

void readDue(std::vector<Sensor>& sensors, const Simulation& simulation, const SensorObserver& send)
{
  for (Sensor& sensor : sensors)
    sensor.read(simulation, send);
}

double placeAlong(const DriveState& base, const DiskState& disk)
{
  return (disk.x - base.horizontal_displacement) * std::cos(base.inclination) +
         (disk.y - base.displacement) * std::sin(base.inclination);
}

}  // namespace ratchet_sieve
