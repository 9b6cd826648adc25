#include <array>
#include <stdexcept>

#include "observe/observable.h"
#include "ratchet_sieve/statistics/block_averages.h"
#include "ratchet_sieve/statistics/time_histogram.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Something of each species in each of the two bins.
template <typename Value>
struct PerBin
{
  std::array<std::vector<Value>, 2> bins;  ///< left, right; per species

  explicit PerBin(const SystemState& system) { bins.fill(std::vector<Value>(system.scene().species.size())); }

  Value& of(const Departure& departure)
  {
    return bins[departure.exit == Exit::RIGHT_BIN ? 1 : 0][departure.species];
  }

  /// A row of each: the left bin first. row(value) -> ObservedRow
  template <typename Row>
  Observed observed(const char* name, const SystemState& system, Row&& row) const
  {
    Observed result{name, {}};
    for (std::size_t bin = 0; bin < bins.size(); ++bin)
      for (std::size_t s = 0; s < bins[bin].size(); ++s)
      {
        result.rows.push_back(row(bins[bin][s]));
        result.rows.back().place = bin == 0 ? "left" : "right";
        result.rows.back().species = system.scene().species[s].name;
      }
    return result;
  }

  void archive(StateArchive& state) { state(bins); }
};

std::vector<ObservedColumn> tableOf(const TimeHistogram& times)
{
  std::vector<ObservedColumn> table{{"from", "s", {}}, {"to", "s", {}}, {"count", "", {}}};
  times.forEachBin([&](double from, double to, double count) { addLine(table, {from, to, count}); });
  return table;
}

constexpr const char* MASS_FLOW = "mass_flow";
constexpr const char* RESIDENCE_TIMES = "residence_times";

/// The mass that falls into each bin per time [kg/s], since the end of `settle`. The error of its mean is
/// that of a correlated series (BlockAverages).
class MassFlow final : public Observable
{
public:
  explicit MassFlow(const SystemState& system) : system_(system), flows_(system) {}

  unsigned subscriptions() const override { return BLOCKS; }

  void departed(const Departure& departure) override
  {
    Flow& flow = flows_.of(departure);
    flow.mass += departure.mass;
    flow.in_block += departure.mass;
  }

  void restart(double time) override
  {
    flows_ = PerBin<Flow>(system_);
    start_ = block_start_ = runTime(time);
  }

  void endBlock(double time) override
  {
    const double length = runTime(time) - block_start_;
    block_start_ = runTime(time);
    for (std::vector<Flow>& bin : flows_.bins)
      for (Flow& flow : bin)
        flow.blocks.add(std::exchange(flow.in_block, 0.0), length);
  }

  void archive(StateArchive& state) override { state(flows_, start_, block_start_); }

  Observed observed(double time) const override
  {
    return flows_.observed(MASS_FLOW, system_,
                           [this, span = runTime(time) - start_](const Flow& flow)
                           { return row(flow, span); });
  }

private:
  struct Flow
  {
    double mass = 0.0;      ///< [kg]
    double in_block = 0.0;  ///< of it, in the present block [kg]
    BlockAverages blocks;

    void archive(StateArchive& state) { state(mass, in_block, blocks); }
  };

  double runTime(double time) const { return system_.epoch().start + time; }

  ObservedRow row(const Flow& flow, double span) const
  {
    const auto mean = span > 0.0 ? std::optional<double>(flow.mass / span) : std::nullopt;
    std::vector<ObservedColumn> table{{"time", "s", {}}, {"flow", "kg/s", {}}};
    double block_end = start_;
    for (const BlockSum& block : flow.blocks.blocks())
    {
      block_end += block.weight;
      addLine(table, {block_end, block.sum / block.weight});
    }
    return {"",
            "",
            {{"mass", "kg", flow.mass},
             {"mean", "kg/s", mean},
             {"stderr", "kg/s", mean ? flow.blocks.standardError() : std::nullopt}},
            std::move(table)};
  }

  const SystemState& system_;
  PerBin<Flow> flows_;
  double start_ = 0.0;        ///< of the counting, in the run's time [s]
  double block_start_ = 0.0;  ///< in the run's time [s]
};

/// The time that each disk spent in the machine, from its pour until it fell into a bin, of those that did so
/// since the end of `settle`. Disks that are still in the machine are not in it.
class ResidenceTimes final : public Observable
{
public:
  explicit ResidenceTimes(const SystemState& system) : system_(system), times_(system) {}

  void entered(const Disk& /*disk*/, double time) override
  {
    entered_.push_back(system_.epoch().start + time);
  }
  void departed(const Departure& departure) override
  {
    times_.of(departure).add(system_.epoch().start + departure.time - entered_[departure.slot]);
  }
  std::vector<double>* perSlot() override { return &entered_; }
  void restart(double /*time*/) override { times_ = PerBin<TimeHistogram>(system_); }
  void archive(StateArchive& state) override { state(times_); }

  Observed observed(double /*time*/) const override
  {
    return times_.observed(RESIDENCE_TIMES, system_,
                           [](const TimeHistogram& times)
                           {
                             return ObservedRow{"",
                                                "",
                                                {{"count", "", times.count()},
                                                 {"mean", "s", times.mean()},
                                                 {"standard_deviation", "s", times.standardDeviation()},
                                                 {"quantile_10", "s", times.quantile(0.1)},
                                                 {"median", "s", times.quantile(0.5)},
                                                 {"quantile_90", "s", times.quantile(0.9)}},
                                                tableOf(times)};
                           });
  }

private:
  const SystemState& system_;
  PerBin<TimeHistogram> times_;
  std::vector<double> entered_;  ///< per slot, in the run's time [s]
};

template <typename Kind>
std::unique_ptr<Observable> made(const SystemState& system)
{
  return std::make_unique<Kind>(system);
}

/// Every observable: its name, and what makes it.
constexpr struct
{
  const char* name;
  std::unique_ptr<Observable> (*make)(const SystemState& system);
} OBSERVABLES[] = {
    {RESIDENCE_TIMES, made<ResidenceTimes>},
    {HEIGHT_PROFILE, makeHeightProfile},
    {MASS_FLOW, made<MassFlow>},
};
}  // namespace

std::vector<std::string> observableNames()
{
  std::vector<std::string> names;
  for (const auto& observable : OBSERVABLES)
    names.emplace_back(observable.name);
  return names;
}

std::unique_ptr<Observable> makeObservable(const std::string& name, const SystemState& system)
{
  for (const auto& observable : OBSERVABLES)
    if (name == observable.name)
      return observable.make(system);
  throw std::invalid_argument("there is nothing to observe named " + name);
}

}  // namespace ratchet_sieve
