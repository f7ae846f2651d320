# Applies the house's language level, warnings and sanitisers to one target.
# A function, not an INTERFACE library: linked flags libraries leave empty $<LINK_ONLY:> entries in the export.
function(dupin_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wno-missing-field-initializers  # designated initialisers of options leave the rest defaulted
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict>  # GCC 12 sees ghosts in std::string (bug 105651)
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>  # kilobytes; GCC collects garbage from 128 MB on, for 7 % of the build
    -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual $<$<BOOL:${DUPIN_WERROR}>:-Werror>)
  if(DUPIN_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${DUPIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${DUPIN_SANITIZE})
  endif()
endfunction()

# dupin_test(NAME SOURCES a.cpp ... [LIBRARIES lib ...] [LABELS slow ...] [INTERNAL room ...])
# One executable, one ctest entry per TEST. INTERNAL makes the private headers of a room visible (dupin internals tests only).
function(dupin_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;LABELS;INTERNAL" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  dupin_target(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main)
  # What tests call is what has to be fast. With -O1 GCC 12 sees ghosts in std::optional.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Dev>:-O1>
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Dev>>:-Wno-maybe-uninitialized>)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  foreach(room IN LISTS ARG_INTERNAL)
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/${room})
  endforeach()
  target_compile_definitions(${name} PRIVATE DUPIN_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    DUPIN_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  if(ARG_LABELS)
    set(properties PROPERTIES LABELS "${ARG_LABELS}")
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 ${properties})
endfunction()

# dupin_bench(NAME SOURCES a.cpp ... LIBRARIES lib ...)
# One executable per question; it compares its result with a reference before timing it.
function(dupin_bench name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  dupin_target(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/bench)
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} benchmark::benchmark)
endfunction()
