include(FetchContent)

# ratchet_sieve_find_or_fetch(NAME VERSION REPOSITORY TAG), for a find module: the library that is
# installed in VERSION or a later one, or else built from its sources at TAG: Ubuntu 20.04 has no
# package of some. A macro, so that NAME_FOUND reaches the caller of find_package.
macro(ratchet_sieve_find_or_fetch name version repository tag)
  find_package(${name} ${version} CONFIG QUIET)
  if(NOT ${name}_FOUND)
    FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag})
    string(TOLOWER ${name} lower_name)
    FetchContent_GetProperties(${name})
    if(NOT ${lower_name}_POPULATED)
      message(STATUS "${name} is not installed: fetching ${repository} at ${tag}")
      FetchContent_Populate(${name})
      add_subdirectory(${${lower_name}_SOURCE_DIR} ${${lower_name}_BINARY_DIR} EXCLUDE_FROM_ALL)
    endif()
    set(${name}_FOUND TRUE)
  endif()
endmacro()
