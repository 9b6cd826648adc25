#include "ratchet_sieve/page/sweep_page.h"

#include "html_page.h"

namespace ratchet_sieve
{

void writeSweepPage(const std::string& path, const nlohmann::ordered_json& report)
{
  writePage(path, SWEEP_TEMPLATE, report.at("title").get<std::string>(), report);
}

}  // namespace ratchet_sieve
