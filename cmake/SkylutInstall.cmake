# What `cmake --install` puts where, so that find_package(skylut COMPONENTS sky fit) works: one export
# file per room, the public headers, the profiles, and skylutConfig.cmake.
include(CMakePackageConfigHelpers)
set(SKYLUT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/skylut)

function(skylut_install_room room)
  set_target_properties(skylut_${room} PROPERTIES EXPORT_NAME ${room})
  install(TARGETS skylut_${room} EXPORT skylut-${room} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT skylut-${room} NAMESPACE skylut:: DESTINATION ${SKYLUT_CMAKE_DIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/skylut/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/skylut)
endfunction()

function(skylut_install_package)
  set(SKYLUT_ROOMS_INSTALLED ${SKYLUT_ROOMS_BUILT})
  list(REMOVE_ITEM SKYLUT_ROOMS_INSTALLED options cli)
  set(SKYLUT_PROFILES_DIR ${CMAKE_INSTALL_DATADIR}/skylut/profiles)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/skylutConfig.cmake.in
    ${PROJECT_BINARY_DIR}/generated/skylutConfig.cmake
    INSTALL_DESTINATION ${SKYLUT_CMAKE_DIR} PATH_VARS SKYLUT_PROFILES_DIR)
  # Before 1.0 a new minor version may change interfaces.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/skylutConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES
      ${PROJECT_BINARY_DIR}/generated/skylutConfig.cmake
      ${PROJECT_BINARY_DIR}/generated/skylutConfigVersion.cmake
      ${PROJECT_SOURCE_DIR}/cmake/SkylutRooms.cmake
    DESTINATION ${SKYLUT_CMAKE_DIR})
  install(FILES ${PROJECT_BINARY_DIR}/generated/skylut/core/version.hpp
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/skylut/core)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/profiles/ DESTINATION ${SKYLUT_PROFILES_DIR})
endfunction()
