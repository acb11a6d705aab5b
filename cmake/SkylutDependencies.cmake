# Every outside library, in one place; tools/setup installs the Debian packages.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED CONFIG)             # small linear algebra: plane-parallel solver, fits
find_package(TBB REQUIRED CONFIG)                    # threads
find_package(fmt 9 REQUIRED CONFIG)                  # text output independent of locale
find_package(nlohmann_json 3.11 REQUIRED CONFIG)     # solver cases, table.json
find_package(tomlplusplus 3.3 REQUIRED CONFIG)       # profiles
find_package(Ceres 2.1 REQUIRED)                     # Levenberg-Marquardt fits
find_package(Imath 3.1 REQUIRED CONFIG)
find_package(OpenEXR 3.1 REQUIRED CONFIG)            # sky maps
find_package(CLI11 2.1 REQUIRED CONFIG)              # command line
pkg_check_modules(GEOGRAPHICLIB REQUIRED IMPORTED_TARGET geographiclib>=2.1)  # place
pkg_check_modules(ERFA REQUIRED IMPORTED_TARGET erfa>=2.0)                    # sun
if(SKYLUT_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
if(SKYLUT_BUILD_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
