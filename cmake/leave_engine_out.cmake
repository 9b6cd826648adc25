# What the installation of the messages takes from the devel space beside them belongs to the engine's package.
if(CMAKE_INSTALL_COMPONENT STREQUAL "ros")
  set(python "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages/ratchet_sieve")
  file(GLOB others ${python}/*engine* ${python}/__pycache__ ${python}/*/__pycache__)
  file(REMOVE_RECURSE ${python}/none ${others})
endif()
