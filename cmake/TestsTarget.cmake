# The target `tests`, which catkin has where it is used: it builds the tests, which `all` does not.
if(NOT TARGET tests)
  add_custom_target(tests)
endif()

# ratchet_sieve_build_with_tests(DIRECTORY): the target `tests` builds every program of the directory and
# of those below it.
function(ratchet_sieve_build_with_tests directory)
  get_property(targets DIRECTORY ${directory} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      add_dependencies(tests ${target})
    endif()
  endforeach()
  get_property(subdirectories DIRECTORY ${directory} PROPERTY SUBDIRECTORIES)
  foreach(subdirectory IN LISTS subdirectories)
    ratchet_sieve_build_with_tests(${subdirectory})
  endforeach()
endfunction()
