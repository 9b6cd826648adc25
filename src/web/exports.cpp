#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "ratchet_sieve/core/choke.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/statistics/segregation.h"

/// The engine as a module of WebAssembly: functions over one simulation, and buffers that the caller reads
/// and writes in the module's memory. A buffer's address holds until the next call. engine.js calls them.
///
/// The module is compiled without exceptions, which would cost speed: what throws ends in a trap, with the
/// message as the text. The simulation can then be read, but not advanced.

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace ratchet_sieve
{
namespace
{

/// Numbers by name; a dot separates the parts of a name. NaN stands for an undefined number.
struct Readings
{
  std::string names;
  std::vector<double> values;

  void add(const std::string& name, std::optional<double> value)
  {
    names += names.empty() ? name : ' ' + name;
    values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }

  /// The fields of a described struct.
  template <typename Struct>
  void addFields(const std::string& prefix, const Struct& fields)
  {
    Fields<Struct>::each([&](const FieldInfo& field, const auto& value) { add(prefix + field.name, value); },
                         fields);
  }
};

std::string input;                     ///< a scene's definition
std::optional<Simulation> simulation;  ///< none before open()
std::string text;                      ///< the message of an error
std::vector<double> disks;             ///< per disk: the fields of DiskState, but for the mass
Readings readings;

/// Of what a link may hold.
void require(bool legal, const char* error)
{
  if (!legal)
    throw std::invalid_argument(error);
}

}  // namespace
}  // namespace ratchet_sieve

extern "C" void* __cxa_allocate_exception(std::size_t size) noexcept
{
  return std::malloc(size);
}
extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* /*type*/,
                                         void (* /*destructor*/)(void*))
{
  ratchet_sieve::text = static_cast<std::exception*>(thrown)->what();
  __builtin_trap();
}

using namespace ratchet_sieve;

/// Room for a scene's definition, in the format of SceneDefinition::archive().
EXPORT(input) char* inputBuffer(std::size_t size)
{
  input.assign(size, '\0');
  return input.data();
}

/// Pours the scene of the input. @pre the first call
/// @param feed_rate in place of that of the scene, if it has one [1/s]
EXPORT(open) void openScene(double seed, double feed_rate)
{
  SceneDefinition scene;
  StateArchive archive(std::string_view{input});
  scene.archive(archive);
  archive.requireEnd();
  scene.seed = static_cast<std::uint64_t>(seed);
  if (scene.feed.rate > 0.0)
  {
    require(feed_rate > 0.0, "the feed rate must be above 0");
    scene.feed.rate = feed_rate;
  }
  simulation.emplace(scene);
}

EXPORT(advance) void advance(double time)
{
  simulation->advanceTo(time);
}

/// @param quantity an index of COMMANDED_QUANTITIES
EXPORT(command) void command(std::size_t quantity, double setpoint)
{
  require(quantity < QUANTITIES && COMMANDED_QUANTITIES[quantity].legal.contains(setpoint),
          "a setpoint is not legal");
  simulation->command(COMMANDED_QUANTITIES[quantity].quantity, setpoint);
}

EXPORT(slew) void slew(double inclination, double frequency, double amplitude)
{
  const SlewRates rates{inclination, frequency, amplitude};
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    require(quantity.slew_rates.contains(rates.*quantity.slew_rate), "a slew rate is not legal");
  simulation->setSlewRates(rates);
}

/// @param from, to the stretch [m]; not a number: that of the scene's pour
EXPORT(pour) void pour(std::size_t species, std::size_t count, double from, double to)
{
  simulation->pour(species, count, from == from ? std::optional(Stretch{from, to}) : std::nullopt);
}

/// Reads the state into the readings and the disks.
EXPORT(read) void readState()
{
  readings = {};
  readings.add("time", simulation->time());
  readings.add("events", static_cast<double>(simulation->events()));
  readings.add("collapses", static_cast<double>(simulation->collapses().count));
  readings.addFields("base.", simulation->base());
  const std::vector<SpeciesBins> bins = simulation->bins();
  const std::vector<SpeciesMeans> means = simulation->means();
  for (std::size_t k = 0; k < bins.size(); ++k)
  {
    const std::string species = "species." + std::to_string(k) + '.';
    readings.addFields(species, bins[k]);
    readings.addFields(species, k < means.size() ? means[k] : SpeciesMeans{});
  }
  const PairSeparation separation = bestSeparation(bins);
  readings.add("separation", separation.separation);
  readings.add("quality", separation.quality());
  readings.add("processed", processedRatio(bins));
  if (const std::optional<Choke> choke = chokeOf(*simulation))
  {
    readings.add("choke.fed", choke->fed);
    readings.add("choke.left", choke->left);
    readings.add("choke.layers", choke->layers);
  }

  disks.clear();
  simulation->forEachDisk(
      [](const DiskState& disk)
      {
        Fields<DiskState>::each([](const FieldInfo& /*field*/, auto value)
                                { disks.push_back(static_cast<double>(value)); },
                                disk);
      });
}

/// The address of a buffer, and the number of its elements.
#define EXPORT_BUFFER(name, buffer)            \
  EXPORT(name) const void* name##Address()     \
  {                                            \
    return (buffer).data();                    \
  }                                            \
  EXPORT(name##_size) std::size_t name##Size() \
  {                                            \
    return (buffer).size();                    \
  }
EXPORT_BUFFER(text, text)
EXPORT_BUFFER(names, readings.names)
EXPORT_BUFFER(values, readings.values)
EXPORT_BUFFER(disks, disks)
