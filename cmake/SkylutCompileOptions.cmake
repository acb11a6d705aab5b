# How every room, test and program is compiled.
option(SKYLUT_WERROR "Treat warnings as errors; the presets switch it on" OFF)
option(SKYLUT_HARDENING "Debian's hardening: stack protector, FORTIFY, format checks, PIE, read-only relocations" ON)
option(SKYLUT_CHECKS "Preconditions inside the code (core/check.hpp) whatever the build type" OFF)

# Static libraries that can go into a shared object (a Python module) as well as into a program.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
include(CheckPIESupported)
check_pie_supported()

add_library(skylut_compile_options INTERFACE)
target_compile_options(skylut_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wconversion -Wsign-conversion
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SKYLUT_PROMOTES>>>:-Wdouble-promotion> $<$<BOOL:${SKYLUT_WERROR}>:-Werror>)
target_compile_options(skylut_compile_options INTERFACE
  # GCC 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
  -Wno-restrict
  # Results must not depend on the machine: no contraction of a*b+c into fused operations.
  -ffp-contract=off
  # Position-independent functions may be inlined like others: nobody replaces one at load time.
  -fno-semantic-interposition)
if(SKYLUT_CHECKS)
  target_compile_definitions(skylut_compile_options INTERFACE SKYLUT_CHECKS)
endif()

if(SKYLUT_HARDENING)
  target_compile_options(skylut_compile_options INTERFACE
    -fstack-protector-strong -Wformat -Werror=format-security
    # FORTIFY needs an optimising build. Some distributions define it already.
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>)
  target_link_options(skylut_compile_options INTERFACE -Wl,-z,relro,-z,now)
endif()
