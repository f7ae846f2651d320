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
  run(${CMAKE_COMMAND} ${arguments} -D DUPIN_SOURCE=${source} -D DUPIN_WERROR=${werror} -D DUPIN_SANITIZE=${sanitize})
  # The library is what the project's own build has made of the same sources with the same flags: to compile it once
  # more would be the longest of all tests. Everything else is the consumer's: options, the compile line, the link line.
  run(ninja -C ${work}/project/build CMakeFiles/consumer.dir/example.cpp.o)
  foreach(room IN ITEMS kernel blends io)
    file(COPY ${build}/${room}/libdupin_${room}.a DESTINATION ${work}/project/build/dupin/${room})
  endforeach()
  execute_process(COMMAND ninja -C ${work}/project/build -t commands -s consumer
    OUTPUT_VARIABLE link COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${work}/project/build/link.sh "cd ${work}/project/build\n${link}")
  run(sh -e ${work}/project/build/link.sh)
endif()
if(NOT EXISTS ${work}/project/build/consumer)
  run(${CMAKE_COMMAND} --build ${work}/project/build)
endif()
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
