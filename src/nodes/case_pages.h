#pragma once

#include <string>

#include "page_arguments.h"
#include "ratchet_sieve/sweep/case.h"

namespace ratchet_sieve
{

/// Keeps the page of each case as RUN_HASH.html in a directory, which is made. @param arguments its path and
/// the size of a page @param sweep its name, for the titles @throws OutputError
OpenRecord casePages(const PageArguments& arguments, const std::string& sweep);

}  // namespace ratchet_sieve
