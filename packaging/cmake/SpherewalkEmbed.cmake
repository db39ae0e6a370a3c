# SPDX-License-Identifier: GPL-3.0-or-later
# spherewalk_embed(<source.cpp> HEADER <header> FUNCTION <namespace::function> FILES <name>=<path> ...)
# makes a source with the contents of the files. The header declares std::span<const EmbeddedFile> function(), whose EmbeddedFile has
# a name and its bytes as a std::string_view.
function(spherewalk_embed source)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER;FUNCTION" "FILES")
  string(REGEX REPLACE "=[^;]*" "" names "${arg_FILES}")
  string(REGEX REPLACE "[^;=]*=" "" paths "${arg_FILES}")
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DHEADER=${arg_HEADER} -DFUNCTION=${arg_FUNCTION} "-DFILES=${arg_FILES}"
            -P ${PROJECT_SOURCE_DIR}/packaging/cmake/embed.cmake
    DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/packaging/cmake/embed.cmake
    COMMENT "Embedding ${names}"
    VERBATIM)
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
