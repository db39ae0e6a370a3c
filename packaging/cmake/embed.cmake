# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the source of spherewalk_embed(): cmake -DOUTPUT= -DHEADER= -DFUNCTION= -DFILES= -P embed.cmake
string(REGEX MATCH "^(.*)::([^:]*)$" whole "${FUNCTION}")
set(space ${CMAKE_MATCH_1})
set(function ${CMAKE_MATCH_2})
set(arrays "")
set(entries "")
set(number 0)
foreach(entry IN LISTS FILES)
  string(REGEX MATCH "^([^=]*)=(.*)$" whole "${entry}")
  set(name ${CMAKE_MATCH_1})
  file(READ ${CMAKE_MATCH_2} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND arrays "const char kFile${number}[] = {${bytes}};\n")
  string(APPEND entries "    {\"${name}\", {kFile${number}, sizeof kFile${number}}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace ${space} {\n\nnamespace {\n\n${arrays}\nconst EmbeddedFile kFiles[] = {\n${entries}};\n\n\
} // namespace\n\nstd::span<const EmbeddedFile> ${function}() {\n    return kFiles;\n}\n\n} // namespace ${space}\n")
