#include "observe/run_observers.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

/// Counts contacts with each face and corner of a profile. A sawtooth needs none: its kinds of contacts say
/// it.
class FaceCounts final : public Observer
{
public:
  explicit FaceCounts(const BaseShape& shape)
  {
    contacts_.face_contacts.resize(shape.faces().size());
    contacts_.corner_contacts.resize(shape.faces().size());
  }

  unsigned subscriptions() const override { return CONTACTS; }

  void collided(const ContactOutcome& outcome) override
  {
    const auto index = static_cast<std::size_t>(outcome.feature.index());
    if (outcome.feature.kind() == BaseFeatureKind::FACE)
      ++contacts_.face_contacts[index];
    else if (outcome.kind == CollisionKind::APEX)
      ++contacts_.corner_contacts[index];
  }

  const FaceContacts& contacts() const { return contacts_; }

  /// @throws StateError if the state is of another profile
  void archive(StateArchive& state) override
  {
    const std::size_t faces = contacts_.face_contacts.size();
    state(contacts_);
    if (contacts_.face_contacts.size() != faces || contacts_.corner_contacts.size() != faces)
      throw StateError("it is of another scene");
  }

private:
  FaceContacts contacts_;
};

RunObservers::RunObservers(SystemState& system) : system_(system)
{
  EventLog& log = system.log();
  const SceneDefinition& scene = system.scene();
  bins_ = log.add(std::make_unique<Bins>(system));
  exits_ = log.add(std::make_unique<RecentExits>(system));
  if (scene.feed.any() && scene.boundary != Boundary::PERIODIC)
    flow_ = log.add(std::make_unique<FlowBlocks>(*bins_));
  for (const std::string& name : scene.observe)
    observables_.push_back(log.add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = log.add(std::make_unique<FaceCounts>(system.shape()));
}

FaceContacts RunObservers::faceContacts() const
{
  return faces_ != nullptr ? faces_->contacts() : FaceContacts();
}

std::vector<Observed> RunObservers::observed(double time, bool settled) const
{
  std::vector<Observed> observed;
  for (std::size_t k = 0; k < observables_.size(); ++k)
  {
    const std::unique_ptr<Observable> begun = makeObservable(system_.scene().observe[k], system_);
    begun->restart(time);
    observed.push_back((settled ? observables_[k] : begun.get())->observed(time));
  }
  return observed;
}

}  // namespace ratchet_sieve
