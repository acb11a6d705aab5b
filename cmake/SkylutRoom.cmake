# One static library per room, linking just the rooms and libraries it names, so that
# a dependency on a later room shows up as a missing header or symbol.

add_library(skylut_compile_options INTERFACE)
target_compile_options(skylut_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast)
# Results must not depend on the machine: no contraction of a*b+c into fused operations.
target_compile_options(skylut_compile_options INTERFACE -ffp-contract=off)

# skylut_room(<room> SOURCES <files...> [PUBLIC <targets...>] [PRIVATE <targets...>])
function(skylut_room room)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(skylut_${room} STATIC ${ARG_SOURCES})
  add_library(skylut::${room} ALIAS skylut_${room})
  # Headers of src/ that rooms share are included as "room/name.hpp".
  target_include_directories(skylut_${room}
    PUBLIC ${PROJECT_SOURCE_DIR}/include
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(skylut_${room}
    PUBLIC ${ARG_PUBLIC}
    PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:skylut_compile_options>)
endfunction()

# skylut_test(<file without .cpp> <targets...>): one Google Test program per file.
function(skylut_test name)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(target ${folder}_${name})
  add_executable(${target} ${name}.cpp)
  target_link_libraries(${target} PRIVATE ${ARGN} skylut_compile_options GTest::gtest_main)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE
    SKYLUT_TEST_PROFILES="${PROJECT_SOURCE_DIR}/profiles"
    SKYLUT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    SKYLUT_SHARED_REFERENCE="${PROJECT_SOURCE_DIR}/../shared/reference")
  add_test(NAME unit.${folder}.${name} COMMAND ${target})
endfunction()
