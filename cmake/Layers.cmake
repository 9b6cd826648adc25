# Where things are installed: as catkin has it or, without ROS, as CMake has it.
if(NOT RATCHET_SIEVE_ROS)
  include(GNUInstallDirs)
  set(RATCHET_SIEVE_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
  set(RATCHET_SIEVE_LIB_DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(RATCHET_SIEVE_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ratchet_sieve)
  set(RATCHET_SIEVE_SHARE_DESTINATION ${CMAKE_INSTALL_DATADIR}/ratchet_sieve)
else()
  set(RATCHET_SIEVE_BIN_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(RATCHET_SIEVE_LIB_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(RATCHET_SIEVE_INCLUDE_DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
  set(RATCHET_SIEVE_SHARE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
endif()

# Float flags stand here and nowhere else: every target of this project is built with them, so that
# the same scene gives the same bits at any optimisation level.
add_library(ratchet_sieve_flags INTERFACE)
target_compile_features(ratchet_sieve_flags INTERFACE cxx_std_17)
target_compile_options(ratchet_sieve_flags INTERFACE -Wall -Wextra -Wpedantic -ffp-contract=off)
# GCC's vectorizer of straight-line code joins products and sums into one rounding all the same, where
# the processor it builds for can.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(ratchet_sieve_flags INTERFACE -fno-tree-slp-vectorize)
endif()
# Eigen's own vectors of two doubles take store-forwarding stalls: what is written apart is read together. With
# them Fig. 8 takes 1.7 times as long (AMD EPYC, g++ 12, 2026-11-22). And in a build for a processor that has a fused
# multiply-add, Eigen uses it by itself, whatever -ffp-contract says. The alignment stays as Eigen has it by
# default, for it is seen by other packages.
target_compile_options(ratchet_sieve_flags INTERFACE -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_STATIC_ALIGN_BYTES=16)
if(RATCHET_SIEVE_SANITIZE)
  target_compile_options(ratchet_sieve_flags INTERFACE -fsanitize=${RATCHET_SIEVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(ratchet_sieve_flags INTERFACE -fsanitize=${RATCHET_SIEVE_SANITIZE})
endif()

# For programs and tests, below the directory that calls this: they read their command line or compare results, and the
# layers do the work. Optimising them takes half of the compiler's time for nothing. Only in a Release build.
macro(ratchet_sieve_optimise_less)
  add_compile_options($<$<CONFIG:Release>:-Og>)
endmacro()

# ratchet_sieve_layer(NAME SOURCES ... LINK ...): the target ratchet_sieve_NAME. It sees its own
# public headers and those of the layers it links, and no other: each layer's headers are
# reached through a directory of their own, so that a wrong include does not compile.
function(ratchet_sieve_layer layer)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  set(target ratchet_sieve_${layer})
  set(view ${PROJECT_BINARY_DIR}/layers/${layer})
  file(MAKE_DIRECTORY ${view}/ratchet_sieve)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/include/ratchet_sieve/${layer} ${view}/ratchet_sieve/${layer} SYMBOLIC)
  add_library(${target} ${ARG_SOURCES})
  # The exported name, for packages that are configured together with this one.
  add_library(ratchet_sieve::${layer} ALIAS ${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:include>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  # The flags are this project's own: packages that use the exported target do not see them.
  target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:ratchet_sieve_flags,INTERFACE_COMPILE_OPTIONS>)
  target_link_options(${target} PRIVATE $<TARGET_PROPERTY:ratchet_sieve_flags,INTERFACE_LINK_OPTIONS>)
  # What a fuzzer sees of the code that it drives.
  if(RATCHET_SIEVE_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  # A program or module that links a layer finds, where they are installed, the layers below it too.
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${layer} INSTALL_RPATH $ORIGIN)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # As shared libraries, which catkin makes, the programs need them.
  set(component engine)
  if(layer STREQUAL "ros")
    set(component ros)
  endif()
  install(TARGETS ${target} EXPORT ratchet_sieve-targets
    ARCHIVE DESTINATION ${RATCHET_SIEVE_LIB_DESTINATION} COMPONENT ${component}
    LIBRARY DESTINATION ${RATCHET_SIEVE_LIB_DESTINATION} COMPONENT ${component})
  # Static ones go into the library that sieve_run loads to write a bag, and into Python's module.
  if(RATCHET_SIEVE_ROS OR RATCHET_SIEVE_PYTHON)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
endfunction()
