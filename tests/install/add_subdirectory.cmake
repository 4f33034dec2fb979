# Takes the source tree into an outside project, which fails to configure if its own flags change.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
file(REMOVE_RECURSE ${WORK})
configure_command(configure ${CMAKE_CURRENT_LIST_DIR}/add_subdirectory ${WORK} -DSTRIATE=${SOURCE} -DCMAKE_BUILD_TYPE=Release)
step("configuring the outside project" ${configure})
step("building the outside project" ${CMAKE_COMMAND} --build ${WORK} --target outside)
step("running the outside project" ${WORK}/outside)

commands_of(commands ${WORK} "add_subdirectory/outside.cpp$")
expect_no_match("${commands}" "${OWN_OPTIONS}|-O2" "Striate's options reach its users")

# Striate's layers: warnings end no other project's build, and its flags change no result.
foreach(layer base perception memory agent)
  commands_of(commands ${WORK} "^${SOURCE}/${layer}/|/striate_${layer}.dir/Unity/")
  expect_no_match("${commands}" "-Werror" "warnings in Striate are errors for others")
  string(REGEX MATCHALL "[^\n]+" lines "${commands}")
  foreach(line IN LISTS lines)
    # After the outside project's own, so that Striate's hold; position independent, for plugins.
    expect_match("${line}" "-ffast-math.*-fPIC.*-ffp-contract=off.*-fno-fast-math.*-O[12]" "Striate's options are missing")
  endforeach()
endforeach()
