#include "depth_limiter.h"

#include <sstream>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace ratchet_sieve
{
namespace
{

class DepthLimiter : public YAML::EventHandler
{
public:
  void OnDocumentStart(const YAML::Mark& mark) override
  {
    if (++documents_ > 1)
      throw YAML::ParserException(mark, "a second document; a scene must be a single one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    throw YAML::ParserException(mark, "an alias (*NAME): not allowed; write out its value");
  }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override
  {
    descend(mark);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override
  {
    descend(mark);
  }
  void OnMapEnd() override { --depth_; }

private:
  void descend(const YAML::Mark& mark)
  {
    if (++depth_ > DEEPEST_NESTING)
      throw YAML::ParserException(mark, "lists and maps nest deeper than " + std::to_string(DEEPEST_NESTING));
  }

  int depth_ = 0;
  int documents_ = 0;
};

}  // namespace

void requireShallow(const std::string& text)
{
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DepthLimiter limiter;
  while (parser.HandleNextDocument(limiter))
  {
  }
}

}  // namespace ratchet_sieve
