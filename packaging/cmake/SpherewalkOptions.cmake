# SPDX-License-Identifier: GPL-3.0-or-later
# What a user may switch, and the flags that every target of ours is built with.
include(FeatureSummary)
include(CMakeDependentOption)

option(SPHEREWALK_RENDER_ONLY "Build the render library and what it links, nothing else" OFF)
option(SPHEREWALK_ADAPTERS_ONLY "Build the render library and the cameras for Gazebo, ROS and Python on it, nothing else" OFF)
set(SPHEREWALK_WHOLE ON)
if(SPHEREWALK_RENDER_ONLY OR SPHEREWALK_ADAPTERS_ONLY)
  set(SPHEREWALK_WHOLE OFF)
endif()
cmake_dependent_option(SPHEREWALK_GUI "Build the desktop application (Qt 6)" ON
                       "SPHEREWALK_WHOLE" OFF)
cmake_dependent_option(SPHEREWALK_GAZEBO "Build the camera for Gazebo, where its transport is found" ON
                       "NOT SPHEREWALK_RENDER_ONLY" OFF)
cmake_dependent_option(SPHEREWALK_GAZEBO_SYSTEM "Build the camera inside of Gazebo, where Gazebo is found" ON
                       "SPHEREWALK_GAZEBO" OFF)
cmake_dependent_option(SPHEREWALK_ROS1 "Build the camera of ROS 1, where roscpp is found" ON
                       "NOT SPHEREWALK_RENDER_ONLY" OFF)
cmake_dependent_option(SPHEREWALK_DDS "Build the camera of ROS 2 that needs no ROS, where Cyclone DDS is found" ON
                       "NOT SPHEREWALK_RENDER_ONLY" OFF)
cmake_dependent_option(SPHEREWALK_RCLCPP "Build the camera of ROS 2, where rclcpp is found" ON
                       "NOT SPHEREWALK_RENDER_ONLY" OFF)
option(SPHEREWALK_HIGHWAY "Use the processor's SIMD by Highway, where Highway is found" ON)
option(SPHEREWALK_TESTS "Build the tests" ON)
option(SPHEREWALK_WERROR "Treat warnings as errors" OFF)
option(SPHEREWALK_FUZZ "Build the libFuzzer programs (needs clang)" OFF)
set(SPHEREWALK_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined or thread")

add_feature_info(desktop SPHEREWALK_GUI "the desktop application")
add_feature_info(tests SPHEREWALK_TESTS "GoogleTest suites, run by ctest")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Build type" FORCE)
endif()
# What is slow says -O3 itself, in its module's CMakeLists.txt; the rest gains nothing by it but time to compile.
if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "Flags of release builds" FORCE)
endif()
if(NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()
set_property(GLOBAL PROPERTY GLOBAL_DEPENDS_NO_CYCLES ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(spherewalk_flags INTERFACE)
target_compile_features(spherewalk_flags INTERFACE cxx_std_20)
set_target_properties(spherewalk_flags PROPERTIES EXPORT_NAME flags)
# No contraction into fused multiply-adds: the same source gives the same bits on every machine.
set(spherewalk_warnings -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    -Wcast-align -Wformat=2 -Wimplicit-fallthrough)
target_compile_options(spherewalk_flags INTERFACE
  $<BUILD_INTERFACE:-ffp-contract=off>
  $<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:${spherewalk_warnings}>>
  # A unity build includes sources, whose anonymous namespaces GCC then takes for those of a header.
  $<BUILD_INTERFACE:$<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:-Wno-subobject-linkage>>
  $<BUILD_INTERFACE:$<$<BOOL:${SPHEREWALK_WERROR}>:-Werror>>)
if(SPHEREWALK_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "SPHEREWALK_FUZZ needs clang: configure with -DCMAKE_CXX_COMPILER=clang++.")
  endif()
  target_compile_options(spherewalk_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=fuzzer-no-link>)
endif()
if(SPHEREWALK_SANITIZE)
  target_compile_options(spherewalk_flags INTERFACE
    $<BUILD_INTERFACE:-fsanitize=${SPHEREWALK_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all>)
  target_link_options(spherewalk_flags INTERFACE $<BUILD_INTERFACE:-fsanitize=${SPHEREWALK_SANITIZE}>)
endif()
