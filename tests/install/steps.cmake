# What the tests of this folder share. Both are run with -DSOURCE (of Striate), -DBUILD (its build tree),
# -DWORK (a folder of their own), -DGENERATOR, -DMAKE_PROGRAM, -DCXX and -DSANITIZE.

# step(<name> <command...>): runs it, output in STEP_OUTPUT; ends the test with the output if it fails.
function(step name)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name} failed:\n${output}")
  endif()
  set(STEP_OUTPUT "${output}" PARENT_SCOPE)
endfunction()

# configure_command(<out> <source> <build> <arguments...>): an outside project, built as Striate was.
function(configure_command out source build)
  set(flags "")
  if(SANITIZE)
    set(flags -fsanitize=${SANITIZE})
  endif()
  set(${out} ${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR} -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}
      -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${ARGN} PARENT_SCOPE)
endfunction()

# commands_of(<out> <build> <pattern>): the compile commands of the files that match.
function(commands_of out build pattern)
  file(READ ${build}/compile_commands.json database)
  string(JSON count LENGTH "${database}")
  math(EXPR last "${count} - 1")
  set(found "")
  foreach(index RANGE ${last})
    string(JSON file GET "${database}" ${index} file)
    if(file MATCHES "${pattern}")
      string(JSON command GET "${database}" ${index} command)
      string(APPEND found "${command}\n")
    endif()
  endforeach()
  if(NOT found)
    message(FATAL_ERROR "no command compiles ${pattern} in ${build}")
  endif()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

function(expect_no_match text pattern why)
  if("${text}" MATCHES "${pattern}")
    set(found "${CMAKE_MATCH_0}")
    string(SUBSTRING "${text}" 0 2000 beginning)
    message(FATAL_ERROR "${why}: \"${found}\" in\n${beginning}")
  endif()
endfunction()

function(expect_match text pattern why)
  if(NOT "${text}" MATCHES "${pattern}")
    string(SUBSTRING "${text}" 0 2000 beginning)
    message(FATAL_ERROR "${why}: no \"${pattern}\" in\n${beginning}")
  endif()
endfunction()

# Striate's own options, none of which may reach those who use it.
set(OWN_OPTIONS "-Werror|-Wpedantic|-Wshadow|-ffp-contract|-fno-semantic|cmake_pch|STRIATE_")
