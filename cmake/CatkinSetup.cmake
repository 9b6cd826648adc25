# catkin, the messages and services, and the target ratchet_sieve_messages that a layer links to see
# them together with the ROS libraries.

# ROS from Debian's archive has its Python modules for the system's interpreter only: another that
# comes first on PATH (pyenv, conda) finds no catkin_pkg.
if(EXISTS "/usr/lib/python3/dist-packages/catkin_pkg")
  set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that has ROS's modules")
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that has ROS's modules")
endif()

# rosrun looks for programs below the package, but never below its build/: what is built there has its
# devel space beside it.
if(NOT CATKIN_DEVEL_PREFIX AND PROJECT_BINARY_DIR STREQUAL "${PROJECT_SOURCE_DIR}/build")
  set(CATKIN_DEVEL_PREFIX ${PROJECT_SOURCE_DIR}/devel)
endif()

set(ROS_PACKAGES
  diagnostic_msgs diagnostic_updater geometry_msgs message_runtime rosbag roscpp rosgraph_msgs
  sensor_msgs std_msgs std_srvs tf2_eigen tf2_msgs tf2_ros visualization_msgs)
find_package(catkin REQUIRED COMPONENTS ${ROS_PACKAGES})
find_package(message_generation REQUIRED)
# Of what is installed from here on: see Install.cmake. What catkin itself puts into a prefix stays outside.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME ros)

# catkin notes the environment of the tests once, as it is configured, and leaves out what does not exist
# yet: on a fresh checkout that is the directories into which the messages and libraries will be built.
file(MAKE_DIRECTORY
  ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_LIB_DESTINATION}
  ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_PYTHON_DESTINATION})
safe_execute_process(COMMAND ${GENERATE_ENVIRONMENT_CACHE_COMMAND})

include(cmake/Python.cmake)
add_message_files(FILES
  BaseSetpoint.msg
  BaseState.msg
  BinCounts.msg
  BinPurity.msg
  Command.msg
  DeckLevel.msg
  DiskCounts.msg
  DiskExit.msg
  Observation.msg
  ObservationColumn.msg
  ObservationNumber.msg
  ObservationRow.msg
  Observations.msg
  ParticleStates.msg
  Purity.msg
  SceneDescription.msg
  SeekTrial.msg
  SieveStatistics.msg
  SpeciesStatistics.msg)
add_service_files(
  FILES LockStep.srv PourBetween.srv PourDisks.srv ResetSimulation.srv SetFault.srv StepSimulation.srv)
generate_messages(DEPENDENCIES std_msgs)

catkin_package(
  INCLUDE_DIRS include
  CATKIN_DEPENDS ${ROS_PACKAGES}
  CFG_EXTRAS ratchet_sieve-extras.cmake)

add_library(ratchet_sieve_messages INTERFACE)
add_library(ratchet_sieve::messages ALIAS ratchet_sieve_messages)
target_include_directories(ratchet_sieve_messages SYSTEM INTERFACE
  $<BUILD_INTERFACE:${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION}>
  $<INSTALL_INTERFACE:${CATKIN_GLOBAL_INCLUDE_DESTINATION}>
  ${catkin_INCLUDE_DIRS})
set_target_properties(ratchet_sieve_messages PROPERTIES EXPORT_NAME messages)
target_link_libraries(ratchet_sieve_messages INTERFACE ${catkin_LIBRARIES})
add_dependencies(ratchet_sieve_messages ${PROJECT_NAME}_generate_messages_cpp)
