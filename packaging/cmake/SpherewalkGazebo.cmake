# SPDX-License-Identifier: GPL-3.0-or-later
# Gazebo's transport and messages, newest first, as the target spherewalk_gz: gz-transport as of Garden, which names its version until
# Ionic; or ignition-transport 11 and ignition-msgs 8 of Fortress, which Debian 12 has. SPHEREWALK_WITH_GAZEBO: whether they were found.
# Gazebo itself of the same release, as the target spherewalk_gz_sim, where it is there and SPHEREWALK_GAZEBO_SYSTEM wants it.
set(SPHEREWALK_WITH_GAZEBO OFF)

# The packages are looked for quietly: none of them has to be there.
function(spherewalk_find_gazebo transport msgs sim plugin)
  if(TARGET spherewalk_gz)
    return()
  endif()
  find_package(${transport} CONFIG QUIET)
  find_package(${msgs} CONFIG QUIET)
  if(${transport}_FOUND AND ${msgs}_FOUND)
    add_library(spherewalk_gz INTERFACE IMPORTED GLOBAL)
    target_link_libraries(spherewalk_gz INTERFACE ${transport}::${transport} ${msgs}::${msgs})
    set(SPHEREWALK_WITH_GAZEBO ON PARENT_SCOPE)
  endif()
  if(TARGET spherewalk_gz AND SPHEREWALK_GAZEBO_SYSTEM)
    find_package(${sim} CONFIG QUIET)
    find_package(${plugin} CONFIG QUIET COMPONENTS register)
    if(${sim}_FOUND AND ${plugin}_FOUND)
      add_library(spherewalk_gz_sim INTERFACE IMPORTED GLOBAL)
      target_link_libraries(spherewalk_gz_sim INTERFACE ${sim}::core ${plugin}::register)
    endif()
  endif()
endfunction()

spherewalk_find_gazebo(gz-transport gz-msgs gz-sim gz-plugin)
spherewalk_find_gazebo(gz-transport14 gz-msgs11 gz-sim9 gz-plugin3)
spherewalk_find_gazebo(gz-transport13 gz-msgs10 gz-sim8 gz-plugin2)
spherewalk_find_gazebo(gz-transport12 gz-msgs9 gz-sim7 gz-plugin2)
if(NOT TARGET spherewalk_gz)
  spherewalk_find_gazebo(ignition-transport11 ignition-msgs8 ignition-gazebo6 ignition-plugin1)
  if(TARGET spherewalk_gz)
    target_compile_definitions(spherewalk_gz INTERFACE SPHEREWALK_IGNITION)
  endif()
endif()
