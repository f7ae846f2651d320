# Builds and runs the README's example as a consumer does. Called with -D way=installed|subdirectory.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${work}/project ${work}/run ${work}/prefix)
file(MAKE_DIRECTORY ${work}/project ${work}/run)
file(COPY ${source}/examples DESTINATION ${work}/run)
file(COPY ${CMAKE_CURRENT_LIST_DIR}/consumer/CMakeLists.txt DESTINATION ${work}/project)

# The example is the first C++ block of the README.
file(READ ${source}/README.md readme)
string(FIND "${readme}" "```cpp\n" begin)
string(SUBSTRING "${readme}" ${begin} -1 readme)
string(REGEX REPLACE "^```cpp\n(.*)$" "\\1" readme "${readme}")
string(FIND "${readme}" "```" end)
string(SUBSTRING "${readme}" 0 ${end} example)
file(WRITE ${work}/project/example.cpp "${example}")

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work}/run COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(arguments -G Ninja -S ${work}/project -B ${work}/project/build
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher}
  -D CMAKE_BUILD_TYPE=${build_type})
if(way STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix)
  run(${CMAKE_COMMAND} ${arguments} -D CMAKE_PREFIX_PATH=${work}/prefix)
else()
  # Not optimised, for the check of symbols (CMakeLists.txt), and every call with its landing pad: else that depends on
  # whether a callee that cannot throw was seen before. With the presets' environment for ccache, and precompiled headers
  # as there: without, it is the longest of all tests by far.
  set(ENV{CCACHE_NOHASHDIR} 1)
  run(${CMAKE_COMMAND} ${arguments} -D DUPIN_SOURCE=${source} -D DUPIN_WERROR=${werror} -D DUPIN_SANITIZE=${sanitize}
    -D DUPIN_PRECOMPILE=ON
    -D CMAKE_BUILD_TYPE=Debug -D "CMAKE_CXX_FLAGS_DEBUG=-O0 -fnon-call-exceptions")
endif()
run(${CMAKE_COMMAND} --build ${work}/project/build)
run(${work}/project/build/consumer)

if(NOT EXISTS ${work}/run/reducer.stl)
  message(FATAL_ERROR "the example wrote no reducer.stl")
endif()

# CGAL's headers are no business of those who use ours.
execute_process(COMMAND ninja -C ${work}/project/build -t deps CMakeFiles/consumer.dir/example.cpp.o
  OUTPUT_VARIABLE dependencies COMMAND_ERROR_IS_FATAL ANY)
if(NOT dependencies MATCHES "dupin/blends/build.h")
  message(FATAL_ERROR "no list of the headers that the example includes: ${dependencies}")
endif()
if(dependencies MATCHES "CGAL/")
  message(FATAL_ERROR "the example includes CGAL")
endif()
