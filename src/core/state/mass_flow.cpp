#include "state/mass_flow.h"

namespace ratchet_sieve
{

void MassFlow::left(const Departure& departure)
{
  const double mass = system_.grain(departure.slot).mass;
  Flow& flow = flows_.of(departure);
  flow.mass += mass;
  flow.in_block += mass;
}

void MassFlow::restart(double time)
{
  flows_.reset();
  start_ = block_start_ = runTime(time);
}

void MassFlow::endBlock(double time)
{
  const double length = runTime(time) - block_start_;
  block_start_ = runTime(time);
  flows_.forEach(
      [length](Flow& flow)
      {
        flow.blocks.add(flow.in_block, length);
        flow.in_block = 0.0;
      });
}

Observed MassFlow::observed(double time) const
{
  const double span = runTime(time) - start_;
  return flows_.observed(
      NAME, system_,
      [&](const Flow& flow)
      {
        const auto mean = span > 0.0 ? std::optional<double>(flow.mass / span) : std::nullopt;
        std::vector<ObservedColumn> table{{"time", "s", {}}, {"flow", "kg/s", {}}};
        double block_end = start_;
        for (const BlockSum& block : flow.blocks.blocks())
        {
          block_end += block.weight;
          addLine(table, {block_end, block.sum / block.weight});
        }
        return ObservedRow{"",
                           "",
                           {{"mass", "kg", flow.mass},
                            {"mean", "kg/s", mean},
                            {"stderr", "kg/s", mean ? flow.blocks.standardError() : std::nullopt}},
                           std::move(table)};
      });
}

}  // namespace ratchet_sieve
