# The rooms of src/ and include/skylut/ in the order in which data flows. A room uses only rooms before it;
# this list says which, and which outside libraries each needs. The build and the installed
# skylutConfig.cmake both read it, so that nobody needs a library of a room that is not wanted.
set(SKYLUT_ROOM_ORDER
  core site profile scattering atmosphere transfer colour sky models fit table forms export compare report cases options cli)

set(SKYLUT_USES_core)
set(SKYLUT_USES_site core)
set(SKYLUT_USES_profile core)
set(SKYLUT_USES_scattering core)
set(SKYLUT_USES_atmosphere core site profile scattering)
set(SKYLUT_USES_transfer core scattering)
set(SKYLUT_USES_colour core)
set(SKYLUT_USES_sky core site profile atmosphere transfer colour)
set(SKYLUT_USES_models core profile atmosphere colour sky)
set(SKYLUT_USES_fit core colour models)
set(SKYLUT_USES_table core site profile atmosphere colour sky models fit)
set(SKYLUT_USES_forms core site profile atmosphere transfer colour sky models fit table)
set(SKYLUT_USES_export core site atmosphere colour sky models)
set(SKYLUT_USES_compare core colour models fit table)
set(SKYLUT_USES_report core scattering atmosphere sky models fit table forms export)
set(SKYLUT_USES_cases core scattering atmosphere transfer)
set(SKYLUT_USES_options core site)
set(SKYLUT_USES_cli
  core site profile scattering atmosphere transfer colour sky models fit table forms export compare report cases options)

# Libraries that whoever links the room needs too; a header-only library that only its sources use is in
# SKYLUT_BUILDS_WITH.
set(SKYLUT_PACKAGES_core fmt nlohmann_json TBB tomlplusplus)
set(SKYLUT_PACKAGES_profile tomlplusplus)
set(SKYLUT_PACKAGES_scattering tomlplusplus)
set(SKYLUT_PACKAGES_site GEOGRAPHICLIB ERFA)
set(SKYLUT_PACKAGES_fit Ceres)
set(SKYLUT_PACKAGES_forms Ceres)
set(SKYLUT_PACKAGES_export OpenEXR PNG)
set(SKYLUT_BUILDS_WITH_transfer Eigen3)
set(SKYLUT_BUILDS_WITH_sky Eigen3)
set(SKYLUT_BUILDS_WITH_fit Eigen3)
set(SKYLUT_BUILDS_WITH_forms Eigen3)
set(SKYLUT_BUILDS_WITH_options CLI11)

# skylut_rooms_needed(<variable> <rooms...>): those rooms and all that they use, in order.
function(skylut_rooms_needed variable)
  set(wanted ${ARGN})
  set(order ${SKYLUT_ROOM_ORDER})
  list(REVERSE order)
  set(needed)
  foreach(room IN LISTS order)
    if(room IN_LIST wanted)
      list(PREPEND needed ${room})
      list(APPEND wanted ${SKYLUT_USES_${room}})
    endif()
  endforeach()
  set(${variable} ${needed} PARENT_SCOPE)
endfunction()

# skylut_find(<package>): finds one of the libraries named above.
macro(skylut_find package)
  if("${package}" STREQUAL "GEOGRAPHICLIB")  # place
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(GEOGRAPHICLIB REQUIRED IMPORTED_TARGET geographiclib>=2.1)
  elseif("${package}" STREQUAL "ERFA")  # sun
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(ERFA REQUIRED IMPORTED_TARGET erfa>=2.0)
  elseif("${package}" STREQUAL "fmt")  # text output independent of locale
    find_package(fmt 9 REQUIRED CONFIG)
  elseif("${package}" STREQUAL "nlohmann_json")  # solver cases, table.json
    find_package(nlohmann_json 3.11 REQUIRED CONFIG)
  elseif("${package}" STREQUAL "TBB")  # threads
    find_package(TBB REQUIRED CONFIG)
  elseif("${package}" STREQUAL "tomlplusplus")  # profiles
    find_package(tomlplusplus 3.3 REQUIRED CONFIG)
  elseif("${package}" STREQUAL "Eigen3")  # small linear algebra: plane-parallel solver, fits
    find_package(Eigen3 3.4 REQUIRED CONFIG)
  elseif("${package}" STREQUAL "Ceres")  # Levenberg-Marquardt fits
    find_package(Ceres 2.1 REQUIRED)
  elseif("${package}" STREQUAL "OpenEXR")  # sky maps
    find_package(OpenEXR 3.1 REQUIRED CONFIG)
  elseif("${package}" STREQUAL "PNG")  # previews
    find_package(PNG 1.6 REQUIRED)
  elseif("${package}" STREQUAL "CLI11")  # command line
    find_package(CLI11 2.1 REQUIRED CONFIG)
  else()
    message(FATAL_ERROR "skylut_find: no package ${package}")
  endif()
endmacro()
