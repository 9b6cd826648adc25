# Gives the target rapidcheck. It has no releases: the commit is the one that Debian 12 packages.
include(${CMAKE_CURRENT_LIST_DIR}/FindOrFetch.cmake)
ratchet_sieve_find_or_fetch(rapidcheck "" https://github.com/emil-e/rapidcheck.git 08b5058)
