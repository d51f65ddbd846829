# How every part of Osculate is compiled, and the one function that declares a floor of core/.
include(GNUInstallDirs)
include(OsculateHeaderCheck)

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # it may keep what is compiled with precompiled headers (ccache's manual, "Precompiled headers")
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The analysis is a few hundred floating-point operations; -O3 unrolls its fixed loops.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

add_library(osculate_flags INTERFACE)
target_compile_options(osculate_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion
  # sqrt as one instruction; the same digits on machines with and without fused multiply-add
  -fno-math-errno -ffp-contract=off
  # GCC takes fixed arrays that are filled and read as far as an order says for uninitialised.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  $<$<BOOL:${OSCULATE_WERROR}>:-Werror>)
if(OSCULATE_SANITIZE)
  target_compile_options(osculate_flags INTERFACE
    # without what AddressSanitizer sees as well, and alignment, which Eigen asserts of its own
    # types: they cost a third of the compilation
    -fsanitize=address,undefined -fno-sanitize=null,object-size,vptr,alignment
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(osculate_flags INTERFACE -fsanitize=address,undefined)
endif()

# Sources include "osculate/<floor>/<concept>.h" in the build tree as consumers do after installation.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/include)
file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/core ${CMAKE_BINARY_DIR}/include/osculate
  SYMBOLIC)

# osculate_floor(<name> SOURCES a.cpp ... HEADERS a.h ... [PRIVATE_HEADERS ...] [DEPENDS target ...])
# A static library osculate_<name>, exported as osculate::<name>; HEADERS are installed.
function(osculate_floor name)
  cmake_parse_arguments(FLOOR "" "" "SOURCES;HEADERS;PRIVATE_HEADERS;DEPENDS" ${ARGN})
  add_library(osculate_${name} STATIC ${FLOOR_SOURCES} ${FLOOR_HEADERS} ${FLOOR_PRIVATE_HEADERS})
  add_library(osculate::${name} ALIAS osculate_${name})
  set_target_properties(osculate_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(osculate_${name} PUBLIC cxx_std_20)
  target_include_directories(osculate_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(osculate_${name} PUBLIC ${FLOOR_DEPENDS} PRIVATE $<BUILD_INTERFACE:osculate_flags>)
  install(FILES ${FLOOR_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/osculate/${name}
    COMPONENT development EXCLUDE_FROM_ALL)
  install(TARGETS osculate_${name} EXPORT osculate
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development EXCLUDE_FROM_ALL)
  osculate_check_headers(${name} "${FLOOR_HEADERS}")
endfunction()
