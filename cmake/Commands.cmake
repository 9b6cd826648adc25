# Programs as commands: found by their names, with completion in bash and, where help2man is there, manual pages.
find_program(HELP2MAN help2man)

# ratchet_sieve_manual(COMPONENT PAGE DEPENDS COMMAND...): the page of what the command's --help prints.
function(ratchet_sieve_manual component page depends)
  if(NOT HELP2MAN OR RATCHET_SIEVE_SANITIZE)  # a sanitized module needs another start of Python
    return()
  endif()
  set(file ${PROJECT_BINARY_DIR}/commands/${page}.1)
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${RATCHET_SIEVE_PYTHON_DIRECTORY}
      ${PROJECT_SOURCE_DIR}/cmake/manual_page ${file} ${PROJECT_VERSION} ${ARGN}
    DEPENDS ${depends} ${PROJECT_SOURCE_DIR}/cmake/manual_page VERBATIM)
  add_custom_target(manual_${page} ALL DEPENDS ${file})
  install(FILES ${file} DESTINATION share/man/man1 COMPONENT ${component})
endfunction()

# ratchet_sieve_command(COMPONENT NAME DEPENDS COMMAND...): also a link in bin/, since catkin's programs are elsewhere.
function(ratchet_sieve_command component name depends)
  if(NOT RATCHET_SIEVE_BIN_DESTINATION STREQUAL "bin")
    set(link ${PROJECT_BINARY_DIR}/commands/${name})
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/commands)
    file(CREATE_LINK ../${RATCHET_SIEVE_BIN_DESTINATION}/${name} ${link} SYMBOLIC)
    install(FILES ${link} DESTINATION bin COMPONENT ${component})
  endif()
  install(FILES src/nodes/completion.bash DESTINATION share/bash-completion/completions
    RENAME ${name} COMPONENT ${component})
  ratchet_sieve_manual(${component} ${name} ${depends} ${ARGN})
endfunction()

foreach(name IN ITEMS sieve_run sieve_sweep)
  ratchet_sieve_command(engine ${name} ${name} $<TARGET_FILE:${name}>)
endforeach()
foreach(subcommand IN ITEMS run status export report merge)
  ratchet_sieve_manual(engine sieve_sweep-${subcommand} sieve_sweep $<TARGET_FILE:sieve_sweep> ${subcommand})
endforeach()
if(RATCHET_SIEVE_PYTHON)
  ratchet_sieve_command(engine sieve_separate ratchet_sieve_engine
    ${PYTHON_EXECUTABLE} ${PROJECT_SOURCE_DIR}/python/sieve_separate)
endif()
if(RATCHET_SIEVE_ROS)
  foreach(name IN ITEMS sieve_analyze sieve_resimulate)
    ratchet_sieve_command(ros ${name} ${name} $<TARGET_FILE:${name}>)
  endforeach()
  foreach(name IN ITEMS sieve_node sieve_display)
    ratchet_sieve_manual(ros ${name} ${name} $<TARGET_FILE:${name}>)
  endforeach()
endif()
