# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's packages, one for each component that is installed. See packaging/CMakeLists.txt.

find_program(SPHEREWALK_GZIP gzip DOC "Packs manuals and the changelog")
mark_as_advanced(SPHEREWALK_GZIP)

# spherewalk_gzip(<file> <packed file>): the same bytes at any time, since neither name nor time are kept.
function(spherewalk_gzip file packed)
  get_filename_component(folder ${packed} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${SPHEREWALK_GZIP} -9nc ${file} OUTPUT_FILE ${packed} COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endfunction()

# spherewalk_debian_package(<component> NAME <package> SECTION <section> LICENCE <identifier> SUMMARY <line> DESCRIPTION <text>
#                           [EMBEDDED <text>] [MANUALS <program>...])
# The package of a component, with what Debian asks every package for: a copyright file, a changelog, and packed manuals of
# packaging/man. EMBEDDED: paragraphs of the copyright file on what the component carries along.
function(spherewalk_debian_package component)
  cmake_parse_arguments(PARSE_ARGV 1 package "" "NAME;SECTION;LICENCE;EMBEDDED;SUMMARY;DESCRIPTION" "MANUALS")
  set(made ${CMAKE_CURRENT_BINARY_DIR}/debian/${package_NAME})
  set(documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/${package_NAME})
  string(REPLACE "GPL-3.0-or-later" "GPL-3" common_licence ${package_LICENCE})
  configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/copyright.in ${made}/copyright @ONLY)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH, if that is set
  configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/changelog.in ${made}/changelog @ONLY)
  spherewalk_gzip(${made}/changelog ${made}/changelog.gz)
  install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION ${documents} COMPONENT ${component})
  foreach(program IN LISTS package_MANUALS)
    spherewalk_gzip(${PROJECT_SOURCE_DIR}/packaging/man/${program}.1 ${made}/${program}.1.gz)
    install(FILES ${made}/${program}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
  endforeach()

  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package_NAME} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${package_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${package_SUMMARY}\n${package_DESCRIPTION}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()
