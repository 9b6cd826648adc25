# Everything that a user runs or builds on, where rosrun, roslaunch and find_package look for it.
if(NOT RATCHET_SIEVE_ROS)
  include(GNUInstallDirs)
  set(CATKIN_PACKAGE_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
  set(CATKIN_PACKAGE_LIB_DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(CATKIN_PACKAGE_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ratchet_sieve)
  set(CATKIN_PACKAGE_SHARE_DESTINATION ${CMAKE_INSTALL_DATADIR}/ratchet_sieve)
endif()

install(TARGETS sieve_run RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(
  TARGETS ratchet_sieve_analysis ratchet_sieve_core ratchet_sieve_live ratchet_sieve_recording ratchet_sieve_scene
    ratchet_sieve_seeking
  EXPORT ratchet_sieve-targets
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
if(RATCHET_SIEVE_ROS)
  install(
    TARGETS sieve_analyze sieve_display sieve_node sieve_replay sieve_resimulate sieve_rviz sieve_schedule sieve_seek
    RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(TARGETS ratchet_sieve_bag_plugin ratchet_sieve_rviz_windows LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
  install(TARGETS ratchet_sieve_bag ratchet_sieve_messages ratchet_sieve_ros ratchet_sieve_serialization
    EXPORT ratchet_sieve-targets
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
endif()
install(DIRECTORY include/ratchet_sieve/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(DIRECTORY config launch rviz DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(PROGRAMS scripts/plot_analysis.py scripts/plot_seek.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

# The targets for other packages: see ratchet_sieve-extras.cmake.in.
if(RATCHET_SIEVE_ROS)
  set(EXPORT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
  set(EXPORT_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
else()
  set(EXPORT_DIRECTORY ${PROJECT_BINARY_DIR})
  set(EXPORT_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}/cmake/ratchet_sieve)
  set(CONFIGURATION ${PROJECT_BINARY_DIR}/ratchet_sieveConfig.cmake)
  configure_file(cmake/ratchet_sieve-extras.cmake.in ${CONFIGURATION} @ONLY)
  install(FILES ${CONFIGURATION} DESTINATION ${EXPORT_DESTINATION})
endif()
export(EXPORT ratchet_sieve-targets NAMESPACE ratchet_sieve::
  FILE ${EXPORT_DIRECTORY}/ratchet_sieve-targets.cmake)
install(EXPORT ratchet_sieve-targets NAMESPACE ratchet_sieve:: DESTINATION ${EXPORT_DESTINATION})
