#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/observer.h"

namespace ratchet_sieve
{

/// Contacts of each species since the means began, independent of their order. A contact counts for each disk
/// that takes part.
class SpeciesContacts final : public Observer
{
public:
  explicit SpeciesContacts(std::size_t species) : contacts_(species) {}

  std::uint64_t of(std::size_t species) const { return contacts_[species]; }

  void take(const ContactOutcome& outcome) override
  {
    ++contacts_[outcome.species];
    if (outcome.j != ContactOutcome::BASE)
      ++contacts_[outcome.partner_species];
  }

  void add(const SpeciesContacts& more)
  {
    for (std::size_t species = 0; species < contacts_.size(); ++species)
      contacts_[species] += more.contacts_[species];
  }

  void restart(double /*time*/) override { std::fill(contacts_.begin(), contacts_.end(), 0); }

  void archive(StateArchive& state) override { state(contacts_); }

private:
  std::vector<std::uint64_t> contacts_;
};

}  // namespace ratchet_sieve
