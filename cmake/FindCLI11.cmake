# Gives the target CLI11::CLI11.
include(${CMAKE_CURRENT_LIST_DIR}/FindOrFetch.cmake)
ratchet_sieve_find_or_fetch(CLI11 1.8 https://github.com/CLIUtils/CLI11.git v2.1.2)
