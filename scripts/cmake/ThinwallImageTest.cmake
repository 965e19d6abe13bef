# Adds tests that compare pictures or videos of any program with approved ones, by the thinwall program.
#
#   list(APPEND CMAKE_MODULE_PATH path/to/thinwall/scripts/cmake)
#   include(ThinwallImageTest)
#   enable_testing()
#   thinwall_add_image_test(NAME scene_from_above
#     COMMAND my_renderer --out scene.png        # draws the picture; a target's name stands for its program
#     OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/scene.png
#     GOLDEN ${CMAKE_CURRENT_SOURCE_DIR}/golden/scene.png
#     LIMITS --max 8 --mean 0.2 --flip 0.02      # as for `thinwall compare`; equal pixels when absent
#     LABELS slow)
#
# Three tests come of it, all with the label `image`: NAME_clears removes what an earlier run has left, NAME_draws runs the
# command, NAME compares what it has drawn and leaves the map of the difference beside the output (`.difference.png`).
# The target approve_NAME makes the output the golden, also the first one; it is never built by itself. THINWALL_PROGRAM
# is the program; when it is not set, scripts/thinwall beside this folder, else what PATH has.

find_program(THINWALL_PROGRAM thinwall HINTS ${CMAKE_CURRENT_LIST_DIR}/.. DOC "The thinwall program, which compares pictures")

function(thinwall_add_image_test)
  cmake_parse_arguments(PARSE_ARGV 0 TEST "" "NAME;OUTPUT;GOLDEN;WORKING_DIRECTORY" "COMMAND;LIMITS;LABELS")
  foreach(needed NAME OUTPUT GOLDEN COMMAND)
    if(NOT DEFINED TEST_${needed})
      message(FATAL_ERROR "thinwall_add_image_test: say ${needed}")
    endif()
  endforeach()
  if(DEFINED TEST_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "thinwall_add_image_test: what is \"${TEST_UNPARSED_ARGUMENTS}\"?")
  endif()
  if(NOT THINWALL_PROGRAM)
    message(FATAL_ERROR "thinwall_add_image_test: the thinwall program is not found; set THINWALL_PROGRAM to it")
  endif()
  if(NOT DEFINED TEST_WORKING_DIRECTORY)
    set(TEST_WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  endif()
  # Else a program that draws nothing would be judged by its last picture.
  add_test(NAME ${TEST_NAME}_clears COMMAND ${CMAKE_COMMAND} -E rm -f ${TEST_OUTPUT} ${TEST_OUTPUT}.difference.png)
  add_test(NAME ${TEST_NAME}_draws COMMAND ${TEST_COMMAND} WORKING_DIRECTORY ${TEST_WORKING_DIRECTORY})
  add_test(NAME ${TEST_NAME} COMMAND ${THINWALL_PROGRAM} compare ${TEST_GOLDEN} ${TEST_OUTPUT} ${TEST_LIMITS}
                                     --diff ${TEST_OUTPUT}.difference.png)
  set_tests_properties(${TEST_NAME}_clears PROPERTIES FIXTURES_SETUP ${TEST_NAME}_cleared LABELS "image;${TEST_LABELS}")
  set_tests_properties(${TEST_NAME}_draws PROPERTIES FIXTURES_REQUIRED ${TEST_NAME}_cleared
                       FIXTURES_SETUP ${TEST_NAME}_drawn LABELS "image;${TEST_LABELS}")
  set_tests_properties(${TEST_NAME} PROPERTIES FIXTURES_REQUIRED ${TEST_NAME}_drawn LABELS "image;${TEST_LABELS}")
  get_filename_component(folder ${TEST_GOLDEN} DIRECTORY)
  add_custom_target(approve_${TEST_NAME} COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
                    COMMAND ${CMAKE_COMMAND} -E copy ${TEST_OUTPUT} ${TEST_GOLDEN}
                    COMMENT "Approving ${TEST_GOLDEN}" VERBATIM)
endfunction()
