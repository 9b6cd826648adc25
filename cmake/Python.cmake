# The Python package: where it is installed, and where it is found before that.
if(RATCHET_SIEVE_ROS)
  set(RATCHET_SIEVE_PYTHON_DESTINATION ${CATKIN_GLOBAL_PYTHON_DESTINATION})
  set(RATCHET_SIEVE_PYTHON_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_PYTHON_DESTINATION})
  # As catkin_python_setup() would: genpy then installs no empty __init__.py beside msg and srv. That function itself
  # installs into the prefix of the configuration, whatever `cmake --install --prefix` says.
  set(${PROJECT_NAME}_CATKIN_PYTHON_SETUP_HAS_PACKAGE_INIT TRUE)
else()
  find_package(Python3 COMPONENTS Interpreter)
  set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})
  set(RATCHET_SIEVE_PYTHON_DESTINATION lib/python3/dist-packages)
  if(Python3_FOUND)
    # Of /usr/local, Debian's Python searches the folder with the version in its name.
    set(RATCHET_SIEVE_PYTHON_DESTINATION lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages)
  endif()
  set(RATCHET_SIEVE_PYTHON_DIRECTORY ${PROJECT_BINARY_DIR}/python)
endif()

# The package as it is imported before it is installed: the sources, with what is built beside this file.
configure_file(cmake/package_init.py.in ${RATCHET_SIEVE_PYTHON_DIRECTORY}/ratchet_sieve/__init__.py @ONLY)
install(DIRECTORY python/ratchet_sieve DESTINATION ${RATCHET_SIEVE_PYTHON_DESTINATION} COMPONENT engine
  PATTERN __pycache__ EXCLUDE)
