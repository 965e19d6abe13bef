# A project that uses thinwall_add_image_test: pictures as they should be, not so, within limits, and not drawn at all.
cmake_minimum_required(VERSION 3.25)
project(image_test_user LANGUAGES NONE)
enable_testing()
include(${THINWALL_CMAKE}/ThinwallImageTest.cmake)

# A black and a nearly black picture of one pixel, as portable pixmaps.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/golden.ppm "P3\n1 1\n255\n10 10 10\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/drawn.ppm "P3\n1 1\n255\n10 10 13\n")
set(golden ${CMAKE_CURRENT_BINARY_DIR}/golden.ppm)
set(drawn ${CMAKE_CURRENT_BINARY_DIR}/drawn.ppm)
thinwall_add_image_test(NAME equal COMMAND ${CMAKE_COMMAND} -E copy ${golden} equal.ppm
                        OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/equal.ppm GOLDEN ${golden})
thinwall_add_image_test(NAME within COMMAND ${CMAKE_COMMAND} -E copy ${drawn} within.ppm
                        OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/within.ppm GOLDEN ${golden} LIMITS --max 3 LABELS near)
thinwall_add_image_test(NAME differs COMMAND ${CMAKE_COMMAND} -E copy ${drawn} differs.ppm
                        OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/differs.ppm GOLDEN ${golden} LIMITS --max 2)
set_tests_properties(differs PROPERTIES WILL_FAIL TRUE)
thinwall_add_image_test(NAME not_drawn COMMAND ${CMAKE_COMMAND} -E true
                        OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/none.ppm GOLDEN ${golden})
set_tests_properties(not_drawn PROPERTIES WILL_FAIL TRUE)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/of_an_earlier_run.ppm "P3\n1 1\n255\n10 10 10\n")
thinwall_add_image_test(NAME not_drawn_again COMMAND ${CMAKE_COMMAND} -E true
                        OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/of_an_earlier_run.ppm GOLDEN ${golden})
set_tests_properties(not_drawn_again PROPERTIES WILL_FAIL TRUE)
