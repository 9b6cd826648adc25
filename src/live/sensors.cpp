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
      lag_time_(start_time),
      counts_(scene.species.size())
{
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

/// A first-order lag: its exact solution for an input that is constant in between.
void Sensor::lagTo(double time)
{
  lagged_ = settings_.time_constant > 0.0
                ? input_ + (lagged_ - input_) * std::exp((lag_time_ - time) / settings_.time_constant)
                : input_;
  lag_time_ = time;
}

void Sensor::take(const ExitRecord& exit)
{
  if (exit.side != info_.side || info_.kind == SensorKind::LEVEL)
    return;
  if (info_.kind == SensorKind::COUNT)
    return count(exit);
  lagTo(exit.time);
  input_ += exit.mass;
  // The impulse m sqrt(2 g h), over g, through the lag.
  if (settings_.time_constant > 0.0)
    lagged_ += exit.mass * impact_time_ / settings_.time_constant;
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

double Sensor::onStretch(const Simulation& simulation) const
{
  const DriveState base = simulation.base();
  const double cosine = std::cos(base.inclination);
  const double sine = std::sin(base.inclination);
  double disks = 0.0;
  simulation.forEachDisk(
      [&](const DiskState& disk)
      {
        const double s =
            (disk.x - base.horizontal_displacement) * cosine + (disk.y - base.displacement) * sine;
        disks += s >= settings_.from && s <= settings_.to ? 1.0 : 0.0;
      });
  return disks;
}

/// With noise, in steps of the resolution.
double Sensor::shown(double value)
{
  if (settings_.noise > 0.0)
  {
    // Twelve uniform numbers less six: normal within 6 standard deviations, and without a function of the C
    // library, the same on every machine.
    double normal = -6.0;
    for (int k = 0; k < 12; ++k)
      normal += uniform();
    value += settings_.noise * normal;
  }
  return settings_.resolution > 0.0 ? std::round(value / settings_.resolution) * settings_.resolution : value;
}

std::vector<double> Sensor::measured(const Simulation& simulation)
{
  if (info_.kind == SensorKind::COUNT)
    return counts_;
  if (info_.kind == SensorKind::LEVEL)
    input_ = onStretch(simulation);
  lagTo(measureTime());
  return {shown(undisturbed() - tare_)};
}

/// What a scale or a level would show without noise and tare.
double Sensor::undisturbed() const
{
  return lagged_ + settings_.drift * (lag_time_ - start_time_) / SECONDS_PER_HOUR;
}

void Sensor::read(const Simulation& simulation,
                  const std::function<void(const Sensor&, const Reading&)>& send)
{
  const double now = simulation.time();
  while (measureTime() <= now)
  {
    Reading reading{measureTime(), measured(simulation)};
    ++measurements_;
    if (fault_ == "stuck" && !last_.empty())
      reading.values = last_;
    last_ = reading.values;
    if (fault_ == "nan")
      reading.values.assign(1, std::numeric_limits<double>::quiet_NaN());
    if (fault_ != "dropout")
      under_way_.push_back(std::move(reading));
  }
  for (; !under_way_.empty() && under_way_.front().time + settings_.delay <= now; under_way_.pop_front())
    send(*this, under_way_.front());
}

std::vector<std::string> Sensor::faults() const
{
  std::vector<std::string> names = {"none", "stuck", "dropout"};
  if (info_.kind != SensorKind::COUNT)
    names.emplace_back("nan");
  return names;
}

std::vector<Sensor> makeSensors(const SensorParameters& parameters, const Simulation& simulation)
{
  std::vector<Sensor> sensors;
  for (std::size_t k = 0; k < SENSOR_LIST.size(); ++k)
    if (const auto& settings = parameters[static_cast<std::size_t>(SENSOR_LIST[k].kind)])
      sensors.emplace_back(k, *settings, simulation.scene(), simulation.time());
  return sensors;
}

std::vector<std::string> sensedNames(const SensorParameters& parameters, const SceneDefinition& scene)
{
  std::vector<std::string> names;
  for (const SensorInfo& info : SENSOR_LIST)
  {
    if (!parameters[static_cast<std::size_t>(info.kind)])
      continue;
    if (info.kind != SensorKind::COUNT)
      names.emplace_back(info.name);
    else
      for (const SpeciesDefinition& species : scene.species)
        names.push_back(std::string(info.name) + "." + species.name);
  }
  return names;
}

double nextTime(const std::vector<Sensor>& sensors)
{
  double next = std::numeric_limits<double>::infinity();
  for (const Sensor& sensor : sensors)
    next = std::min(next, sensor.nextTime());
  return next;
}

}  // namespace ratchet_sieve
