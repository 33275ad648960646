# embed_shaders(OUTPUT FILE…): writes a C++ file that defines sudar::view::shader_text() with the contents of the files.
# Rewritten at the next build whenever one of them changes.
function(embed_shaders OUTPUT)
  set(entries "")
  foreach(file ${ARGN})
    file(READ ${file} text)
    get_filename_component(name ${file} NAME)
    string(APPEND entries "  if (file == \"${name}\") return R\"glsl(${text})glsl\";\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
    "#include \"view/shaders.h\"\n\n#include <stdexcept>\n\nstd::string sudar::view::shader_text(const std::string& file) {\n${entries}  throw std::runtime_error(\"no shader \" + file);\n}\n")
endfunction()
