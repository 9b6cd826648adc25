# Gives the target nlohmann_json::nlohmann_json. Objects that keep their order came with 3.9.
# Where it is fetched it is installed with this package, whose targets link to it.
set(JSON_Install ON CACHE BOOL "")
include(${CMAKE_CURRENT_LIST_DIR}/FindOrFetch.cmake)
ratchet_sieve_find_or_fetch(nlohmann_json 3.9 https://github.com/nlohmann/json.git v3.11.2)
