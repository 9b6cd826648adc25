# Debian packages by CPack (scripts/package), one of each component: ratchet-sieve is the engine with its programs and
# Python, ros-ratchet-sieve has the nodes, messages and what other packages build on.

# The packages that a group of scripts/packages.txt needs on Debian, those whose names match, as a list of dpkg's.
function(ratchet_sieve_packages list group pattern)
  file(STRINGS ${PROJECT_SOURCE_DIR}/scripts/packages.txt names REGEX "^${group} +${pattern} ")
  list(TRANSFORM names REPLACE "^[a-z]+ +([^ ]+) .*" "\\1")
  list(JOIN names ", " names)
  set(${list} "${names}" PARENT_SCOPE)
endfunction()
ratchet_sieve_packages(PYTHON engine "python3-(numpy|pandas|yaml)")
# Plots and the search for the best setting. Debian's scipy needs a compiler: most of what is downloaded.
ratchet_sieve_packages(ANSWERS engine "python3-(matplotlib|scipy)")
ratchet_sieve_packages(OPTIMISE optimise ".*")
ratchet_sieve_packages(RUNS base "(python3-|ros-(std|vis)|rosbash).*")
ratchet_sieve_packages(BUILDS base "(catkin|ros-message|lib).*")
ratchet_sieve_packages(LIBRARIES engine "(g..|make|lib(eigen|yaml|fmt|sqlite).*|nlohmann.*|zlib.*)")
ratchet_sieve_packages(ROSTEST tests "(.*-rostest|libgtest-dev)")
ratchet_sieve_packages(RVIZ rviz ".*")

install(SCRIPT cmake/leave_engine_out.cmake)
# uPlot is in the pages of the engine's package.
file(READ LICENSE OWN)
file(READ src/page/web/uplot/LICENSE UPLOT)
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${OWN}\nuPlot (pages):\n\n${UPLOT}")
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/ratchet-sieve COMPONENT engine)
install(FILES LICENSE DESTINATION share/doc/ros-ratchet-sieve RENAME copyright)
install(FILES README.md DESTINATION share/doc/ratchet-sieve COMPONENT engine)
install(DIRECTORY docs DESTINATION share/doc/ratchet-sieve COMPONENT engine FILES_MATCHING PATTERN "*.md")

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL engine ros)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
file(STRINGS package.xml maintainer REGEX "<maintainer ")
string(REGEX REPLACE ".*email=\"(.*)\">(.*)</.*" "\\2 <\\1>" CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_DEBIAN_ENGINE_PACKAGE_NAME ratchet-sieve)
set(CPACK_COMPONENT_ENGINE_DESCRIPTION "exact simulation of a vibrating-ratchet feeder
 Hard disks on an oscillating sawtooth, which separates them: programs for one
 run, sweeps and the best settings, and the Python package.")
# The module is built for one version of Python.
math(EXPR NEXT "${PYTHON_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_ENGINE_PACKAGE_DEPENDS
  "python3 (>= 3.${PYTHON_VERSION_MINOR}), python3 (<< 3.${NEXT}), ${PYTHON}")
set(CPACK_DEBIAN_ENGINE_PACKAGE_RECOMMENDS "${ANSWERS}")
set(CPACK_DEBIAN_ENGINE_PACKAGE_SUGGESTS "${OPTIMISE}")
set(CPACK_DEBIAN_ROS_PACKAGE_NAME ros-ratchet-sieve)
set(CPACK_COMPONENT_ROS_DESCRIPTION "ROS nodes and messages of ratchet-sieve
 A live vibrating-ratchet feeder with setpoints on topics, RViz, bags and their
 analysis, and the headers and libraries of the engine.")
set(CPACK_DEBIAN_ROS_PACKAGE_DEPENDS "ratchet-sieve (= ${PROJECT_VERSION}), ${RUNS}")
set(CPACK_DEBIAN_ROS_PACKAGE_RECOMMENDS "${BUILDS}, ${LIBRARIES}, ${ROSTEST}")
set(CPACK_DEBIAN_ROS_PACKAGE_SUGGESTS "${RVIZ}")
# Python's compiled files come and go with the packages.
foreach(package ENGINE ROS)
  set(CPACK_DEBIAN_${package}_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/postinst ${PROJECT_SOURCE_DIR}/cmake/prerm)
  set(CPACK_DEBIAN_${package}_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endforeach()
include(CPack)
