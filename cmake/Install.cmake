# Everything that a user runs or builds on, where rosrun, roslaunch and find_package look for it; the layers
# are installed as they are defined. Two components, each a Debian package (Package.cmake): `engine`, which needs no ROS,
# and `ros`, the default.
install(TARGETS sieve_run sieve_sweep RUNTIME DESTINATION ${RATCHET_SIEVE_BIN_DESTINATION} COMPONENT engine)
install(DIRECTORY config examples DESTINATION ${RATCHET_SIEVE_SHARE_DESTINATION} COMPONENT engine USE_SOURCE_PERMISSIONS)
if(RATCHET_SIEVE_ROS)
  install(
    TARGETS sieve_analyze sieve_display sieve_node sieve_resimulate
    RUNTIME DESTINATION ${RATCHET_SIEVE_BIN_DESTINATION})
  install(TARGETS ratchet_sieve_bag_plugin LIBRARY DESTINATION ${RATCHET_SIEVE_LIB_DESTINATION})
  # In the sources they are not executable: rosrun would find them twice, there and in the devel space.
  catkin_install_python(
    PROGRAMS examples/conveyor.py examples/schedule.py examples/seek.py rviz/fitted_rviz.py
    DESTINATION ${RATCHET_SIEVE_BIN_DESTINATION})
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME engine)
  catkin_install_python(PROGRAMS python/sieve_separate DESTINATION ${RATCHET_SIEVE_BIN_DESTINATION})
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME ros)
  install(TARGETS ratchet_sieve_messages EXPORT ratchet_sieve-targets)
  install(DIRECTORY launch DESTINATION ${RATCHET_SIEVE_SHARE_DESTINATION})
  install(FILES rviz/sieve.rviz DESTINATION ${RATCHET_SIEVE_SHARE_DESTINATION}/rviz)
elseif(RATCHET_SIEVE_PYTHON)
  install(PROGRAMS python/sieve_separate DESTINATION ${RATCHET_SIEVE_BIN_DESTINATION})
endif()
install(DIRECTORY include/ratchet_sieve/ DESTINATION ${RATCHET_SIEVE_INCLUDE_DESTINATION})

# The targets for other packages: see ratchet_sieve-extras.cmake.in.
if(RATCHET_SIEVE_ROS)
  set(EXPORT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${RATCHET_SIEVE_SHARE_DESTINATION}/cmake)
  set(EXPORT_DESTINATION ${RATCHET_SIEVE_SHARE_DESTINATION}/cmake)
else()
  set(EXPORT_DIRECTORY ${PROJECT_BINARY_DIR})
  set(EXPORT_DESTINATION ${RATCHET_SIEVE_LIB_DESTINATION}/cmake/ratchet_sieve)
  set(CONFIGURATION ${PROJECT_BINARY_DIR}/ratchet_sieveConfig.cmake)
  configure_file(cmake/ratchet_sieve-extras.cmake.in ${CONFIGURATION} @ONLY)
  install(FILES ${CONFIGURATION} DESTINATION ${EXPORT_DESTINATION})
endif()
export(EXPORT ratchet_sieve-targets NAMESPACE ratchet_sieve::
  FILE ${EXPORT_DIRECTORY}/ratchet_sieve-targets.cmake)
install(EXPORT ratchet_sieve-targets NAMESPACE ratchet_sieve:: DESTINATION ${EXPORT_DESTINATION})
