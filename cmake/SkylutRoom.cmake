# One static library per room, linking just the rooms and libraries that SkylutRooms.cmake and its own
# CMakeLists.txt name, so that a dependency on a later room shows up as a missing header or symbol.

# skylut_room(<room> SOURCES <files...> [PUBLIC <targets...>] [PRIVATE <targets...>] [HEADER_ONLY <targets...>])
# HEADER_ONLY: libraries that only the sources include and that leave nothing to link.
function(skylut_room room)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE;HEADER_ONLY" ${ARGN})
  add_library(skylut_${room} STATIC ${ARG_SOURCES})
  add_library(skylut::${room} ALIAS skylut_${room})
  list(TRANSFORM SKYLUT_USES_${room} PREPEND skylut:: OUTPUT_VARIABLE rooms)
  # Headers of src/ that rooms share are included as "room/name.hpp".
  target_include_directories(skylut_${room}
    PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  list(TRANSFORM ARG_HEADER_ONLY REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")
  target_link_libraries(skylut_${room}
    PUBLIC ${rooms} ${ARG_PUBLIC}
    PRIVATE ${ARG_PRIVATE} ${ARG_HEADER_ONLY} $<BUILD_INTERFACE:skylut_compile_options>)
  target_compile_features(skylut_${room} PUBLIC cxx_std_20)
  if(NOT room MATCHES "^(options|cli)$")  # the program's own
    skylut_install_room(${room})
  endif()
endfunction()

# skylut_test(<file without .cpp> <targets...>): one Google Test program per file.
function(skylut_test name)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(target ${folder}_${name})
  add_executable(${target} ${name}.cpp)
  target_link_libraries(${target} PRIVATE ${ARGN} skylut_compile_options GTest::gtest_main)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  # Tests compare the solver's floats with exact doubles: there the promotion is what is meant.
  set_target_properties(${target} PROPERTIES SKYLUT_PROMOTES ON)
  target_compile_definitions(${target} PRIVATE
    SKYLUT_TEST_PROFILES="${PROJECT_SOURCE_DIR}/profiles"
    SKYLUT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    SKYLUT_SHARED_REFERENCE="${PROJECT_SOURCE_DIR}/../shared/reference")
  add_test(NAME unit.${folder}.${name} COMMAND ${target})
endfunction()
