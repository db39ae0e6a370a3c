# SPDX-License-Identifier: GPL-3.0-or-later
# The two macros that every folder uses, and the rules that they enforce while configuring:
# a module may link only modules of a lower layer, and a third party only if it owns it.

# Layers, lowest first. See resources/docs/architecture.md.
set(SPHEREWALK_LAYER_0 base)
set(SPHEREWALK_LAYER_1 geometry jpeg http)
set(SPHEREWALK_LAYER_2 survey)
set(SPHEREWALK_LAYER_3 photo render)
set(SPHEREWALK_LAYER_4 store camera dataset practice align scene compare place report simulator)
set(SPHEREWALK_LAYER_5 bench web)
set(SPHEREWALK_LAYER_6 jobs)
set(SPHEREWALK_LAYER_7 ui)
set(SPHEREWALK_LAYER_8 app)

# Third party target -> the modules that own it.
set(SPHEREWALK_OWNER_Threads::Threads "base")
set(SPHEREWALK_OWNER_OpenSSL::Crypto "base")
set(SPHEREWALK_OWNER_nlohmann_json::nlohmann_json "base")
set(SPHEREWALK_OWNER_Eigen3::Eigen "geometry")
set(SPHEREWALK_OWNER_JPEG::JPEG "jpeg")
set(SPHEREWALK_OWNER_yaml-cpp "render;ui")
set(SPHEREWALK_OWNER_hwy::hwy "render")
set(SPHEREWALK_OWNER_exiv2lib "photo")
set(SPHEREWALK_OWNER_opencv_core "photo;align;scene;compare;bench")
set(SPHEREWALK_OWNER_opencv_imgproc "photo;align;scene;compare;bench")
set(SPHEREWALK_OWNER_spherewalk_spng "photo")
set(SPHEREWALK_OWNER_opencv_calib3d "compare")
set(SPHEREWALK_OWNER_opencv_april_tags "photo")
set(SPHEREWALK_OWNER_opencv_objdetect "photo")
set(SPHEREWALK_OWNER_opencv_features2d "align;compare")
set(SPHEREWALK_OWNER_opencv_video "align")
set(SPHEREWALK_OWNER_Ceres::ceres "align;scene;compare")
set(SPHEREWALK_OWNER_meshoptimizer::meshoptimizer "place")
set(SPHEREWALK_OWNER_SQLite::SQLite3 "store")
set(SPHEREWALK_OWNER_ZLIB::ZLIB "dataset")
set(SPHEREWALK_OWNER_CURL::libcurl "camera")
set(SPHEREWALK_OWNER_spherewalk_avahi "camera")
set(SPHEREWALK_OWNER_spherewalk_cairo "report")
set(SPHEREWALK_OWNER_spherewalk_rsvg "report")
set(SPHEREWALK_OWNER_spherewalk_three "web")
set(SPHEREWALK_OWNER_pybind11::module "app")
set(SPHEREWALK_OWNER_mujoco::mujoco "packaging/examples")
set(SPHEREWALK_OWNER_OpenGL::EGL "packaging/examples")

function(spherewalk_layer_of module result)
  foreach(level RANGE 8)
    if(module IN_LIST SPHEREWALK_LAYER_${level})
      set(${result} ${level} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "The module '${module}' stands in no layer: add it to SpherewalkModule.cmake.")
endfunction()

# spherewalk_module(NAME <module> SOURCES ... [PUBLIC <modules>] [PRIVATE <modules>]
#                   [PUBLIC_THIRD_PARTY <targets>] [THIRD_PARTY <targets>])
# makes the static library spherewalk_<module> with the headers of include/spherewalk/<module>.
function(spherewalk_module)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;PUBLIC;PRIVATE;PUBLIC_THIRD_PARTY;THIRD_PARTY")
  spherewalk_layer_of(${arg_NAME} own)
  foreach(other IN LISTS arg_PUBLIC arg_PRIVATE)
    spherewalk_layer_of(${other} theirs)
    if(NOT theirs LESS own)
      message(FATAL_ERROR "The module '${arg_NAME}' (layer ${own}) links '${other}' (layer ${theirs}): "
                          "arrows point to lower layers only, see resources/docs/architecture.md.")
    endif()
  endforeach()
  foreach(third IN LISTS arg_PUBLIC_THIRD_PARTY arg_THIRD_PARTY)
    if(NOT arg_NAME IN_LIST SPHEREWALK_OWNER_${third})
      message(FATAL_ERROR "The module '${arg_NAME}' links ${third}, which belongs to "
                          "'${SPHEREWALK_OWNER_${third}}': see resources/docs/architecture.md.")
    endif()
  endforeach()

  set(target spherewalk_${arg_NAME})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(spherewalk::${arg_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_NAME})
  if(CMAKE_VERSION VERSION_LESS 3.23)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
  else() # CI checks that each header of the set stands by itself
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS include/*.h)
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  endif()
  # The rooms of a module include each other's headers by "room/header.h".
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM arg_PUBLIC PREPEND spherewalk::)
  list(TRANSFORM arg_PRIVATE PREPEND spherewalk::)
  target_link_libraries(${target} PUBLIC spherewalk_flags ${arg_PUBLIC} ${arg_PUBLIC_THIRD_PARTY}
                        PRIVATE ${arg_PRIVATE} ${arg_THIRD_PARTY})
endfunction()

# spherewalk_test(<name> SOURCES ... LINK <modules> [THIRD_PARTY <targets>] [LABELS ...] [TIMEOUT s]
#                 [ENVIRONMENT ...])
# makes one GoogleTest program; ctest runs each of its cases by name. THIRD_PARTY: what the tested module
# owns, for tests that make their input with it.
function(spherewalk_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "SOURCES;LINK;THIRD_PARTY;LABELS;ENVIRONMENT")
  set(properties TIMEOUT 300) # on a busy machine
  if(arg_TIMEOUT)
    set(properties TIMEOUT ${arg_TIMEOUT} COST ${arg_TIMEOUT}) # what takes long begins first
  endif()
  list(TRANSFORM arg_LINK PREPEND spherewalk::)
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE spherewalk_flags spherewalk_test_support ${arg_LINK}
                        ${arg_THIRD_PARTY} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  # Most of a build's time are the tests, and their own code takes little time to run. With less optimisation GCC 14
  # takes initialised matrices for uninitialised ones.
  target_compile_options(${name} PRIVATE
    "$<$<CONFIG:Release>:-O1>" "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>")
  target_compile_definitions(${name} PRIVATE SPHEREWALK_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  foreach(property LABELS ENVIRONMENT)
    if(arg_${property})
      list(APPEND properties ${property} "${arg_${property}}")
    endif()
  endforeach()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
endfunction()
