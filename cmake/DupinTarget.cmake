# Applies the house's language level, warnings and sanitisers to one target.
# A function, not an INTERFACE library: linked flags libraries leave empty $<LINK_ONLY:> entries in the export.
function(dupin_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -ffp-contract=off  # sums of exact parts and bounds count on every product being rounded, whatever the processor can fuse
    -Wno-missing-field-initializers  # designated initialisers of options leave the rest defaulted
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict>  # GCC 12 sees ghosts in std::string (bug 105651)
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>  # kilobytes; GCC collects garbage from 128 MB on, for 7 % of the build
    -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual $<$<BOOL:${DUPIN_WERROR}>:-Werror>)
  if(DUPIN_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${DUPIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${DUPIN_SANITIZE})
  endif()
endfunction()

# dupin_module(TARGET [EXCEPT a.cpp ...]): the sources in this folder are the target's. The folder is the list of what
# belongs to it, so that there is no second one to keep; a new file is found by the next build.
function(dupin_module target)
  dupin_files_of(sources "*.cpp" ${ARGN})
  target_sources(${target} PRIVATE ${sources})
endfunction()

# dupin_public_headers(TARGET): all in this folder's include.
function(dupin_public_headers target)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/include/*.h)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
endfunction()

# dupin_files_of(VARIABLE PATTERN [EXCEPT name ...]): the files of this folder that match, but for some.
function(dupin_files_of variable pattern)
  cmake_parse_arguments(ARG "" "" "EXCEPT" ${ARGN})
  file(GLOB files CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${pattern})
  list(REMOVE_ITEM files "" ${ARG_EXCEPT})
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

# dupin_loads_late(TARGET NAME LIBRARY): the target loads this library when it first needs it, and is not linked with it
# (io/src/files/late_library.h); DUPIN_<NAME>_FILE is its name for the system's loader. Its package is one of
# DUPIN_LATE_PACKAGES, which our own packages depend on: dpkg-shlibdeps sees what is linked alone.
function(dupin_loads_late target name library)
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${library} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "SONAME +([^ \n]+)" soname "${said}")
  if(NOT soname)
    message(FATAL_ERROR "${library} has no name for the system's loader (SONAME)")
  endif()
  target_compile_definitions(${target} PRIVATE DUPIN_${name}_FILE="${CMAKE_MATCH_1}")
  get_filename_component(file ${library} REALPATH)
  find_program(DUPIN_DPKG_QUERY dpkg-query)
  mark_as_advanced(DUPIN_DPKG_QUERY)
  if(DUPIN_DPKG_QUERY)
    execute_process(COMMAND ${DUPIN_DPKG_QUERY} -S ${file} OUTPUT_VARIABLE said ERROR_QUIET)
    if(said MATCHES "^([^:]+):")
      set_property(GLOBAL APPEND PROPERTY DUPIN_LATE_PACKAGES ${CMAKE_MATCH_1})
    endif()
  endif()
endfunction()

# dupin_precompile(TARGET header ...): what most files of the target include is parsed once. A fifth to a half of the
# build; lint compiles without, so that no file comes to rely on it.
function(dupin_precompile target)
  if(DUPIN_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    # What ccache needs to see through it.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()

set(DUPIN_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <numeric> <optional> <span>
  <string> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <gmpxx.h>)

# What all test executables have in common, with and without CGAL's compile options; see dupin_test.
function(dupin_precompile_tests)
  foreach(name IN ITEMS dupin_test_headers dupin_test_headers_cgal)
    file(CONFIGURE OUTPUT ${name}.cpp CONTENT "")
    add_executable(${name} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)  # code for executables is position independent in its own way
    dupin_target(${name})
    dupin_test_options(${name})
    target_link_libraries(${name} PRIVATE Eigen3::Eigen GTest::gmock GTest::gtest_main)
    dupin_precompile(${name} ${DUPIN_COMMON_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)
  endforeach()
  target_link_libraries(dupin_test_headers_cgal PRIVATE CGAL::CGAL)
endfunction()

function(dupin_test_options target)
  # What tests call is what has to be fast. With -O1 GCC 12 sees ghosts in std::optional.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Dev>:-O1>
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Dev>>:-Wno-maybe-uninitialized>)
endfunction()

# dupin_test(NAME [FOLDERS folder ... [EXCEPT folder/a_test.cpp ...]] [SOURCES a.cpp ...]
#            [LIBRARIES lib ...] [LABELS slow ...] [INTERNAL room ...])
# One executable, of the tests in the folders and the sources, one ctest entry per TEST. INTERNAL makes the private
# headers of a room visible (dupin internals tests only).
function(dupin_test name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;EXCEPT;SOURCES;LIBRARIES;LABELS;INTERNAL" ${ARGN})
  foreach(folder IN LISTS ARG_FOLDERS)
    dupin_files_of(tests "${folder}/*_test.cpp" EXCEPT ${ARG_EXCEPT})
    list(APPEND ARG_SOURCES ${tests})
  endforeach()
  add_executable(${name} ${ARG_SOURCES})
  dupin_target(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} dupin_test_folder GTest::gmock GTest::gtest_main)
  dupin_test_options(${name})
  if(DUPIN_PRECOMPILE)
    set(headers dupin_test_headers)
    if("CGAL::CGAL" IN_LIST ARG_LIBRARIES)
      set(headers dupin_test_headers_cgal)
    endif()
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    target_precompile_headers(${name} REUSE_FROM ${headers})
  endif()
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  foreach(room IN LISTS ARG_INTERNAL)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/${room})
  endforeach()
  if(ARG_LABELS)
    set(properties PROPERTIES LABELS "${ARG_LABELS}")
  endif()
  # Without values: those of a table would be the bytes of its rows, addresses among them.
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 ${properties})
endfunction()

# dupin_fuzzer(NAME SOURCES a.cpp ... LIBRARIES lib ... RUNS n [INTERNAL room ...])
# See tests/support/fuzz_target.h. With libFuzzer it runs for as long as it is let; otherwise it is a slow test of n
# inputs.
function(dupin_fuzzer name)
  cmake_parse_arguments(ARG "" "RUNS" "SOURCES;LIBRARIES;INTERNAL" ${ARGN})
  if(DUPIN_BUILD_FUZZERS)
    set(main ${PROJECT_SOURCE_DIR}/tests/support/fuzz_mutator.cpp)
  else()
    set(main ${PROJECT_SOURCE_DIR}/tests/support/fuzz_driver.cpp)
  endif()
  add_executable(${name} ${ARG_SOURCES} ${main})
  dupin_target(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} dupin_test_folder)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  foreach(room IN LISTS ARG_INTERNAL)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/${room})
  endforeach()
  if(DUPIN_BUILD_FUZZERS)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  else()
    add_test(NAME Fuzzers.${name} COMMAND ${name} ${ARG_RUNS})
    set_tests_properties(Fuzzers.${name} PROPERTIES LABELS slow)
  endif()
endfunction()

# dupin_bench(NAME SOURCES a.cpp ... LIBRARIES lib ...)
# One executable per question; it compares its result with a reference before timing it. Rivals have the same allocator.
function(dupin_bench name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  dupin_target(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/bench)
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} benchmark::benchmark dupin_allocator)
endfunction()
